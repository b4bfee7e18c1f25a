"""The elastic collision of rigid molecules: an impulse along the line through the centres of the discs that touch.

Symbols: n unit normal at the contact, towards the molecule; v velocity, m mass of a molecule.

Source: D. Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation II, SIGGRAPH course notes
(1997), section 8, in two dimensions.
"""

from __future__ import annotations

from gasbox.jit import inlined_kernel

__all__ = ["blow", "closing_speed", "lever", "yielding"]


@inlined_kernel
def lever(arm_x: float, arm_y: float, nx: float, ny: float) -> float:
    """How far the line of an impulse along n passes by the centre of mass, positive if it turns counter-clockwise.

    arm_x, arm_y : from the centre of mass to the centre of the disc that is hit, or to any other point of the line
    """
    return arm_x * ny - arm_y * nx


@inlined_kernel
def yielding(mass: float, inertia: float, lever: float) -> float:
    """How much the speed along n of the point that is hit changes for each unit of impulse [1/mass].

    inertia : 0 of what does not rotate
    """
    if inertia == 0.0:
        return 1.0 / mass
    return 1.0 / mass + lever * lever / inertia


@inlined_kernel
def closing_speed(
    dvx: float,
    dvy: float,
    nx: float,
    ny: float,
    omega_i: float,
    lever_i: float,
    omega_j: float,
    lever_j: float,
) -> float:
    """Relative speed along n, at the contact, of molecules i and j; negative while they approach [length/time].

    Parameters
    ----------
    dvx, dvy : velocity of the centre of mass of i minus that of j [length/time]
    nx, ny : unit normal from j to i
    omega_i, omega_j : angular velocities [rad/time]
    lever_i, lever_j : of the impulse about each centre of mass (`lever`) [length]
    """
    return dvx * nx + dvy * ny + omega_i * lever_i - omega_j * lever_j


@inlined_kernel
def blow(closing: float, yielding_i: float, yielding_j: float) -> float:
    """Impulse along n [momentum] of an elastic collision: i is given it, j its opposite.

    The velocity of i changes by impulse/m n, its angular velocity by impulse times lever/inertia. Energy, momentum and
    angular momentum are conserved. Against a wall at rest `yielding_j` is 0, against a piston 1/(its mass).
    """
    return -2.0 * closing / (yielding_i + yielding_j)
