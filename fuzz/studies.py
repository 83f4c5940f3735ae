"""Study files: what loads has cases, draws its starts, and is described as it was given."""

from __future__ import annotations

import covey
from covey import studies
from covey.studies.design.case import game_of
from covey.studies.design.study_file import StudyFile
from fuzz.oracle import refusal, require, require_finite
from fuzz.target import Target, corpus
from fuzz.toml_files import file_with, toml_cases

MOST_CASES = 1000
"""Of a study whose games are set up here, one a case."""


def check(content):
    """Load a study; set up its first games."""
    with file_with(content, ".toml") as file:
        try:
            study = studies.read_study(file)
        except covey.InputError as error:
            return refusal(error)
    require(study.games >= study.starts >= 1, f"{study.games} games of {study.starts} starts")
    described = study.describe()
    again = studies.Study(**described.pop("grid"), **described)
    require(again.describe() == study.describe(), "described otherwise than it was given")
    if study.games > study.starts * MOST_CASES:
        return "loaded"
    for case in study.cases:
        start = study.start(0, case.team_size)
        team, disk = game_of(case, start)
        require_finite("start", team.positions, team.headings)
        require((team.speeds < disk.speed).all(), "an evader as fast as the pursuer")
    return "set up"


FILES = [*map(studies.example_path, studies.example_names()), *corpus("studies")]
TARGET = Target("studies", ".toml", toml_cases(FILES, StudyFile), check)
