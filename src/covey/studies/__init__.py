"""Many games: a grid of cases, every start in each of them, on one machine or on many.

Tables go to a folder, part by part, so nothing is lost when a run is stopped.
"""

from covey.scenarios.samplers import Disk, Formation, Square
from covey.studies.analysis.summary import Line, summary
from covey.studies.design.as_visible import AsVisible
from covey.studies.design.start_table import FromFile
from covey.studies.design.study import Study
from covey.studies.design.study_file import example_names, example_path, read_study
from covey.studies.running.results import StudyResult, load_study
from covey.studies.running.run import run_study

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
