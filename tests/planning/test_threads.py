"""Calls in other threads, while the calling thread may be interrupted."""

import signal
import sys
import threading
import time

import pytest

from covey.kernels.arrays import ABANDON, FINISH
from covey.planning.long_calls import new_flag
from covey.planning.threads import Threads


def until(condition):
    for _ in range(1000):
        if condition():
            return
        time.sleep(0.005)
    raise AssertionError("it never came")


def flagged(stop):
    """Return a call that lasts until its flag is set, and returns the flag."""

    def call():
        until(lambda: stop[0])
        return int(stop[0])

    return call


def test_results_are_in_the_order_of_the_calls():
    with Threads(2) as threads:
        calls = [lambda k=k: time.sleep(0.01 * (3 - k)) or k for k in range(4)]
        assert threads.run(calls, new_flag()) == [0, 1, 2, 3]
        assert threads.run(calls[:1], new_flag()) == [0]


def test_a_block_has_the_same_threads_from_call_to_call():
    with Threads(1) as threads:
        one, other = (threads.run([threading.get_ident], new_flag())[0] for _ in range(2))
    assert one == other != threading.get_ident()


def test_the_first_exception_is_raised_when_all_calls_have_ended():
    ended = []

    def fail(number):
        ended.append(number)
        raise ValueError(number)

    with Threads(2) as threads, pytest.raises(ValueError, match=r"^1$"):
        threads.run([lambda: ended.append(0), lambda: fail(1), lambda: fail(2)], new_flag())
    assert sorted(ended) == [0, 1, 2]


def test_the_flag_says_finish_at_the_deadline():
    stop = new_flag()
    with Threads(2) as threads:
        found = threads.run([flagged(stop), flagged(stop)], stop, time.perf_counter() + 0.05)
    assert found == [FINISH, FINISH]


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no timer")
def test_an_interrupt_abandons_the_calls_and_waits_for_the_running_ones():
    stop, ended = new_flag(), []

    def call():
        ended.append(flagged(stop)())

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with Threads(1) as threads, pytest.raises(KeyboardInterrupt):
            threads.run([call, call, call], stop)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert ended == [ABANDON]


def test_threads_end_with_their_block():
    meeting = threading.Barrier(4)

    def meet():
        meeting.wait()
        return threading.get_ident()

    with Threads(4) as threads:
        met = set(threads.run([meet] * 4, new_flag()))
        assert len(met & set(sys._current_frames())) == 4
    until(lambda: not met & set(sys._current_frames()))


def is_interrupted(instruction, call):
    """Make a call with an interrupt before an instruction of this thread; return if it came."""
    left = instruction

    def trace(frame, event, _):
        nonlocal left
        frame.f_trace_opcodes = True
        left -= event == "opcode"
        if left == 0:
            sys.settrace(None)
            raise KeyboardInterrupt
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        call()
    except KeyboardInterrupt:
        return True
    finally:
        sys.settrace(before)
    return False


def run_two():
    with Threads(2) as threads:
        threads.run([int, int], new_flag())


# A pool of concurrent.futures hangs after some of these interrupts.
def test_an_interrupt_before_any_instruction_leaves_nothing_that_waits_for_ever():
    instructions = 1
    while is_interrupted(instructions, run_two):
        instructions += 1
    assert instructions > 100
