"""Studies that compare: which there are, and their scores."""

from __future__ import annotations

from covey.studies.analysis.objectives import compares_objectives, objectives
from covey.studies.analysis.scores import Comparison
from covey.studies.analysis.tournament import is_tournament, tournament
from covey.studies.running.results import StudyResult


def comparison(result: StudyResult) -> Comparison | None:
    """Return the scores of a study of several teams, or several objectives; None of any other."""
    if is_tournament(result.study):
        return tournament(result)
    if compares_objectives(result.study):
        return objectives(result)
    return None
