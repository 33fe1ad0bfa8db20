"""Jobs on threads, one result: they are joined in their order, so the result does not depend on who computed which."""

import os
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

from ._core import Cancelled
from .arrays import Floats

Progress = Callable[[int, int], bool | None]
"""Told how much of how much is done; returns False to stop."""


def run_jobs(
    count: int,
    job: Callable[[int], Floats],
    push: Callable[[Floats], None],
    *,
    threads: int | None,
    progress: Callable[[int], bool | None],
) -> None:
    """Runs jobs 0 to `count - 1`; `progress` hears how many are joined.

    Raises:
        Cancelled: where it said False before the first was joined.

    """
    workers = threads or os.cpu_count() or 1
    ahead: deque[Future[Floats]] = deque()
    pool = ThreadPoolExecutor(workers, thread_name_prefix="rangelab")
    try:
        if progress(0) is False:
            raise Cancelled("the study was called off before its first trials were done")
        begun = 0
        for joined in range(count):
            while begun < min(count, joined + 4 * workers):
                ahead.append(pool.submit(job, begun))
                begun += 1
            push(ahead.popleft().result())
            if progress(joined + 1) is False:
                return
    finally:
        # What has begun ends by itself; a key press or an exception waits for no more than that.
        pool.shutdown(wait=True, cancel_futures=True)
