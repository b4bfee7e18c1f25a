"""The elastic collision of two discs, as every hard-disc dynamics executes it."""

from __future__ import annotations

from gasbox.jit import inlined_kernel

__all__ = ["exchange", "nearest"]


@inlined_kernel
def nearest(difference: float, length: float, periodic: bool) -> float:
    """The component of a difference of two positions, taken to the nearest image if `periodic`.

    Precondition: the nearest image is at most one length away, or the direction is not periodic.
    """
    if periodic:
        if difference > 0.5 * length:
            return difference - length
        if difference < -0.5 * length:
            return difference + length
    return difference


@inlined_kernel
def exchange(
    dx: float, dy: float, dvx: float, dvy: float, mass_i: float, mass_j: float
) -> tuple[float, float, float, float]:
    """The scale factors of an elastic collision along the line of centres.

    Parameters
    ----------
    dx, dy : centre of i minus centre of j [length], not both zero
    dvx, dvy : velocity of i minus velocity of j [length/time]
    mass_i, mass_j : [mass]

    Returns
    -------
    change_i, change_j : velocity of i changes by -change_i (dx, dy), that of j by +change_j (dx, dy)
    impulse : i is given -impulse (dx, dy) [mass/time]
    virial : |impulse| times the distance of the centres [energy], positive for an approaching pair

    Source: v1' = v1 - 2 m2/(m1+m2) ((v1-v2).(x1-x2)/|x1-x2|^2) (x1-x2); any textbook of mechanics.
    """
    along = (dvx * dx + dvy * dy) / (dx * dx + dy * dy)
    total = mass_i + mass_j
    impulse = 2.0 * mass_i * mass_j / total * along
    return (
        2.0 * mass_j / total * along,
        2.0 * mass_i / total * along,
        impulse,
        -impulse * (dx * dx + dy * dy),
    )
