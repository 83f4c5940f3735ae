"""Studies that compare: which there are, and their scores."""

from __future__ import annotations

from covey.studies.objectives import compares_objectives, objectives
from covey.studies.results import StudyResult
from covey.studies.scores import Comparison
from covey.studies.tournament import is_tournament, tournament


def comparison(result: StudyResult) -> Comparison | None:
    """Return the scores of a study of several teams, or several objectives; None of any other."""
    if is_tournament(result.study):
        return tournament(result)
    if compares_objectives(result.study):
        return objectives(result)
    return None
