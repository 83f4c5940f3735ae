"""Games described in files: TOML in, with all its mistakes told at once, and a scenario out."""

from covey.scenarios.examples import example_names, example_path
from covey.scenarios.load import load_scenario
from covey.scenarios.scenario import Scenario

__all__ = ["Scenario", "example_names", "example_path", "load_scenario"]
