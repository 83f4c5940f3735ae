"""Every public name is there, and says what it is."""

from __future__ import annotations

import inspect
import re

import pytest

import covey


@pytest.mark.parametrize("name", covey.__all__)
def test_is_documented(name):
    value = getattr(covey, name)
    text = inspect.getdoc(value)
    assert text
    assert len(text.splitlines()[0]) > 15
    if inspect.isfunction(value):
        for parameter in inspect.signature(value).parameters:
            assert re.search(rf"\b{parameter}\b", text), f"{name} doesn't document {parameter}"


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'plam'"):
        covey.plam  # noqa: B018 the look-up is the test
