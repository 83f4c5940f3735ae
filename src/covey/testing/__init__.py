"""Checks for strategies of one's own.

Read `strategies`, which has the public function, then `watched` (what is looked at in each
decision) and `trials` (the games that are played for it).
"""

from covey.testing.strategies import check_strategy

__all__ = ["check_strategy"]
