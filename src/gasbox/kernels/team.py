"""Several threads in one kernel: each runs the same code on its share, and all meet between the phases.

A kernel that works so takes `thread` and `threads`; the caller runs it once for each thread, at the same time, on a
`Flags` array of zeros. Waiting spins for a moment and then lets other threads of the machine run.
"""

from __future__ import annotations

import sys
from typing import Any

import numba.core.cgutils
import numba.core.types
import numba.extending
import numba.np.arrayobj
import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel

__all__ = ["flags", "give_up", "meet", "share"]

_APART = 8
"""Entries between the flags of two threads, so that each has a cache line of its own."""
_PATIENCE = 4000
"""Looks at another thread's flag before the processor is offered to others."""
_GONE = -1

# numba has no types for these parts of itself.
_types: Any = numba.core.types
_cgutils: Any = numba.core.cgutils
_make_array: Any = numba.np.arrayobj.make_array
_intrinsic: Any = numba.extending.intrinsic
_offer_processor: Any = _types.ExternalFunction(
    "SwitchToThread" if sys.platform == "win32" else "sched_yield", _types.int32()
)


def flags(threads: int) -> NDArray[np.int64]:
    """Flags of a team that has not met yet: how often each has come to a meeting."""
    return np.zeros((threads + 1) * _APART, np.int64)


def give_up(flag: NDArray[np.int64]) -> None:
    """Let those who wait at the first meeting go, because not all will come."""
    flag[-1] = _GONE


def _pointer(context: Any, builder: Any, signature: Any, flag: Any, place: Any) -> Any:
    array = _make_array(signature.args[0])(context, builder, flag)
    return _cgutils.get_item_pointer(context, builder, signature.args[0], array, [place])


@_intrinsic  # type: ignore[untyped-decorator]
def _read(_: Any, flag: Any, place: Any) -> Any:
    """flag[place], and nothing that comes after is read before it."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = context.cast(builder, arguments[1], signature.args[1], _types.intp)
        return builder.load_atomic(_pointer(context, builder, signature, arguments[0], place), "acquire", 8)

    return _types.int64(flag, place), code


@_intrinsic  # type: ignore[untyped-decorator]
def _write(_: Any, flag: Any, place: Any, value: Any) -> Any:
    """flag[place] = value, after all that was written before."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = context.cast(builder, arguments[1], signature.args[1], _types.intp)
        value = context.cast(builder, arguments[2], signature.args[2], _types.int64)
        builder.store_atomic(value, _pointer(context, builder, signature, arguments[0], place), "release", 8)
        return context.get_dummy_value()

    return _types.void(flag, place, value), code


@bare_kernel
def meet(flag: NDArray[np.int64], thread: int, threads: int) -> bool:
    """Wait until all threads have come here; return False if one will not come (only before the first meeting)."""
    if threads == 1:
        return True
    mine = flag[thread * _APART] + 1
    _write(flag, thread * _APART, mine)
    for other in range(threads):
        looks = 0
        while _read(flag, other * _APART) < mine:
            looks += 1
            if looks > _PATIENCE:
                if _read(flag, flag.shape[0] - 1) == _GONE:
                    return False
                _offer_processor()
    return True


@inlined_kernel
def share(n: int, thread: int, threads: int) -> tuple[int, int]:
    """First and one past the last of `n` things that are this thread's."""
    return n * thread // threads, n * (thread + 1) // threads
