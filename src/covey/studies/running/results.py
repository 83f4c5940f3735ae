"""Read a study back."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from covey.model import InputError, LastCapture
from covey.studies.running import folder as store
from covey.studies.running.manifest import NAME, read_manifest
from covey.studies.running.tables import MOMENTS, decoded
from covey.studies.statistics import Moments, moments_of

if TYPE_CHECKING:
    import pyarrow as pa


class StudyResult:
    """The games of a study, as far as they have been played.

    Attributes
    ----------
    folder : pathlib.Path
        Where they are. `games/` in it is a Parquet data set that any reader of Parquet opens.
    manifest : dict
        Study, seed, versions, machine.
    study : dict
        The study, as a study file gives it.
    failures : tuple of str
        Which games of the last run could not be played, and why.
    """

    def __init__(
        self, folder: Path, manifest: dict[str, Any], failures: tuple[str, ...] = ()
    ) -> None:
        self.folder, self.manifest, self.failures = folder, manifest, failures

    @property
    def study(self) -> dict[str, Any]:
        """The study, as a study file gives it."""
        described: dict[str, Any] = self.manifest["study"]
        described["grid"].setdefault("objective", [LastCapture().describe()])  # once the only one
        return described

    @property
    def is_complete(self) -> bool:
        """Whether all parts are there."""
        count: int = self.manifest["parts"]["count"]
        return sum(1 for _ in store.part_files(self.folder)) == count

    @property
    def games(self) -> pa.Table:
        """All games: one row each, in the order of their numbers."""
        import pyarrow as pa

        return pa.concat_tables(self.parts())

    def to_pandas(self) -> Any:
        """Return all games as a pandas data frame; pandas must be installed."""
        return self.games.to_pandas()

    def parts(self) -> Iterator[pa.Table]:
        """Return the games part by part, for studies that are larger than the memory."""
        for path in store.part_files(self.folder):
            yield _table(path)

    def trajectories(self) -> Iterator[pa.Table]:
        """Return the courses of the games part by part, if the study asked for them."""
        for path in store.part_files(self.folder, MOMENTS):
            yield _table(path)

    @cached_property
    def moments(self) -> Moments:
        """Means and covariances of the survival times of all cases, read part by part."""
        return moments_of(self.parts(), int(self.manifest["cases"]))

    @cached_property
    def values(self) -> Moments:
        """The same of what came of the objectives."""
        return moments_of(self.parts(), int(self.manifest["cases"]), "value")


def load_study(folder: str | os.PathLike[str]) -> StudyResult:
    """Load the results of a study.

    Parameters
    ----------
    folder
        To which `run_study` or `covey study` wrote, or is writing.

    Returns
    -------
    StudyResult
        `.games` is the table of all games, `.study` and `.manifest` tell what was played.

    Raises
    ------
    InputError
        If no study is there.
    """
    place = Path(folder)
    manifest = read_manifest(place)
    if manifest is None:
        raise InputError(f"{place}: expected the results of a study, but there is no {NAME}")
    return StudyResult(place, manifest)


def _table(path: Path) -> pa.Table:
    import pyarrow as pa

    try:
        return decoded(path.read_bytes())
    except pa.ArrowException as error:
        raise InputError(
            f"{path}: the part is damaged; run the study again, which plays it anew"
        ) from error
