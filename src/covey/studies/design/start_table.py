"""Starts from a file: a table in CSV or Parquet with a row for each evader of each start."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from covey.model import InputError
from covey.model.angles import away_from
from covey.model.validation import Floats
from covey.simulation.parquet import read_table


@dataclass(frozen=True, eq=False)
class Starts:
    """Consecutive starts, one row an evader.

    Attributes
    ----------
    rows : numpy.ndarray
        (R, 3) x, y, heading of each evader, start after start.
    begins : tuple of int
        Row at which each start begins, and the number of rows.
    first : int
        Number of the first start.
    """

    rows: Floats
    begins: tuple[int, ...]
    first: int = 0

    def __len__(self) -> int:
        """Number of starts."""
        return len(self.begins) - 1

    @property
    def smallest_team(self) -> int:
        """Evaders in the smallest start."""
        return int(np.diff(self.begins).min())

    def draw(self, start: int, count: int, generator: np.random.Generator) -> tuple[Floats, Floats]:  # noqa: ARG002 the protocol
        """Return positions and headings of the first `count` evaders of a start."""
        row = self.begins[start - self.first]
        rows = self.rows[row : row + count]
        return rows[:, :2], rows[:, 2]

    def only(self, first: int, last: int) -> Starts:
        """Keep the starts from `first` up to `last`: what a worker needs of a long file."""
        begins = self.begins[first - self.first : last - self.first + 1]
        rows = self.rows[begins[0] : begins[-1]]
        return Starts(rows, tuple(row - begins[0] for row in begins), first)

    def describe(self) -> dict[str, Any]:
        """Return how many there are."""
        return {"name": "starts", "count": len(self)}


@dataclass(frozen=True)
class FromFile:
    """Starts from a file.

    Parameters
    ----------
    path
        Ends in .csv or .parquet. Columns start (numbered from 0), x, y and, if they are given,
        heading (radians). Without headings the evaders fly straight away from the pursuer, which
        is at the origin. A team takes the first evaders of its start.

    Raises
    ------
    InputError
        If the file can't be read, or lacks a column or a start.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> from covey import studies
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "starts.csv"
    ...     with file.open("w") as table:
    ...         print("start,x,y", "0,0.3,0.1", "0,-0.2,0.4", sep=chr(10), file=table)
    ...     sampler = studies.FromFile(file)
    ...
    """

    path: str

    def __post_init__(self) -> None:
        """Read the file at once, so that its mistakes are told before any work."""
        self.read  # noqa: B018

    @cached_property
    def read(self) -> tuple[str, Starts]:
        """The file's digest, and its starts."""
        file = Path(self.path)
        try:
            digest = hashlib.sha256(file.read_bytes()).hexdigest()
        except OSError as error:
            raise InputError(f"{file}: can't be read: {error.strerror}") from error
        numbers, rows = _columns(file)
        order = np.argsort(numbers, kind="stable")
        found, begins = np.unique(numbers[order], return_index=True)
        if len(found) == 0 or found.tolist() != list(range(len(found))):
            came = found[:6].tolist()
            raise InputError(f"{file}: expected starts numbered 0, 1, 2, ..., got {came}")
        return digest, Starts(rows[order], (*begins.tolist(), len(rows)))

    @property
    def all(self) -> Starts:
        """All starts of the file."""
        return self.read[1]

    def draw(self, start: int, count: int, generator: np.random.Generator) -> tuple[Floats, Floats]:
        """Return positions and headings of the first `count` evaders of a start."""
        return self.all.draw(start, count, generator)

    def describe(self) -> dict[str, Any]:
        """Return name and parameters; the digest tells whether the file has changed."""
        return {"name": "file", "path": self.path, "sha256": self.read[0]}


def _columns(file: Path) -> tuple[Floats, Floats]:
    import pyarrow as pa
    import pyarrow.csv

    readers = {".csv": pyarrow.csv.read_csv, ".parquet": read_table}
    if file.suffix not in readers:
        raise InputError(f"{file}: expected a name that ends in .csv or .parquet")
    try:
        table = readers[file.suffix](file)
        names = [name for name in ("start", "x", "y", "heading") if name in table.column_names]
        columns = {name: table[name].to_numpy().astype(np.float64) for name in names}
    except (pa.ArrowException, OSError, ValueError) as error:
        raise InputError(f"{file}: expected a table of numbers: {error}") from error
    missing = [name for name in ("start", "x", "y") if name not in columns]
    if missing:
        raise InputError(
            f"{file}: expected columns start, x, y, and perhaps heading; "
            f"{', '.join(missing)} missing"
        )
    positions = np.column_stack([columns["x"], columns["y"]])
    rows = np.column_stack([positions, columns.get("heading", away_from((0.0, 0.0), positions))])
    if not np.isfinite(rows).all():
        raise InputError(f"{file}: expected finite numbers everywhere")
    return columns["start"], rows
