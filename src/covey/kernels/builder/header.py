"""The entries as a header of C: what each does, its words and its results.

`python -m covey.kernels.builder.header` prints it; docs/reference/covey.h is what it printed.
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from textwrap import indent
from typing import Any

import covey.kernels
from covey.kernels.library.entry import Entry, symbol_of
from covey.kernels.library.layout import (
    Annotations,
    Leaf,
    fields_of,
    is_record,
    leaves,
    parameters_of,
    results_of,
)

_ABOUT = """\
/* The entries of covey's compiled kernels.

   An entry takes a pointer to its words, eight bytes each, and a pointer to its results. It
   returns 0; anything else is a defect. An array is contiguous; behind its address stand its
   dimensions. A record is its fields, one after the other. The caller owns all memory. An entry
   writes to its results and to the arrays that it modifies in place, and keeps no pointer. It may
   run in several threads at a time if they share no array that is modified. Angles are radians;
   lengths and times are in any consistent unit. Truth values are 0 or 1.

   Written by `python -m covey.kernels.builder.header`. */

#include <stdint.h>
"""
_NUMBERS = {"float": "double", "int": "int64_t", "bool": "int64_t"}
_ITEMS = {"float64": "double", "float32": "float", "int64": "int64_t", "int32": "int32_t"}


def entries() -> list[Entry]:
    """Return all entries, by name."""
    found: dict[str, Entry] = {}
    for module in pkgutil.walk_packages(covey.kernels.__path__, "covey.kernels."):
        if not module.name.startswith("covey.kernels.builder"):
            members = vars(importlib.import_module(module.name)).values()
            found |= {symbol_of(each): each for each in members if isinstance(each, Entry)}
    return [found[symbol] for symbol in sorted(found)]


def header() -> str:
    """Return the header."""
    return "\n".join([_ABOUT, *map(_declaration, entries())])


def _declaration(kernel: Callable[..., Any]) -> str:
    symbol, results = symbol_of(kernel), results_of(kernel)
    words = list(_members(parameters_of(kernel), {}))
    values = [f"{_NUMBERS[kind]} value_{k};" for k, kind in enumerate(results)]
    return "\n".join(
        [
            f"/* {indent(inspect.getdoc(kernel) or '', '   ').strip()} */",
            *_struct(f"{symbol}_words", words),
            *(_struct(f"{symbol}_results", values) if values else []),
            f"int64_t {symbol}(const struct {symbol}_words *words, "
            f"{f'struct {symbol}_results' if values else 'void'} *results);\n",
        ]
    )


def _struct(name: str, members: list[str]) -> list[str]:
    return [f"struct {name} {{", *(f"    {member}" for member in members), "};"]


def _members(annotations: Annotations, comments: dict[str, str]) -> Iterator[str]:
    """Yield a line for each number and array, with the comment that stands beside a field."""
    for source, annotation in annotations.items():
        if is_record(annotation):
            yield from _members(fields_of(source, annotation), _comments(annotation))
        else:
            (leaf,) = leaves({source: annotation})
            comment = comments.get(source.rpartition(".")[2])
            yield _member(leaf) + (f" /* {comment} */" if comment else "")


def _member(leaf: Leaf) -> str:
    name = leaf.source.replace(".", "_")
    if not leaf.ndim:
        return f"{_NUMBERS[leaf.kind]} {name};"
    dimensions = ", ".join(f"{name}_{axis}" for axis in range(leaf.ndim))
    return f"{_ITEMS[leaf.kind]} *{name}; int64_t {dimensions};"


def _comments(record: Any) -> dict[str, str]:
    """Return the comments beside the fields of a record, by field."""
    return dict(re.findall(r"^    (\w+): .*#  ?(.+)$", inspect.getsource(record), re.MULTILINE))


if __name__ == "__main__":
    print(header())
