"""Other rooms call kernels through entries; what crosses is words, and few numbers come back."""

from __future__ import annotations

import ast
import importlib
from pathlib import Path

import pytest

import covey

PACKAGE = Path(covey.__file__).parent
SCALARS = {"float", "int", "bool", "None"}

AS_PYTHON = {
    "add",
    "contains",
    "elapsed_value",
    "first_contact",
    "forget",
    "insert",
    "is_better",
    "is_due",
    "is_over",
    "log_capture",
    "moves",
    "remove",
}
"""Kernels that other rooms call as plain Python: each is a few lines, called once in a while."""


def imported_names():
    """Every name that another room imports from a kernel's file, as (module, name)."""
    found = set()
    for source in PACKAGE.rglob("*.py"):
        if PACKAGE / "kernels" in source.parents:
            continue
        for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("covey.kernels"):
                found |= {(node.module, alias.name) for alias in node.names}
    return sorted(found)


def kernels_called():
    """The kernels among them: name, decorator, and what the function is annotated to return."""
    for module, name in imported_names():
        source = Path(importlib.import_module(module).__file__).read_text(encoding="utf-8")
        for node in ast.parse(source).body:
            if isinstance(node, ast.FunctionDef) and node.name == name and node.decorator_list:
                yield name, ast.unparse(node.decorator_list[0]), ast.unparse(node.returns)


@pytest.mark.parametrize(("name", "decorator", "returned"), list(kernels_called()))
def test_python_calls_entries_which_return_numbers(name, decorator, returned):
    assert decorator == ("compiled" if name in AS_PYTHON else "entry")
    assert set(returned.removeprefix("tuple[").removesuffix("]").split(", ")) <= SCALARS


def test_there_are_kernels_to_look_at():
    assert len(list(kernels_called())) > 30
