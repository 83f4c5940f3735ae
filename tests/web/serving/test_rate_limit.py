"""The budget of a connection: how much it lets through, and what a refusal costs."""

from __future__ import annotations

import numpy as np

from covey.web.serving.rate_limit import TokenBucket


def taken(bucket, times, cost=1.0):
    return sum(bucket.take(now, cost) for now in times)


def test_so_much_at_once_and_no_more():
    bucket = TokenBucket(10.0, 20.0)
    assert taken(bucket, [5.0] * 100) == 20
    assert not bucket.take(5.0)


def test_tokens_come_back_at_the_rate():
    bucket = TokenBucket(10.0, 20.0)
    taken(bucket, [5.0] * 20)
    assert not bucket.take(5.09)
    assert bucket.take(5.11)
    assert not bucket.take(5.19)  # the hundredth that was over is kept
    assert bucket.take(5.21)


def test_a_long_silence_saves_up_no_more_than_the_capacity():
    bucket = TokenBucket(10.0, 20.0)
    taken(bucket, [0.0] * 20)
    assert taken(bucket, [1e6] * 100) == 20


def test_a_cost_is_taken_whole_or_not_at_all():
    bucket = TokenBucket(10.0, 20.0)
    assert not bucket.take(0.0, 20.5)
    assert bucket.take(0.0, 15.0)
    assert not bucket.take(0.0, 6.0)
    assert bucket.take(0.0, 5.0)  # what was refused has cost nothing
    assert not bucket.take(0.0, 0.5)


def test_refusals_neither_give_nor_take():
    """Who asks all the time gets as much as who asks when there is something to get."""
    hurried, patient = TokenBucket(10.0, 20.0), TokenBucket(10.0, 20.0)
    taken(patient, [0.0] * 20)
    assert taken(hurried, np.linspace(0.0, 4.04, 4000)) == 20 + 40
    assert taken(patient, np.linspace(0.101, 4.001, 40)) == 40
