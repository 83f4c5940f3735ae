"""Who may talk to the server: pages that came from it, under a name that is its own.

Another site can make a browser connect to 127.0.0.1, and a name that it owns can be made to lead
there. The first shows in the Origin header, the second in the Host header.
"""

from __future__ import annotations

import ipaddress
from urllib.parse import urlsplit


def is_own_host(host: str, served: str) -> bool:
    """Return whether a Host header names this machine: by address, as localhost, or as `served`."""
    try:
        name = urlsplit(f"//{host}").hostname or ""
        if name in {"localhost", served.lower()}:
            return True
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True  # an address can't be made to lead elsewhere


def is_own_origin(origin: str | None, host: str) -> bool:
    """Return whether a page with this Origin header came from the host it now talks to."""
    return origin in {f"http://{host}", f"https://{host}"}
