"""What went wrong with molecules under the stepped rule, in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.stepped.bodies import CUT_SHORT, DEEP, DEEPEST, HELD_BACK

__all__ = ["mishaps_told", "step_too_long"]


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


def step_too_long(time: float, time_step: float, most: float, speed: float, by_wall: bool) -> str:
    """A sentence on a step of `time_step` in which a disc, or a wall, went further than `most`.

    speed : root mean square of the discs [length/time]
    """
    if by_wall:
        return (
            f"at time {time:g} a wall moved further than {most:.3g} in one step of {time_step:g}: let it move more "
            f"slowly, or shorten dynamics.time_step"
        )
    return (
        f"at time {time:g} a disc flew further than {most:.3g} in one step of {time_step:g}: the time step is too long "
        f"for these forces and speeds (rms speed {speed:.3g} at the last measurement); shorten dynamics.time_step, say "
        f"to {time_step / 4:.2g}"
    )
