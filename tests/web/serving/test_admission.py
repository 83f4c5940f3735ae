"""When requests are let in, on a clock that is set by hand."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace

import pytest

from covey.web.serving import app
from covey.web.serving.admission import Admission


def waits(admission, times, address="a"):
    return [admission.wait(address, now) for now in times]


def test_so_many_are_let_in_at_once_and_then_one_after_the_other():
    assert waits(Admission(10.0, 3), [5.0] * 6) == pytest.approx([0.0, 0.0, 0.0, 0.1, 0.2, 0.3])


def test_who_keeps_to_the_rate_never_waits():
    admission = Admission(10.0, 1)
    assert waits(admission, [0.1001 * k for k in range(1000)]) == [0.0] * 1000


def test_a_silence_gives_back_no_more_than_the_burst():
    admission = Admission(10.0, 3)
    waits(admission, [0.0] * 6)
    assert waits(admission, [0.5]) == [0.0]
    assert waits(admission, [1e6] * 4) == pytest.approx([0.0, 0.0, 0.0, 0.1])


def test_another_address_does_not_wait():
    admission = Admission(10.0, 1)
    assert waits(admission, [0.0] * 100)[-1] > 9.0
    assert waits(admission, [0.0], "b") == [0.0]


def test_addresses_that_are_gone_are_forgotten():
    admission = Admission(10.0, 3)
    for k in range(1000):
        admission.wait(str(k), float(k))
    assert len(admission._next) <= 1


@pytest.mark.parametrize("kind", ["http", "websocket"])
def test_the_guard_lets_a_flood_in_at_its_rate(monkeypatch, kind):
    slept = []

    async def sleep(seconds):
        slept.append(seconds)

    monkeypatch.setattr(app, "asyncio", SimpleNamespace(sleep=sleep))
    monkeypatch.setattr(app, "time", SimpleNamespace(monotonic=lambda: 0.0))

    async def nothing(*_):
        pass

    guard = app.Guard(nothing, "localhost")
    scope = {"type": kind, "headers": [(b"host", b"localhost")], "client": ("h", 1)}

    async def flood():
        for _ in range(app._REQUESTS_AT_ONCE + 50):
            await guard(scope, nothing, nothing)

    asyncio.run(flood())
    assert slept[: app._REQUESTS_AT_ONCE] == pytest.approx([0.0] * app._REQUESTS_AT_ONCE)
    assert slept[-1] == pytest.approx(1.0)
