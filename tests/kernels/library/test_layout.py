"""What crosses from Python to a kernel: words, in the order of the annotations."""

from __future__ import annotations

import copy
import pickle
import struct

import numpy as np
import pytest

from covey.kernels.arrays import new_workspace
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.library.entry import Entry
from covey.kernels.library.layout import address_of, leaves, parameters_of, words_expression
from covey.kernels.maximum.multistart import refine
from covey.kernels.maximum.values import minimum_over_sequences


def words_of(kernel, *arguments):
    """The words that a call of a kernel passes, 8 bytes each."""
    parameters = parameters_of(kernel)
    expression, names = words_expression(parameters)
    return eval(f"lambda {', '.join(parameters)}: {expression}", names)(*arguments)


def test_words_by_hand():
    evaders, turns, sequence = np.zeros((3, 5)), np.zeros(3), np.zeros(3, np.int64)
    memory = new_workspace(3)
    words = words_of(
        minimum_over_sequences,
        evaders,
        turns,
        Pursuit(1.0, 2.0, 3.0, 4.0, 5.0),
        True,
        6.0,
        sequence,
        memory,
    )
    expected = struct.pack("=qqqqqdddddqdqq", evaders.ctypes.data, 3, 5, turns.ctypes.data, 3,
                           1.0, 2.0, 3.0, 4.0, 5.0, 1, 6.0, sequence.ctypes.data, 3)  # fmt: skip
    assert words == expected + memory.words


@pytest.mark.parametrize("kernel", [minimum_over_sequences, refine])
def test_a_record_that_keeps_its_words_has_those_of_its_fields(kernel):
    opened = sum(leaf.words for leaf in leaves(parameters_of(kernel)))
    memory = new_workspace(3)
    fields = [value for value in (*memory, *memory.walks) if isinstance(value, np.ndarray)]
    assert len(memory.words) == 8 * (4 + sum(1 + field.ndim for field in fields))
    assert opened > len(memory.words) // 8


def test_copies_do_not_take_the_words_along():
    memory = new_workspace(2)
    words = memory.words
    for other in (copy.deepcopy(memory), pickle.loads(pickle.dumps(memory))):
        assert type(other) is type(memory)
        assert other.words != words
        assert other.words[32:40] == struct.pack("=q", other.carved.ctypes.data)
    assert memory._replace(size=1).words != words


def test_addresses():
    array = np.arange(6.0).reshape(2, 3)
    assert address_of(array) == array.ctypes.data
    array.flags.writeable = False
    assert address_of(array) == array.ctypes.data
    assert address_of(array[1:]) == array.ctypes.data + 24
    with pytest.raises(TypeError, match="contiguous"):
        address_of(array[:, 1:])


def test_what_cannot_cross_is_named():
    def kernel(text: str) -> None:
        """No kernel at all."""

    with pytest.raises(TypeError, match="text: <class 'str'> can't cross"):
        Entry(kernel)("")
