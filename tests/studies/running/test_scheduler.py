"""Which chunks count as those that have killed a worker."""

import threading
import time
from concurrent.futures import BrokenExecutor, Future

from covey.planning.long_calls import new_flag
from covey.studies.running.chunks import chunks_of
from covey.studies.running.executors import Executor
from covey.studies.running.scheduler import Scheduler
from studies.small_studies import small_study


class BreakingPool(Executor):
    """A pool of two that breaks under its first three calls, and under the last of them again."""

    size = 2

    def __init__(self):
        self.submitted = []

    def submit(self, _, study, chunk, code):
        future = Future()
        self.submitted.append((chunk.number, future))
        match len(self.submitted):
            case 1 | 2:
                pass
            case 3:
                threading.Thread(target=self._fail_one_after_the_other).start()
            case 6:
                future.set_exception(BrokenExecutor())
            case _:
                future.set_result(chunk.number)
        return future

    def _fail_one_after_the_other(self):
        for _, future in self.submitted[:3]:
            time.sleep(0.05)
            future.set_exception(BrokenExecutor())


def test_a_chunk_that_was_running_when_the_pool_broke_is_not_to_blame():
    study, pool, saved = small_study(), BreakingPool(), []
    scheduler = Scheduler(study, pool, lambda chunk, _: saved.append(chunk.number), new_flag())
    assert scheduler.run(chunks_of(study)) == []
    assert [number for number, _ in pool.submitted] == [0, 1, 2, 0, 1, 2, 2, 3]
    assert saved == [0, 1, 2, 3]
