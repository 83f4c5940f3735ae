"""Games described in files: TOML in, all its mistakes told at once, and a scenario out.

Read schema, values and strategies (what may stand in a file), mistakes and consistency (what is
wrong with it), then load, build and scenario. Studies read their files by the same types.
"""

from covey.scenarios.examples import example_names, example_path
from covey.scenarios.load import load_scenario
from covey.scenarios.scenario import Scenario

__all__ = ["Scenario", "example_names", "example_path", "load_scenario"]
