"""`covey chase`: the page on which a person plays the pursuer."""

from __future__ import annotations

import importlib.util
from typing import Annotated

from cyclopts import Parameter

import covey


def chase(
    *,
    host: Annotated[
        str,
        Parameter(
            help="Address to listen on. Any other than 127.0.0.1 lets other machines play, on "
            "this machine's processor: 0.0.0.0 for all networks that it is in."
        ),
    ] = "127.0.0.1",
    port: Annotated[int, Parameter(help="Port to listen on; 0 takes any that is free.")] = 8014,
    browser: Annotated[bool, Parameter(help="Open the page in the browser.")] = True,
) -> None:
    """Chase a team yourself, in the browser: you are the pursuer, and the team plans as it flies.

    Serves a page from this machine, which needs no network. Steer with mouse, touch or keys; the
    score sets you beside the best pursuer known in the same game. Ctrl-C ends it.

    Try:

        covey chase
    """
    needed = ("starlette", "uvicorn", "websockets")
    missing = [name for name in needed if importlib.util.find_spec(name) is None]
    if missing:
        raise covey.InputError(
            f"covey chase needs {' and '.join(missing)}, which comes with the extra `web`: "
            "pip install 'covey[web]'"
        )
    if not 0 <= port < 2**16:
        raise covey.InputError(f"--port: expected a whole number from 0 to 65535, got {port}")
    from covey.web.serving.server import serve  # only now, as it imports what may be missing

    serve(host, port, open_browser=browser)
