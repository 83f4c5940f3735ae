"""Studies that compare teams or objectives."""

from __future__ import annotations

from covey.studies.analysis.objectives import compares_objectives, objectives
from covey.studies.analysis.paired_ratios import Comparison
from covey.studies.analysis.tournament import is_tournament, tournament
from covey.studies.running.results import StudyResult


def comparison(result: StudyResult) -> Comparison | None:
    """Return the ratios of a study of several teams or objectives; None of any other study.

    Examples
    --------
    >>> import tempfile
    >>> import covey
    >>> from covey import studies
    >>> teams = ["open-loop", "straight-away"]
    >>> study = covey.Study(starts=3, team_size=2, update_time=0.1, evaders=teams)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     compared = studies.comparison(covey.run_study(study, folder, workers=1))
    ...
    >>> compared.rows
    'team'
    """
    if is_tournament(result.study):
        return tournament(result)
    if compares_objectives(result.study):
        return objectives(result)
    return None
