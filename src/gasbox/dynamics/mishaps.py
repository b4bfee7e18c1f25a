"""What went wrong with molecules under the stepped rule, in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.stepped.bodies import CUT_SHORT, DEEP, DEEPEST, HELD_BACK

__all__ = ["mishaps_told"]


def mishaps_told(mishaps: NDArray[np.int64], worst: NDArray[np.float64]) -> tuple[str, ...]:
    """Sentences for the books of `gasbox.kernels.stepped.bodies.Bodies`; none if all went well."""
    told = []
    if mishaps[DEEP]:
        told.append(
            f"the time step is too long: discs of molecules were found in one another by more than the smaller radius "
            f"({mishaps[DEEP]} times, the deepest by {worst[DEEPEST]:.2f} of it), and may have passed through each "
            "other; shorten dynamics.time_step"
        )
    if mishaps[HELD_BACK]:
        told.append(
            f"the time step is too long: molecules that would have got across a wall were held back "
            f"({mishaps[HELD_BACK]} times); shorten dynamics.time_step"
        )
    if mishaps[CUT_SHORT]:
        told.append(
            f"molecules were wedged in: contacts still approached each other when a step ended "
            f"({mishaps[CUT_SHORT]} times); a shorter dynamics.time_step or more room helps"
        )
    return tuple(told)
