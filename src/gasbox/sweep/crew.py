"""Does tasks on several cores, each in a process of its own; how many there are changes no result.

Workers are started fresh (spawn), since a process whose kernels have threads must not be forked. They leave Ctrl-C to
the one that started them, which tells them to give up, and they end when that one is gone.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from multiprocessing import connection
from multiprocessing.synchronize import Event
from queue import SimpleQueue
from typing import Any, TypeVar

from gasbox.errors import DynamicsError

__all__ = ["Stopped", "done_together"]

Task = TypeVar("Task")
Result = TypeVar("Result")

Stopped = Callable[[], bool]
"""Whether nobody wants the result any more; asked often by whoever does the work."""

_enough: Event | None = None
"""In a worker: set once nobody wants its results any more."""
_work: Callable[[Any, Stopped], Any] | None = None
"""In a worker: what it does."""


def done_together(
    work: Callable[[Task, Stopped], Result], tasks: Iterable[Task], workers: int = 1
) -> Generator[Result, None, None]:
    """The result of each task as it gets done, in any order. Closing the iterator stops all work.

    Parameters
    ----------
    work : a function of a module, or a `functools.partial` of one, so that other processes can be told; what it returns
        once it was told to stop is thrown away
    tasks : asked for the next ones only when somebody is about to need them
    workers : processes; with one, everything happens in this one

    Raises
    ------
    DynamicsError
        A worker was ended from outside.
    """
    if workers <= 1:
        for task in tasks:
            yield work(task, lambda: False)
        return
    context = multiprocessing.get_context("spawn")
    enough = context.Event()
    pool = ProcessPoolExecutor(workers, context, _begin, (enough, work))
    # A queue, since Ctrl-C while `concurrent.futures.wait` takes its locks would leave some of them locked.
    rest, running, done = iter(tasks), 0, SimpleQueue[Future[Any]]()
    try:
        while True:
            # Twice as many as there are workers, so that nobody waits for the next task.
            for task in islice(rest, 2 * workers - running):
                pool.submit(_do, task).add_done_callback(done.put)
                running += 1
            if not running:
                return
            future = done.get()
            running -= 1
            yield future.result()
    except BrokenProcessPool:
        raise DynamicsError(
            "one of the processes was ended from outside; perhaps there was not enough memory for so many workers"
        ) from None
    finally:
        enough.set()
        pool.shutdown(wait=True, cancel_futures=True)


def _begin(enough: Event, work: Callable[[Any, Stopped], Any]) -> None:
    """First thing in a worker."""
    global _enough, _work
    _enough, _work = enough, work
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)


def _do(task: Any) -> Any:
    assert _enough is not None
    assert _work is not None
    return _work(task, _enough.is_set)
