"""The command line: parse, call, print.

Read `app` (the commands, exit statuses), then `commands` (a file each), then `show` and `shared`.
What is heavy is imported when a command needs it, so that `covey --help` answers at once.
"""

from covey.cli.app import main

__all__ = ["main"]
