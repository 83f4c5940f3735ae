"""Where the time of a plan goes; see `accounting`. The table is printed at the end of the run."""

from __future__ import annotations

import pytest

from accounting import accounts
from rounds import SIZES


@pytest.mark.parametrize("size", SIZES)
def test_account(benchmark, size):
    benchmark.group = "the accounting itself"
    found = benchmark.pedantic(accounts, args=(size,), rounds=1)
    benchmark.extra_info |= {account.task: account._asdict() for account in found}
