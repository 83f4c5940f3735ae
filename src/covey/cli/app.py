"""The command `covey`: its subcommands, and what a mistake looks like."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from cyclopts import App, CycloptsError

from covey.cli.commands.chase import chase
from covey.cli.commands.draw import draw
from covey.cli.commands.plan import plan
from covey.cli.commands.reproduce import reproduce
from covey.cli.commands.simulate import simulate
from covey.cli.commands.study import study
from covey.cli.commands.worst_case import worst_case
from covey.cli.commands.yardstick import yardstick

INPUT_ERROR = 2
"""Exit status after a mistake in a file or on the command line."""

INTERRUPTED = 130
"""Exit status after Ctrl-C, as shells have it."""

_HELP = """\
Plan how a team of turn-limited vehicles survives, as a team and for as long as possible, against \
one faster pursuer that it may not see; play the game; draw it.

Games are described in TOML files. Some come with covey and are asked for by name: \
everyone, fig3, uncertain, unequal, unseen, visible.

Try:

    covey plan fig3
    covey simulate fig3 --output game.parquet
    covey draw game.parquet --output game.png
    covey chase

Angles are radians, counter-clockwise from +x; lengths and times are in any consistent unit. \
Evaders are numbered from 0.
"""

app = App(name="covey", help=_HELP, help_format="markdown", suppress_keyboard_interrupt=False)
app.command(plan, sort_key=1)
app.command(simulate, sort_key=2)
app.command(worst_case, sort_key=3)
app.command(draw, sort_key=4)
app.command(study, sort_key=5)
app.command(reproduce, sort_key=6)
app.command(yardstick, sort_key=7)
app.command(chase, sort_key=8)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status.

    Parameters
    ----------
    arguments
        Words after `covey`; by default those that the program was called with.

    Returns
    -------
    int
        0; 2 after a mistake in a file or on the command line; 130 after Ctrl-C; 1 if nobody reads
        the output to its end.
    """
    try:
        app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
        sys.stdout.flush()
    except CycloptsError as error:
        return _failed(f"{error}\nTry: {_help_command(error)}")
    except BrokenPipeError:
        return _reader_is_gone()
    except OSError as error:
        return _failed(f"{error.filename}: {error.strerror}" if error.filename else str(error))
    except ValueError as error:
        # Late, as it brings NumPy, and `--help` can do without.
        from covey.model import InputError

        if not isinstance(error, InputError):
            raise
        return _failed(str(error))
    except KeyboardInterrupt:
        print("covey: stopped", file=sys.stderr)
        return INTERRUPTED
    return 0


def _failed(message: str) -> int:
    print(f"covey: {message}", file=sys.stderr)
    return INPUT_ERROR


def _help_command(error: CycloptsError) -> str:
    chain = [word for word in error.command_chain or () if word]
    return " ".join(["covey", *chain, "--help"])


def _reader_is_gone() -> int:
    """Leave quietly when whoever read the output has closed it, as `head` does.

    Status 1 is what rich leaves with where it is the one to notice.
    """
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 1
