"""Runs points on several cores, each in a process of its own; how many there are changes no number.

Workers are started fresh (spawn), since a process whose kernels have threads must not be forked. They leave Ctrl-C to
the one that started them, which tells them to give up, and they end when that one is gone.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Generator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import connection
from multiprocessing.synchronize import Event

from gasbox.sweep.grid import Recipe
from gasbox.sweep.point import Point, measure

__all__ = ["measured"]

_enough: Event | None = None
"""In a worker: set once nobody wants its results any more."""


def measured(
    points: Sequence[tuple[float, float]], recipe: Recipe, workers: int = 1
) -> Generator[Point, None, None]:
    """Each point as it gets done, in any order. Closing the iterator stops all work.

    Parameters
    ----------
    points : (temperature [energy], density [1/length²])
    workers : processes; with one, everything happens in this one
    """
    if workers <= 1 or len(points) <= 1:
        for temperature, density in points:
            found = measure(temperature, density, recipe)
            assert found is not None
            yield found
        return
    context = multiprocessing.get_context("spawn")
    enough = context.Event()
    pool = ProcessPoolExecutor(min(workers, len(points)), context, _begin, (enough,))
    try:
        futures = [pool.submit(_work, temperature, density, recipe) for temperature, density in points]
        for future in as_completed(futures):
            found = future.result()
            assert found is not None
            yield found
    finally:
        enough.set()
        pool.shutdown(wait=True, cancel_futures=True)


def _begin(enough: Event) -> None:
    """First thing in a worker."""
    global _enough
    _enough = enough
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)


def _work(temperature: float, density: float, recipe: Recipe) -> Point | None:
    assert _enough is not None
    return measure(temperature, density, recipe, _enough.is_set)
