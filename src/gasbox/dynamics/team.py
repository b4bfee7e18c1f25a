"""Threads that run one kernel together."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from gasbox.jit import is_compiling
from gasbox.kernels.team import flags, give_up

__all__ = ["Team", "fitting_threads", "processors"]

_FEW = 5_000
"""Particles a thread below which more threads are not worth their meetings."""


def processors() -> int:
    """How many processors this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not known on this system
        return os.cpu_count() or 1


def fitting_threads(particles: int) -> int:
    """How many threads are worth their meetings for so many particles."""
    return max(1, min(processors(), particles // _FEW))


class Team:
    """Runs a kernel that takes `flag`, `thread` and `threads` last, once for each thread at the same time.

    Parameters
    ----------
    threads : how many; one without the JIT, where threads would only wait for each other
    """

    def __init__(self, threads: int) -> None:
        self.wanted = threads
        self.threads = threads if is_compiling() else 1
        self._helpers: ThreadPoolExecutor | None = None

    def run(self, kernel: Callable[..., int], *arguments: Any) -> int:
        """Call `kernel` and return what it returns, the same for all threads."""
        flag = flags(self.threads)
        if self.threads == 1:
            return kernel(*arguments, flag, 0, 1)
        if self._helpers is None:
            self._helpers = ThreadPoolExecutor(self.threads - 1, thread_name_prefix="gasbox-team")
        helping = []
        try:
            for thread in range(1, self.threads):
                helping.append(self._helpers.submit(kernel, *arguments, flag, thread, self.threads))
            status = kernel(*arguments, flag, 0, self.threads)
        except BaseException:
            # Interrupted before all were there: the others have done nothing yet and must not wait for ever.
            give_up(flag)
            raise
        finally:
            for one in helping:
                one.result()
        return status
