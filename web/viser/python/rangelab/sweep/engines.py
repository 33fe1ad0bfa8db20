"""Where chunks are computed: threads here, or a cluster whose own scheduler repeats what a lost worker had begun."""

import os
from collections.abc import Callable, Collection, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Protocol

from .._core import Error
from ..arrays import Floats
from .chunks import Chunk

RETRIES = 5
"""How often a cluster begins a chunk again whose worker was lost."""


class Pending(Protocol):
    """A chunk under way, wherever."""

    def result(self) -> Floats:
        """Its numbers, once there are any."""
        ...

    def cancel(self) -> object:
        """Nobody waits for it any more."""


@dataclass(frozen=True)
class Engine:
    """How to begin a chunk, how to wait for the next that are done, and how many to keep under way."""

    submit: Callable[[Chunk], Pending]
    next_done: Callable[[Collection[Any]], Collection[Any]]
    window: int


def compute(chunk: Chunk) -> Floats:
    """What a worker does."""
    return chunk.run()


@contextmanager
def engine(on: Any) -> Iterator[Engine]:
    """The engine of a wish.

    `on` is None (a thread for each processor), a number of threads, a `dask.distributed.Client`, "ray", or any
    `concurrent.futures.Executor`.
    """
    if on is None or isinstance(on, int):
        threads = on or os.cpu_count() or 1
        with ThreadPoolExecutor(threads, thread_name_prefix="rangelab") as pool:
            yield _of_executor(pool, 4 * threads)
    elif isinstance(on, Executor):
        yield _of_executor(on, 64)
    elif hasattr(on, "get_executor"):
        yield _of_dask(on)
    elif on == "ray":
        yield _of_ray()
    else:
        raise Error(f"{type(on).__name__} computes no sweep: give threads, an executor, a Dask client, or 'ray'")


def _next_done(futures: Collection[Any]) -> Collection[Any]:
    return wait(futures, return_when=FIRST_COMPLETED).done


def _of_executor(pool: Executor, window: int) -> Engine:
    return Engine(lambda chunk: pool.submit(compute, chunk), _next_done, window)


def _of_dask(client: Any) -> Engine:
    # Not `client.get_executor()`: its futures break where a worker dies with a result that was not fetched yet.
    import distributed

    def submit(chunk: Chunk) -> Pending:
        future: Pending = client.submit(compute, chunk, key=f"rangelab-{chunk.key}", retries=RETRIES)
        return future

    def next_done(futures: Collection[Any]) -> Collection[Any]:
        done: Collection[Any] = distributed.wait(list(futures), return_when="FIRST_COMPLETED").done  # type: ignore[no-untyped-call]
        return done

    return Engine(submit, next_done, 256)


def _of_ray() -> Engine:
    import ray  # pyright: ignore[reportMissingImports]

    remote = ray.remote(compute).options(max_retries=RETRIES)
    return Engine(lambda chunk: remote.remote(chunk).future(), _next_done, 256)
