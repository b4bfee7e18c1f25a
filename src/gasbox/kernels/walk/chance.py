"""Random words of people: keyed by seed and use, counted by person (or group of persons) and turn."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import inlined_kernel
from gasbox.kernels.hall.random import philox

__all__ = ["words"]

_WORD = 0xFFFFFFFF


@inlined_kernel
def words(number: int, turn: int, stream: int, seed: NDArray[np.int64]) -> tuple[int, int, int, int]:
    """Four words of 32 bits for a person and a turn; `seed` (2,) halves of the scenario's seed."""
    return philox(number & _WORD, number >> 32, turn & _WORD, (turn >> 32) & _WORD, seed[0] ^ stream, seed[1])
