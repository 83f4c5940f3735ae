"""Study files: TOML in, with all its mistakes told at once, and a study out.

starts, seed, sampler, trajectories, unit
[grid]      team_size, speed, turn_rate or turn_radius, pursuer_speed, disk_radius,
            capture_radius, update_time, sensing, objective, evaders, pursuer:
            each a value or a list of values
"""

from __future__ import annotations

import os
from dataclasses import fields
from pathlib import Path

from covey.scenarios.examples import Examples
from covey.scenarios.load import read_document
from covey.scenarios.mistakes import require_none
from covey.studies.design.fields import read_fields, study_model
from covey.studies.design.study import Study, plain

STUDIES = Examples(Path(__file__).parents[1] / "examples", "study")
StudyFile = study_model({field.name: plain(field.default) for field in fields(Study)})
"""The model of a study file, with the defaults of `Study`."""

example_names, example_path = STUDIES.names, STUDIES.path


def read_study(path: str | os.PathLike[str]) -> Study:
    """Read a study from its TOML file, or one that comes with covey.

    Parameters
    ----------
    path
        The file; or the name of a study that comes with covey, such as "fig4".

    Raises
    ------
    InputError
        If the file can't be read, or with all of its mistakes, one a line: where, what was
        wanted, what came.
    """
    file = STUDIES.find(path)
    values, mistakes = read_fields(read_document(file, "a study"), StudyFile)
    require_none(mistakes, file)
    return Study(**values)
