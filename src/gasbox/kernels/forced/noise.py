"""Random numbers of thermostats: keyed by seed, use, disc and step, so that nothing disturbs them.

Sources: G. E. P. Box, M. E. Muller, Ann. Math. Stat. 29, 610 (1958), doi:10.1214/aoms/1177706645, for Gaussians;
G. Marsaglia, W. W. Tsang, ACM Trans. Math. Softw. 26, 363 (2000), doi:10.1145/358407.358414, for the gamma
distribution.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel
from gasbox.kernels.hall.random import philox, uniform

__all__ = ["gamma", "gaussians"]

_WORD = 0xFFFFFFFF


@bare_kernel
def gaussians(seed: NDArray[np.int64], stream: int, label: int, turn: int, step: int) -> tuple[float, float]:
    """Two independent numbers of the normal distribution.

    seed : (2,) halves of the scenario's seed; stream : which use; label : which disc; turn : which pair of these
    """
    words = philox(label & _WORD, step & _WORD, (step >> 32) & _WORD, turn & _WORD, seed[0] ^ stream, seed[1])
    radius = math.sqrt(-2.0 * math.log(uniform(words[0], words[1])))
    angle = 2.0 * math.pi * uniform(words[2], words[3])
    return radius * math.cos(angle), radius * math.sin(angle)


@bare_kernel
def gamma(seed: NDArray[np.int64], stream: int, shape: float, step: int) -> float:
    """A number of the gamma distribution of this shape (> 0) and scale 1, by rejection."""
    least = shape + 1.0 if shape < 1.0 else shape
    base = least - 1.0 / 3.0
    width = 1.0 / math.sqrt(9.0 * base)
    turn, value = 1, 0.0
    while value == 0.0:
        x, y = gaussians(seed, stream, 0, turn, step)
        v = (1.0 + width * x) ** 3
        # A second, independent number: two Gaussians make a uniform one.
        other = math.exp(-0.5 * (y * y + gaussians(seed, stream, 1, turn, step)[0] ** 2))
        if v > 0.0 and math.log(other) < 0.5 * x * x + base - base * v + base * math.log(v):
            value = base * v
        turn += 1
    if shape < 1.0:
        x, y = gaussians(seed, stream, 2, 0, step)
        value *= math.exp(-0.5 * (x * x + y * y) / shape)
    return value
