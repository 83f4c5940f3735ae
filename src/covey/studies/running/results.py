"""The results of a study, read from their folder."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cached_property
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

from covey.model import InputError
from covey.model.display import html_facts
from covey.model.units import Units, counted, titled, units_with
from covey.simulation.data_frame import frame_of_table
from covey.studies.design.case import GRID, UNITS_OF
from covey.studies.running.manifest import NAME, extent_of, read_manifest
from covey.studies.running.parts import DamagedPartError, read_part
from covey.studies.running.result_files import kinds, part_files
from covey.studies.running.tables import GAMES, TRAJECTORIES, described_text, labels
from covey.studies.statistics import Moments, moments_of

if TYPE_CHECKING:
    import pyarrow as pa


class StudyResult:
    """The games of a study that have been played so far.

    Attributes
    ----------
    folder : pathlib.Path
        Folder of the results. Its `games/` is a Parquet data set that any reader of Parquet opens.
    manifest : dict
        Study, seed, versions, machine.
    study : dict
        The study with the keys and values of a study file.
    failures : tuple of str
        A line for each chunk that could not be played in the last run.

    Examples
    --------
    >>> import tempfile
    >>> import covey
    >>> study = covey.Study(starts=3, team_size=2, update_time=0.1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     games = covey.run_study(study, folder, workers=1).to_pandas()
    ...
    >>> len(games)  # three starts, each hidden and visible
    6
    """

    def __init__(
        self, folder: Path, manifest: dict[str, Any], failures: tuple[str, ...] = ()
    ) -> None:
        self.folder, self.manifest, self.failures = folder, manifest, failures

    def __repr__(self) -> str:
        """Return the folder, and how many games the study has, in one line."""
        return f"StudyResult({str(self.folder)!r}, {counted(self.manifest['games'], 'game')})"

    def _repr_html_(self) -> str:
        grid = self.study["grid"]
        return html_facts(
            repr(self), {titled(name, self.unit_of(name)): grid[name] for name in grid}
        )

    @property
    def study(self) -> dict[str, Any]:
        """The study with the keys and values of a study file."""
        described: dict[str, Any] = self.manifest["study"]
        return described

    @property
    def cases(self) -> list[dict[str, Any]]:
        """The combinations of the grid by their numbers, the last field fastest."""
        values = (self.study["grid"][name] for name in GRID)
        return [dict(zip(GRID, combination, strict=True)) for combination in product(*values)]

    def text_of(self, name: str, value: Any) -> str:
        """Return a value of a field of the grid as it was typed: "pi/2", not 1.571.

        Of a strategy or an objective that `summary` describes, the name, if no other has the same.
        """
        typed = self.manifest["typed"].get(name)
        if typed is not None:
            return str(typed[self.study["grid"][name].index(value)])
        given = self.study["grid"][name]
        if isinstance(given[0], dict):
            return dict(zip(map(described_text, given), labels(given), strict=True))[value]
        return f"{value:.4g}" if isinstance(value, float) else str(value)

    @property
    def units(self) -> Units:
        """What tables and pictures write beside lengths, times, speeds and turn rates."""
        return units_with(self.study["unit"])

    def unit_of(self, name: str) -> str:
        """Return the unit of a field of the grid, "" if none is known.

        Turn rates that were typed as angles are shown as they were typed, in degrees for example.
        """
        if name not in UNITS_OF or name in self.manifest["typed"]:
            return ""
        unit: str = getattr(self.units, UNITS_OF[name])
        return unit

    def case_number(self, **fields: Any) -> int:
        """Return the number of the only case with these fields.

        Parameters
        ----------
        fields
            Values as in `study["grid"]`: `team_size=3, sensing="hidden"`.

        Raises
        ------
        InputError
            If no case, or more than one, has these fields.
        """
        found = [
            number
            for number, case in enumerate(self.cases)
            if all(case[name] == value for name, value in fields.items())
        ]
        if len(found) != 1:
            wanted = ", ".join(f"{name} = {value}" for name, value in fields.items())
            raise InputError(f"study: expected one case with {wanted}, got {len(found)}")
        return found[0]

    @property
    def is_complete(self) -> bool:
        """Whether all chunks have been played, and all their files are there."""
        count = self.manifest["parts"]["count"]
        tables = kinds(self.study["trajectories"])
        return all(len(part_files(self.folder, kind, count)) == count for kind in tables)

    @property
    def games(self) -> pa.Table:
        """The table of all games, one row a game, in the order of their numbers."""
        import pyarrow as pa

        return pa.concat_tables(self.parts())

    def to_pandas(self) -> Any:
        """Return all games as a pandas data frame; pandas must be installed."""
        return frame_of_table(self.games)

    def parts(self) -> Iterator[pa.Table]:
        """Return the table of games part by part, for studies larger than the memory."""
        return self._tables(GAMES)

    def trajectories(self) -> Iterator[pa.Table]:
        """Return the trajectories of the games part by part; none if they were not stored."""
        return self._tables(TRAJECTORIES)

    def _tables(self, kind: str) -> Iterator[pa.Table]:
        count = self.manifest["parts"]["count"]
        for number, path in part_files(self.folder, kind, count).items():
            try:
                yield read_part(path.read_bytes(), kind, extent_of(self.manifest, number))
            except DamagedPartError as error:
                raise InputError(
                    f"{path}: the part is damaged: {error}; run the study again, which plays it "
                    "anew"
                ) from error

    @cached_property
    def moments(self) -> Moments:
        """Means and covariances of the survival times in all cases."""
        return moments_of(self.parts(), int(self.manifest["cases"]))

    @cached_property
    def values(self) -> Moments:
        """Means and covariances of the objective's values in all cases."""
        return moments_of(self.parts(), int(self.manifest["cases"]), "value")


def load_study(folder: str | os.PathLike[str]) -> StudyResult:
    """Load the results of a study.

    Parameters
    ----------
    folder
        Folder that `run_study` or `covey study` wrote to. The run may still be going on.

    Returns
    -------
    StudyResult
        `.games` is the table of all games; `.study` and `.manifest` describe them.

    Raises
    ------
    InputError
        If the folder holds no study. Its parts are checked when they are read.

    Examples
    --------
    >>> import tempfile
    >>> import covey
    >>> study = covey.Study(starts=2, team_size=2, update_time=0.1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = covey.run_study(study, folder, workers=1)
    ...     games = covey.load_study(folder).games
    ...
    >>> sorted(games.column_names)[:3]
    ['capture_radius', 'capture_time_0', 'capture_time_1']
    """
    path = Path(folder)
    manifest = read_manifest(path)
    if manifest is None:
        raise InputError(f"{path}: expected the results of a study, but there is no {NAME}")
    return StudyResult(path, manifest)
