"""What the how-to page shows is run, and so is the example where its library is installed."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def test_the_how_to_page(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    page = (ROOT / "docs" / "how-to" / "learning.md").read_text()
    programs = "\n".join(re.findall(r"```python\n(.*?)```", page, re.DOTALL))
    quick = programs.replace('"hidden", render_mode', '"hidden", time_limit=0.5, render_mode')
    assert quick != programs
    names = {}
    exec(compile(quick, "learning.md", "exec"), names)
    assert names["env"].agents == []
    assert names["by_name"].reset(seed=0)[1]["guarantee"] > 0.0
    names["env"].close()


def test_the_example_trains_and_tells(capsys):
    pytest.importorskip("stable_baselines3", reason="the example needs stable-baselines3")
    example = runpy.run_path(str(ROOT / "examples" / "train_pursuer.py"))
    example["main"](steps=8192, starts=2)
    _, *rows = capsys.readouterr().out.splitlines()
    times = {row[:24].strip(): float(row.split()[-2]) for row in rows}
    shares = {row[:24].strip(): float(row.split()[-1][:-1]) for row in rows}
    assert list(times) == ["committed", "learned", "earliest interception"]
    for name, time in times.items():
        assert shares[name] == pytest.approx(100.0 * times["committed"] / time, abs=0.3)
    assert times["learned"] >= 0.9 * times["committed"]
