"""Tables for pandas, which is installed by whoever wants it."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from covey.model import InputError


def data_frame(columns: Any) -> Any:
    """Return a pandas data frame of columns by their names.

    Raises
    ------
    InputError
        If pandas isn't installed.
    """
    return _pandas().DataFrame(columns)


def frame_of_table(table: Any) -> Any:
    """Return a pandas data frame of an Arrow table; raises as `data_frame`."""
    _pandas()
    return table.to_pandas()


def _pandas() -> Any:
    try:
        return import_module("pandas")
    except ImportError:
        raise InputError("to_pandas needs pandas: pip install pandas") from None
