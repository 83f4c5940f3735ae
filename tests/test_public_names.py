"""Every public name is there, and says what it is."""

from __future__ import annotations

import ast
import inspect
import re
from importlib import import_module
from pathlib import Path

import pytest

import covey
from covey import instances, scenarios, studies, views


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


@pytest.mark.parametrize("package", [covey, instances, scenarios, studies, views])
def test_the_stub_the_rooms_and_what_is_loaded_agree(package):
    stub = ast.parse(Path(package.__file__).with_suffix(".pyi").read_text())
    imports = [each for each in stub.body if isinstance(each, ast.ImportFrom)]
    rooms = {alias.asname: each.module for each in imports for alias in each.names}
    assert package.__all__ == dir(package) == sorted(rooms)
    for name, room in rooms.items():
        module = import_module(f"{package.__name__}.{room}")
        assert name in getattr(module, "__all__", [name])  # a single file has no such list
        assert getattr(package, name) is getattr(module, name)
