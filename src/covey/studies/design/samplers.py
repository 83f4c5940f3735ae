"""How the starts of a study are drawn: at random, or from a file."""

from covey.scenarios.samplers import Disk, Formation, Square
from covey.studies.design.start_table import FromFile

__all__ = ["Disk", "Formation", "FromFile", "Square"]
