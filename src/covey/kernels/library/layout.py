"""What crosses between Python and a flat entry: words of eight bytes, in the order of the kernel.

A float is a float64, an integer or a truth value an int64. An array is its address and its
dimensions; it is contiguous. A record is its fields, one after the other. The annotations of a
kernel say all of this, so both sides of the border follow from them.
"""

from __future__ import annotations

import ctypes
import inspect
import struct
from collections.abc import Callable, Iterator
from functools import cached_property
from itertools import groupby
from typing import Annotated, Any, NamedTuple, TypeVar, get_args, get_type_hints

import numpy as np
import numpy.typing as npt

Record = TypeVar("Record")
Annotations = dict[str, Any]
"""Annotations by what they are of: the name of a parameter, or an expression for a field."""


_ARRAY = type(Annotated[int, 1])
_NUMBERS: dict[Any, str] = {float: "float", int: "int", bool: "bool"}


class Leaf(NamedTuple):
    """A number or an array among the arguments of a kernel, or a record that keeps its words."""

    source: str  # a Python expression for it, such as "state.turns"
    kind: str  # "float", "int", "bool", the dtype of an array, or "kept"
    ndim: int = 0  # of an array

    @property
    def words(self) -> int:
        """How many words a number or an array has."""
        return 1 + self.ndim


def parameters_of(kernel: Callable[..., object]) -> Annotations:
    """Return the annotations of a kernel's parameters."""
    hints = get_type_hints(inspect.unwrap(kernel), include_extras=True)
    return {name: hint for name, hint in hints.items() if name != "return"}


def results_of(kernel: Callable[..., object]) -> list[str]:
    """Return the kinds of the numbers that a kernel returns: "float", "int" or "bool"."""
    returned = get_type_hints(inspect.unwrap(kernel))["return"]
    return [_NUMBERS[each] for each in get_args(returned) or (returned,) if each in _NUMBERS]


def leaves(annotations: Annotations, *, opened: bool = True) -> Iterator[Leaf]:
    """Yield what the annotations consist of, in the order of the words.

    A record that keeps its words is yielded whole unless it is `opened`.
    """
    for source, annotation in annotations.items():
        if isinstance(annotation, _ARRAY):
            array, ndim = get_args(annotation)
            yield Leaf(source, np.dtype(get_args(get_args(array)[1])[0]).name, ndim)
        elif annotation in _NUMBERS:
            yield Leaf(source, _NUMBERS[annotation])
        elif not is_record(annotation):
            raise TypeError(f"{source}: {annotation} can't cross the border, see kernels/arrays.py")
        elif opened or "words" not in vars(annotation):
            yield from leaves(fields_of(source, annotation), opened=opened)
        else:
            yield Leaf(source, "kept")


def is_record(annotation: Any) -> bool:
    """Return whether an annotation is that of a record, a class of named tuples."""
    return isinstance(annotation, type) and issubclass(annotation, tuple)


def fields_of(source: str, record: Any) -> Annotations:
    """Return the annotations of the fields of a record that is in `source`."""
    hints = get_type_hints(record, include_extras=True)
    return {f"{source}.{field}": hint for field, hint in hints.items()}


def words_expression(annotations: Annotations) -> tuple[str, dict[str, Any]]:
    """Return a Python expression for the words of the annotated sources, and the names it needs."""
    names: dict[str, Any] = {"join": b"".join, "address_of": address_of}
    pieces = []
    for kept, group in groupby(leaves(annotations, opened=False), lambda leaf: leaf.kind == "kept"):
        run = list(group)
        if kept:
            pieces += [f"{leaf.source}.words" for leaf in run]
        else:
            pack = f"pack_{len(pieces)}"
            names[pack] = struct.Struct("=" + "".join(map(_format_of, run))).pack
            pieces.append(f"{pack}({', '.join(map(_words_of, run))})")
    return pieces[0] if len(pieces) == 1 else f"join(({', '.join(pieces)}))", names


def _format_of(leaf: Leaf) -> str:
    return "d" if leaf.kind == "float" else leaf.words * "q"


def _words_of(leaf: Leaf) -> str:
    return f"address_of({leaf.source}), *{leaf.source}.shape" if leaf.ndim else leaf.source


_buffer: Callable[[Any], ctypes.Array[ctypes.c_char]] = (ctypes.c_char * 0).from_buffer


def address_of(array: npt.NDArray[Any]) -> int:
    """Return the address of a contiguous array's first element."""
    try:
        return ctypes.addressof(_buffer(array))
    except TypeError:  # the array is read-only, or not contiguous
        if not array.flags.c_contiguous:
            raise TypeError("a kernel takes contiguous arrays only") from None
        return array.ctypes.data


def kept(record: type[Record]) -> type[Record]:
    """Let the instances of a record keep their words; for records that live from call to call.

    The arrays of a record never change their address. A copy of the record has other arrays, so
    neither copies nor pickles take the words along.
    """
    pack: Callable[..., bytes] | None = None

    def words(self: Any) -> bytes:
        nonlocal pack
        if pack is None:
            expression, names = words_expression(fields_of("record", record))
            pack = eval(f"lambda record: {expression}", names)
        return pack(self)

    members = {
        "__doc__": record.__doc__,
        "__module__": record.__module__,
        "__qualname__": record.__qualname__,
        "__reduce__": lambda self: (type(self), tuple(self)),
        "words": cached_property(words),
    }
    return type(record.__name__, (record,), members)
