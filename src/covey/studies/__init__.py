"""Many games: a grid of cases, every start in each of them, on one machine or on many.

Tables go to a folder, part by part, so nothing is lost when a run is stopped.
"""

from covey.scenarios.starts import Disk, Formation, Square
from covey.studies.repeated import AsVisible
from covey.studies.results import StudyResult, load_study
from covey.studies.run import run_study
from covey.studies.startfile import FromFile
from covey.studies.study import Study
from covey.studies.studyfile import example_names, example_path, read_study
from covey.studies.summary import Line, summary

__all__ = [
    "AsVisible",
    "Disk",
    "Formation",
    "FromFile",
    "Line",
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
