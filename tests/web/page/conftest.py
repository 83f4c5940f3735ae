"""A browser for the tests of a file, and the pages that a test opens in it."""

from __future__ import annotations

import pytest

from web.browser_pages import NAMES, Tab, chromium, found


@pytest.fixture(scope="module")
def browser():
    if found() is None:
        pytest.skip(f"no Chromium here ({', '.join(NAMES)}): the page is not tested in a browser")
    with chromium() as started:
        yield started


@pytest.fixture
def open_page(browser, server):
    """Opens pages; in the end none of them may have had trouble, or asked anybody else."""
    tabs = []

    def opened(query="", **options):
        tab = Tab(browser, f"{server.address}/{query}", **options)
        tabs.append(tab)
        tab.see("Press on the board to start")
        return tab

    yield opened
    for tab in tabs:
        assert tab.troubles == []
        own = (server.address, f"blob:{server.address}")
        assert [url for url in tab.requests if not url.startswith(own)] == []
        tab.context.close()
