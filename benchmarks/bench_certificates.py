"""How soon the worst sequence of given headings is proven; see `certificates`, which has a script.

The table is printed at the end of the run.
"""

from __future__ import annotations

import pytest

from certificates import measure, warm_up

SIZES, GAMES, LIMIT = (8, 10, 12), 3, 10.0
"""Few and small: the script has a table for larger teams, which takes twenty minutes."""


@pytest.fixture(scope="module", autouse=True)
def _compiled():
    warm_up()


@pytest.mark.parametrize("size", SIZES)
def test_certificates(benchmark, size):
    benchmark.group = "certificates of all methods"
    ours, didppy = benchmark.pedantic(measure, args=(size, GAMES, LIMIT), rounds=1)
    benchmark.extra_info |= {row.method: row._asdict() for row in (ours, didppy)}
    assert ours.within_1_s == 1.0
    assert didppy.within_10_s == 1.0
