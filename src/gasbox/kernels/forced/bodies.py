"""What the kernels of the forced rule know of molecules: which discs belong together, and how they move as one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.forced.tables import BLOCK
from gasbox.state import State

__all__ = ["FLEXIBLE", "RIGID", "SINGLE", "Bodies", "Inner", "bodies"]

SINGLE, RIGID, FLEXIBLE = range(3)
"""A particle is a disc, or a body that turns, or discs with bonds between them."""

# Columns of `Bodies.sums`: momentum and kinetic energy of rigid bodies, energy of rotation, energy of motion within
# flexible molecules, and heat of a Langevin thermostat on rigid bodies.
BODY_PX, BODY_PY, BODY_KINETIC, ROTATION, VIBRATION, BODY_HEAT = range(6)


class Inner(NamedTuple):
    """What acts between the discs of flexible molecules; those of particle `row` are first[row] to first[row + 1].

    Attributes
    ----------
    bond_first : (n + 1,) int64; bond : (.., 2) int64, discs; bond_stiffness, bond_length : (..,) float64
    bend_first : (n + 1,) int64; bend : (.., 3) int64; bend_stiffness, bend_angle : (..,) float64, angles in rad
    pair_first : (n + 1,) int64; pair : (.., 2) int64, discs of one molecule that feel the force of their pair
    """

    bond_first: NDArray[np.int64]
    bond: NDArray[np.int64]
    bond_stiffness: NDArray[np.float64]
    bond_length: NDArray[np.float64]
    bend_first: NDArray[np.int64]
    bend: NDArray[np.int64]
    bend_stiffness: NDArray[np.float64]
    bend_angle: NDArray[np.float64]
    pair_first: NDArray[np.int64]
    pair: NDArray[np.int64]


class Bodies(NamedTuple):
    """All particles, and the discs of each, in the order of the state.

    Attributes
    ----------
    style : (n,) int64, SINGLE, RIGID or FLEXIBLE
    first : (n + 1,) int64, the discs of particle `row` are first[row] to first[row + 1]
    label : (n,) int64, id of the particle
    mass, rate, ease : (n,) float64; rate is 1/mass, ease is 1/inertia or 0
    inertia : (n,) float64, that of the state; of flexible molecules the present one
    x, y, vx, vy : (n,) float64, centre of mass of rigid bodies, perhaps outside a periodic box, and its velocity
    angle, turning : (n,) float64, of rigid bodies; turning is the angular velocity
    cos, sin : (n,) float64, of the angle
    fx, fy, torque : (n,) float64, on rigid bodies
    sums : (blocks, 6) float64, see the columns above
    owner : (m,) int64, particle of each disc; part : (m,) int64, its number there
    where : (m,) int64, place of each disc among the atoms
    px, py : (m,) float64, place in the molecule
    shift_x, shift_y : (m,) float64, whole number of boxes by which an atom lies beside its molecule
    inner : what acts within flexible molecules
    position, velocity : (n, 2) float64, of the state; shown_angle, shown_turning : (n,) float64, likewise
    """

    style: NDArray[np.int64]
    first: NDArray[np.int64]
    label: NDArray[np.int64]
    mass: NDArray[np.float64]
    rate: NDArray[np.float64]
    inertia: NDArray[np.float64]
    ease: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    vx: NDArray[np.float64]
    vy: NDArray[np.float64]
    angle: NDArray[np.float64]
    turning: NDArray[np.float64]
    cos: NDArray[np.float64]
    sin: NDArray[np.float64]
    fx: NDArray[np.float64]
    fy: NDArray[np.float64]
    torque: NDArray[np.float64]
    sums: NDArray[np.float64]
    owner: NDArray[np.int64]
    part: NDArray[np.int64]
    where: NDArray[np.int64]
    px: NDArray[np.float64]
    py: NDArray[np.float64]
    shift_x: NDArray[np.float64]
    shift_y: NDArray[np.float64]
    inner: Inner
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    shown_angle: NDArray[np.float64]
    shown_turning: NDArray[np.float64]


def bodies(state: State, inner: Inner) -> Bodies:
    """The molecules of a state, its discs still in the order of the state. Precondition: it has sites."""
    sites = state.sites
    assert sites is not None
    n, owner = state.count, sites.owner
    several = np.diff(sites.first) > 1
    style = np.where(several, np.where(sites.flexible, FLEXIBLE, RIGID), SINGLE).astype(np.int64)
    turns = state.inertia > 0.0

    def column(values: NDArray[np.float64] | float = 0.0) -> NDArray[np.float64]:
        array = np.zeros(n)
        array[:] = values
        return array

    return Bodies(
        style,
        sites.first,
        state.id,
        column(state.mass),
        column(1.0 / state.mass),
        state.inertia,
        column(np.where(turns, 1.0 / np.where(turns, state.inertia, 1.0), 0.0)),
        column(state.position[:, 0]),
        column(state.position[:, 1]),
        column(state.velocity[:, 0]),
        column(state.velocity[:, 1]),
        column(state.angle),
        column(state.angular_velocity),
        column(np.cos(state.angle)),
        column(np.sin(state.angle)),
        column(),
        column(),
        column(),
        np.zeros((n // BLOCK + 1, 6)),
        owner,
        np.arange(owner.size) - sites.first[owner],
        np.arange(owner.size),
        sites.place[:, 0].copy(),
        sites.place[:, 1].copy(),
        np.zeros(owner.size),
        np.zeros(owner.size),
        inner,
        state.position,
        state.velocity,
        state.angle,
        state.angular_velocity,
    )
