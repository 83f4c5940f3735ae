"""Whose turn it is, on time that is made up."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from covey.web.serving.fair_queue import FairQueue

SECONDS = st.lists(st.floats(0.001, 5.0), min_size=20, max_size=20)


def test_items_of_one_user_keep_their_order():
    queue = FairQueue()
    for k in range(5):
        queue.put("a", k)
    assert [queue.take() for _ in range(5)] == [("a", k) for k in range(5)]


def test_who_has_had_least_is_next_however_many_wait():
    queue = FairQueue()
    for k in range(100):
        queue.put("crowd", k)
    assert queue.take() == ("crowd", 0)
    queue.charge("crowd", 1.0)
    for _ in range(20):
        queue.put("one", "frame")
        assert queue.take() == ("one", "frame")
        queue.charge("one", 0.1)
        assert queue.take()[0] == "crowd"
        queue.charge("crowd", 1.0)


def test_nobody_saves_up_time_by_waiting():
    queue = FairQueue()
    for _ in range(100):
        queue.put("busy", None)
        queue.charge(queue.take()[0], 1.0)
    for _ in range(20):
        queue.put("busy", None)
        queue.put("late", None)
    served = []
    for _ in range(20):
        served.append(queue.take()[0])
        queue.charge(served[-1], 1.0)
    assert served.count("late") in {10, 11}


def test_nor_by_asking_for_little_at_a_time():
    """Who leaves and comes back has had what was charged, also when others were served since."""
    queue = FairQueue()
    queue.put("a", None)
    queue.take()
    queue.charge("a", 5.0)
    queue.put("b", None)
    queue.take()
    queue.charge("b", 1.0)
    queue.put("a", None)
    queue.put("b", None)
    assert queue.take()[0] == "b"


@given(SECONDS, SECONDS)
def test_two_who_always_wait_have_had_the_same_but_for_one_item_each(of_a, of_b):
    """The bound of start-time fair queueing."""
    queue, left = FairQueue(), {"a": of_a, "b": of_b}
    for user, items in left.items():
        for seconds in items:
            queue.put(user, seconds)
    had = {"a": 0.0, "b": 0.0}
    while queue._waiting.keys() == left.keys():
        user, seconds = queue.take()
        queue.charge(user, seconds)
        had[user] += seconds
        assert abs(had["a"] - had["b"]) <= max(of_a) + max(of_b) + 1e-9


def test_users_that_are_gone_are_forgotten():
    queue = FairQueue()
    for k in range(1000):
        queue.put(f"user {k}", None)
        queue.put("another", None)
        for _ in "ab":
            queue.charge(queue.take()[0], 0.5)
    assert len(queue._had) <= 3
