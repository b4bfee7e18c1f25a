"""Several threads in one kernel: each runs the same code on its share, and all meet between the phases.

A kernel that works so takes `thread` and `threads`; the caller runs it once for each thread, at the same time, on a
`Flags` array of zeros. Waiting spins for a moment and then lets other threads of the machine run.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.processor import offer_processor, read, write

__all__ = ["flags", "give_up", "meet", "share"]

_APART = 8
"""Entries between the flags of two threads, so that each has a cache line of its own."""
_PATIENCE = 4000
"""Looks at another thread's flag before the processor is offered to others."""
_GONE = -1


def flags(threads: int) -> NDArray[np.int64]:
    """Flags of a team that has not met yet: how often each has come to a meeting."""
    return np.zeros((threads + 1) * _APART, np.int64)


def give_up(flag: NDArray[np.int64]) -> None:
    """Let those who wait at the first meeting go, because not all will come."""
    flag[-1] = _GONE


@bare_kernel
def meet(flag: NDArray[np.int64], thread: int, threads: int) -> bool:
    """Wait until all threads have come here; return False if one will not come (only before the first meeting)."""
    if threads == 1:
        return True
    mine = flag[thread * _APART] + 1
    write(flag, thread * _APART, mine)
    for other in range(threads):
        looks = 0
        while read(flag, other * _APART) < mine:
            looks += 1
            if looks > _PATIENCE:
                if read(flag, flag.shape[0] - 1) == _GONE:
                    return False
                offer_processor()
    return True


@inlined_kernel
def share(n: int, thread: int, threads: int) -> tuple[int, int]:
    """First and one past the last of `n` things that are this thread's."""
    return n * thread // threads, n * (thread + 1) // threads
