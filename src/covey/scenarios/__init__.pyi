"""The public names of this room, each with the file that it comes from."""

from .examples import example_names as example_names
from .examples import example_path as example_path
from .load import load_scenario as load_scenario
from .scenario import Scenario as Scenario
