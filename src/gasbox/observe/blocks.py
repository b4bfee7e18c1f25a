"""Error bars of means over frames that know of each other.

Frames close together are alike, so their scatter divided by the root of their number is too small. Neighbours are
averaged two by two, again and again: as soon as blocks are longer than the memory of the gas, the error that they give
no longer grows.

Source: H. Flyvbjerg and H. G. Petersen, J. Chem. Phys. 91, 461 (1989), doi:10.1063/1.457480.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

__all__ = ["block_error"]

_FEWEST: Final = 16
"""Blocks that still tell a scatter, to some 18 %."""


def block_error(samples: NDArray[np.float64]) -> NDArray[np.float64]:
    """Standard error of the mean over the first axis: the largest that blocks of any length give.

    Blocks get longer until fewer than 16 would be left; of fewer than 32 samples they are single ones. If the memory is
    longer than a sixteenth of the run, the true error is larger.

    Parameters
    ----------
    samples : (frames, ...), at equal times apart

    Returns
    -------
    (...): not-a-number for fewer than two samples.
    """
    blocks = np.asarray(samples, np.float64)
    error = _error(blocks)
    while blocks.shape[0] >= 2 * _FEWEST:
        even = blocks[: blocks.shape[0] // 2 * 2]
        blocks = 0.5 * (even[::2] + even[1::2])
        error = np.maximum(error, _error(blocks))
    return error


def _error(blocks: NDArray[np.float64]) -> NDArray[np.float64]:
    count = blocks.shape[0]
    if count < 2:
        return np.full(blocks.shape[1:], np.nan)
    error: NDArray[np.float64] = np.std(blocks, axis=0, ddof=1) / np.sqrt(count)
    return error
