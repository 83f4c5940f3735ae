"""Who may talk to the server: only its own pages, under one of its own names.

Another site can make a browser connect to 127.0.0.1; the Origin header shows this. An attacker can
point a domain of theirs at 127.0.0.1 (DNS rebinding); the Host header shows that.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Mapping
from typing import Any
from urllib.parse import urlsplit


def address_of(scope: Mapping[str, Any]) -> str:
    """Return the address of the machine that a request came from."""
    return str((scope.get("client") or ("",))[0])


def is_own_host(host: str, served: str) -> bool:
    """Return whether a Host header names this machine: by address, as localhost, or as `served`."""
    try:
        parts = urlsplit(f"//{host}")
        name, _ = parts.hostname or "", parts.port  # a port that is no number is a ValueError
        if name in {"localhost", served.lower()}:
            return True
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True  # an address can't be pointed elsewhere


def is_own_origin(origin: str | None, host: str) -> bool:
    """Return whether a page with this Origin header came from `host`."""
    return origin in {f"http://{host}", f"https://{host}"}
