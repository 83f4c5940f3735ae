"""Text can be read: WCAG 2's contrast of the colours that stand on each other."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import covey.web

STYLE = (Path(covey.web.__file__).parent / "page" / "style.css").read_text()


def palette(selector):
    block = re.search(re.escape(selector) + r" \{(.*?)\}", STYLE, re.DOTALL)[1]
    return dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6});", block))


def luminance(colour):
    shares = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one, other):
    dark, light = sorted([luminance(one), luminance(other)])
    return (light + 0.05) / (dark + 0.05)


def test_contrast_by_hand():
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)


@pytest.mark.parametrize("selector", [":root", ':root[data-theme="dark"]'])
@pytest.mark.parametrize(
    ("text", "ground", "least"),
    [
        ("ink", "board", 7.0),
        ("ink", "panel", 7.0),
        ("soft", "panel", 4.5),
        ("soft", "board", 4.5),
        ("on-accent", "accent", 4.5),
        ("accent", "panel", 4.5),
        ("team", "panel", 4.5),
        ("captured", "panel", 4.5),
        ("captured", "board", 4.5),
        ("disk-edge", "board", 3.0),
    ],
)
def test_colours_part(selector, text, ground, least):
    colours = palette(selector)
    assert contrast(colours[text], colours[ground]) >= least
