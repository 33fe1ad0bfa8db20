"""Where chunks are computed: threads here, or a cluster whose own scheduler repeats what a lost worker had begun."""

import os
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

from .._core import Error
from ..arrays import Floats
from .chunks import Chunk

Submit = Callable[[Chunk], "Future[Floats]"]

RETRIES = 5
"""How often a cluster begins a chunk again whose worker was lost."""


def compute(chunk: Chunk) -> Floats:
    """What a worker does."""
    return chunk.run()


@contextmanager
def engine(on: Any) -> Iterator[tuple[Submit, int]]:
    """How to submit a chunk, and how many to keep under way.

    `on` is None (a thread for each processor), a number of threads, a `dask.distributed.Client`, "ray", or any
    `concurrent.futures.Executor`.
    """
    if on is None or isinstance(on, int):
        threads = on or os.cpu_count() or 1
        with ThreadPoolExecutor(threads, thread_name_prefix="rangelab") as pool:
            yield (lambda chunk: pool.submit(compute, chunk)), 4 * threads
    elif isinstance(on, Executor):
        yield (lambda chunk: on.submit(compute, chunk)), 64
    elif hasattr(on, "get_executor"):
        # A chunk has no side effect: Dask may compute it twice, and the sum takes one answer for each key.
        executor = on.get_executor(retries=RETRIES)
        yield (lambda chunk: executor.submit(compute, chunk)), 256
    elif on == "ray":
        yield _ray(), 256
    else:
        raise Error(f"{type(on).__name__} computes no sweep: give threads, an executor, a Dask client, or 'ray'")


def _ray() -> Submit:
    import ray

    remote = ray.remote(compute).options(max_retries=RETRIES)

    def submit(chunk: Chunk) -> "Future[Floats]":
        future: Future[Floats] = remote.remote(chunk).future()
        return future

    return submit
