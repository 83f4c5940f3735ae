"""The command `covey`: its subcommands, and what a mistake looks like."""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from cyclopts import App, CycloptsError, MissingArgumentError

import covey
from covey.cli.shared.exit_status import (
    GAMES_MISSING,
    INPUT_ERROR,
    INTERRUPTED,
    OUTPUT_CLOSED,
    MissingGamesError,
)
from covey.kernels.library.errors import BuildError

_HELP = """\
Plan how a team of turn-limited vehicles survives, as a team and for as long as possible, against \
one faster pursuer that it may not see; play the game; draw it.

Games are described in TOML files. Some come with covey and are asked for by name: \
everyone, fig3, uncertain, unequal, unseen, visible.

Try:

    covey new mine.toml
    covey plan fig3
    covey simulate fig3 --output game.parquet
    covey draw game.parquet --output game.png
    covey chase

Angles are radians, counter-clockwise from +x, or text such as "90 deg" in files; lengths and \
times are in any consistent unit, or in the unit that a file names. Evaders are numbered from 0.

Exit status: 0; 2 after a mistake in a file or on the command line; 3 if games of a study could \
not be played; 130 after Ctrl-C; 1 if nobody reads the output to its end.
"""

COMMANDS = (
    "new",
    "show",
    "schema",
    "plan",
    "simulate",
    "worst_case",
    "draw",
    "study",
    "reproduce",
    "yardstick",
    "instances",
    "score",
    "chase",
    "notebook",
    "warmup",
)
"""The files in `commands`, and the function in each, in the order of `covey --help`."""


def _help_of(command: str) -> str | None:
    """Return the docstring of a command's function, without an import of the file.

    cyclopts shows its first line in `covey --help`, and all of it in the command's own help.
    """
    source = (Path(__file__).parent / "commands" / f"{command}.py").read_text(encoding="utf-8")
    functions = [each for each in ast.parse(source).body if isinstance(each, ast.FunctionDef)]
    return next(ast.get_docstring(each) for each in functions if each.name == command)


app = App(name="covey", help=_HELP, help_format="markdown", suppress_keyboard_interrupt=False)
for _position, _command in enumerate(COMMANDS):
    app.command(
        f"covey.cli.commands.{_command}:{_command}", help=_help_of(_command), sort_key=_position
    )


app.register_install_completion_command(
    help="Make this shell complete covey's commands and options; bash, zsh, fish, PowerShell."
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status.

    Parameters
    ----------
    arguments
        Words after `covey`; by default those that the program was called with.

    Returns
    -------
    int
        0, or one of those in `shared.exit_status`.
    """
    try:
        app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
        sys.stdout.flush()
    except MissingArgumentError as error:
        name = error.argument.name if error.argument is not None else "argument"
        return _failed(f"{name}: expected a value, got none\nTry: {_help_command(error)}")
    except CycloptsError as error:
        return _failed(f"{error}\nTry: {_help_command(error)}")
    except BrokenPipeError:
        return _reader_is_gone()
    except OSError as error:
        return _failed(f"{error.filename}: {error.strerror}" if error.filename else str(error))
    except ValueError as error:
        if not isinstance(error, covey.InputError):
            raise
        return _failed(str(error))
    except BuildError as error:
        return _failed(str(error))
    except MissingGamesError as error:
        return _failed(str(error), GAMES_MISSING)
    except KeyboardInterrupt as error:
        print(": ".join(["covey: stopped", *map(str, error.args)]), file=sys.stderr)
        return INTERRUPTED
    return 0


def _failed(message: str, status: int = INPUT_ERROR) -> int:
    print(f"covey: {message}", file=sys.stderr)
    return status


def _help_command(error: CycloptsError) -> str:
    chain = [word for word in error.command_chain or () if word]
    return " ".join(["covey", *chain, "--help"])


def _reader_is_gone() -> int:
    """Return the status, without a message, after the reader closed the output as `head` does.

    Where rich notices the closed output first, rich ends the program with the same status.
    """
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return OUTPUT_CLOSED
