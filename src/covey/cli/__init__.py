"""The command line: parse, call, print.

The commands import the rooms that they need when they run, so that `covey --help` answers at once.
"""

from covey.cli.app import main

__all__ = ["main"]
