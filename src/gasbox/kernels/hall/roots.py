"""When something falls through zero: the first time, and none is ever missed.

Where a closed form would lose roots (a disc under gravity and a corner, the rim of a circle, or a wall that swings)
the way is marched: from a value f >= 0 with slope f', and a bound M on how fast the slope can fall, f stays above
f + f' t - M t²/2, so up to the zero of this parabola nothing can have happened. At a simple zero the steps are those of
Newton's method, from one side, and converge as fast.
"""

from __future__ import annotations

import math

from gasbox.jit import inlined_kernel

__all__ = ["CLOSE", "GRAZING_SPEED", "MARCHES", "first_fall", "safe_step"]

GRAZING_SPEED = 1e-13
"""An approach slower than this part of the relative speed is none: rounding could not tell its sign."""
CLOSE = 1e-9
"""Of the lengths involved: so near a zero the march goes over to Newton's method, which then doubles the digits."""
MARCHES = 2000
"""Most steps of a march; a disc that needs more than some dozens rolls along the wall."""


@inlined_kernel
def first_fall(c: float, b: float, a: float, depth: float, least: float) -> float:
    """First t >= 0 at which c + b t + a t²/2 falls through zero; infinity if it never does.

    Parameters
    ----------
    c, b, a : value, slope and curvature at zero
    depth : a value between -depth and 0 counts as zero; one that is deeper must come up first
    least : slopes between -least and 0 count as zero
    """
    if c <= 0.0:
        if c >= -depth and (b < -least or (b <= 0.0 and a < 0.0)):
            return 0.0
        if b > 0.0 and a < 0.0:
            inside = b * b - 2.0 * a * c
            if inside > 0.0:
                return (b + math.sqrt(inside)) / -a
            # By rounding it never comes quite up: it touches from where it begins to fall.
            return b / -a if c >= -depth else math.inf
        return math.inf
    if b < 0.0:
        inside = b * b - 2.0 * a * c
        return math.inf if inside <= 0.0 else 2.0 * c / (math.sqrt(inside) - b)
    return (b + math.sqrt(b * b - 2.0 * a * c)) / -a if a < 0.0 else math.inf


@inlined_kernel
def safe_step(f: float, slope: float, bound: float) -> float:
    """How far one can go from a value f >= 0 before it can have fallen to zero; see the top of this file."""
    root = math.sqrt(slope * slope + 2.0 * bound * f)
    if slope < 0.0:
        return 2.0 * f / (root - slope)
    return (slope + root) / bound if bound > 0.0 else math.inf
