"""The public names of this room, each with the file that it comes from."""

from .analysis.comparison import comparison as comparison
from .analysis.paired_ratios import Comparison as Comparison
from .analysis.paired_ratios import PairedRatio as PairedRatio
from .analysis.summary import CaseSummary as CaseSummary
from .analysis.summary import summary as summary
from .analysis.yardstick import Change as Change
from .analysis.yardstick import Yardstick as Yardstick
from .analysis.yardstick import YardstickRow as YardstickRow
from .design.as_visible import AsVisible as AsVisible
from .design.samplers import Disk as Disk
from .design.samplers import Formation as Formation
from .design.samplers import FromFile as FromFile
from .design.samplers import Square as Square
from .design.study import Study as Study
from .design.study_file import example_names as example_names
from .design.study_file import example_path as example_path
from .design.study_file import read_study as read_study
from .paper.figures import Gains as Gains
from .paper.figures import contingent_gains as contingent_gains
from .paper.figures import survival_ratios as survival_ratios
from .paper.figures import turn_rate_gains as turn_rate_gains
from .paper.report import report as report
from .running.results import StudyResult as StudyResult
from .running.results import load_study as load_study
from .running.run import run_study as run_study
from .statistics import Estimate as Estimate
