"""One server for all tests of the page in a file."""

from __future__ import annotations

import pytest

from web.served_pages import serving


@pytest.fixture(scope="module")
def server():
    with serving() as served:
        yield served
