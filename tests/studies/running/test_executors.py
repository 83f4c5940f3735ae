"""Where the work of a study is done, and what an interrupt leaves."""

import signal
import threading
import time

import pytest

from covey.kernels.arrays import GO_ON
from covey.studies.running.executors import Executor, InProcess


def interrupt(*_):
    raise KeyboardInterrupt


def test_the_thread_that_an_interrupt_comes_to_submits_nothing_to_a_pool():
    assert Executor().supervise(lambda _: threading.get_ident()) != threading.get_ident()
    assert InProcess().supervise(lambda _: threading.get_ident()) == threading.get_ident()


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no timer")
def test_an_interrupt_ends_the_work_in_the_other_thread():
    ended = []

    def work(stop):
        while stop[0] == GO_ON:
            time.sleep(0.005)
        ended.append(True)

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with pytest.raises(KeyboardInterrupt):
            Executor().supervise(work)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert ended == [True]
