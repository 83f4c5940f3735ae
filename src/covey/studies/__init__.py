"""Plays many games: every start of a study in every case of a grid.

Read in this order: `design` (what is played), `running` (on which machines, into which files),
`analysis` (means and ratios, with `statistics`), `paper` (Figs. 4 and 5).
"""

from covey.scenarios.samplers import Disk, Formation, Square
from covey.studies.analysis.summary import CaseSummary, summary
from covey.studies.design.as_visible import AsVisible
from covey.studies.design.start_table import FromFile
from covey.studies.design.study import Study
from covey.studies.design.study_file import example_names, example_path, read_study
from covey.studies.running.results import StudyResult, load_study
from covey.studies.running.run import run_study

__all__ = [
    "AsVisible",
    "CaseSummary",
    "Disk",
    "Formation",
    "FromFile",
    "Square",
    "Study",
    "StudyResult",
    "example_names",
    "example_path",
    "load_study",
    "read_study",
    "run_study",
    "summary",
]
