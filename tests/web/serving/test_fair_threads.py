"""In which order threads serve those who wait, on a clock that is set by hand."""

from __future__ import annotations

import threading
from types import SimpleNamespace

import pytest

from covey.web.serving import fair_threads
from covey.web.serving.fair_threads import FairThreads


class Kitchen:
    """One thread; a call takes as many seconds as it says, and none on a real clock."""

    def __init__(self, monkeypatch):
        self.now, self.served, self.open = 0.0, [], threading.Event()
        monkeypatch.setattr(fair_threads, "time", SimpleNamespace(monotonic=lambda: self.now))
        self.threads = FairThreads(1, "kitchen")
        self.first = self.threads.submit("nobody", self.open.wait)

    def order(self, user, seconds):
        def serve():
            self.now += seconds
            self.served.append(user)
            return user

        return self.threads.submit(user, serve)

    def serve(self, futures):
        self.open.set()
        return [future.result(10.0) for future in futures]


@pytest.fixture
def kitchen(monkeypatch):
    return Kitchen(monkeypatch)


def test_one_user_waits_for_one_call_of_a_crowd(kitchen):
    futures = [kitchen.order("crowd", 1.0) for _ in range(50)]
    futures.append(kitchen.order("one", 1.0))
    assert kitchen.serve(futures) == ["crowd"] * 50 + ["one"]
    assert kitchen.served.index("one") == 1


def test_long_calls_count_for_more_than_short_ones(kitchen):
    futures = [kitchen.order("long", 3.0) for _ in range(5)]
    futures += [kitchen.order("short", 1.0) for _ in range(15)]
    kitchen.serve(futures)
    assert kitchen.served[:12].count("short") in {8, 9}


def test_what_was_cancelled_is_not_called(kitchen):
    gone, other = kitchen.order("gone", 1.0), kitchen.order("other", 1.0)
    gone.cancel()
    kitchen.serve([other])
    assert kitchen.served == ["other"]


def test_an_error_is_raised_to_who_asked_and_the_thread_goes_on(kitchen):
    def fail():
        raise ZeroDivisionError

    failed = kitchen.threads.submit("a", fail)
    assert kitchen.serve([kitchen.order("a", 1.0)]) == ["a"]
    with pytest.raises(ZeroDivisionError):
        failed.result(10.0)
