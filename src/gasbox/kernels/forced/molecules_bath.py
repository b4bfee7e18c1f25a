"""Thermostats and sums of molecules, in fixed blocks: as `gasbox.kernels.forced.bath` does it with discs."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.forced.bodies import (
    BODY_HEAT,
    BODY_KINETIC,
    BODY_PX,
    BODY_PY,
    FLEXIBLE,
    RIGID,
    ROTATION,
    VIBRATION,
    Bodies,
)
from gasbox.kernels.forced.molecules import spin
from gasbox.kernels.forced.noise import gaussians
from gasbox.kernels.forced.tables import BLOCK, Atoms
from gasbox.rng import Stream

__all__ = ["body_sums", "part_of", "rescale_bodies", "rub_bodies", "sum_bodies"]

_LANGEVIN, _SPIN = int(Stream.LANGEVIN), int(Stream.LANGEVIN_SPIN)


@inlined_kernel
def part_of(bodies: Bodies | None, site: int) -> int:
    """Number of a disc in its molecule."""
    if bodies is None:
        return 0
    return bodies.part[site]


@bare_kernel
def rub_bodies(
    bodies: Bodies | None, keep: float, noise: float, seed: NDArray[np.int64], step: int, begin: int, end: int
) -> None:
    """Friction and noise on rigid bodies, for blocks `begin` to `end`.

    keep : share of a velocity that stays; noise : of the others, in units of 1/sqrt(mass)
    """
    if bodies is None:
        return
    for block in range(begin, end):
        heat = 0.0
        for row in range(block * BLOCK, min((block + 1) * BLOCK, bodies.style.shape[0])):
            if bodies.style[row] != RIGID:
                continue
            one, two = gaussians(seed, _LANGEVIN, bodies.label[row], 0, step)
            three, _ = gaussians(seed, _SPIN, bodies.label[row], 0, step)
            spreading = noise * math.sqrt(bodies.rate[row])
            vx = keep * bodies.vx[row] + spreading * one
            vy = keep * bodies.vy[row] + spreading * two
            turning = keep * bodies.turning[row] + noise * math.sqrt(bodies.ease[row]) * three
            heat += 0.5 * bodies.mass[row] * (vx**2 - bodies.vx[row] ** 2 + vy**2 - bodies.vy[row] ** 2)
            if bodies.ease[row] > 0.0:
                heat += 0.5 * bodies.inertia[row] * (turning**2 - bodies.turning[row] ** 2)
                bodies.turning[row] = turning
            bodies.vx[row], bodies.vy[row] = vx, vy
        bodies.sums[block, BODY_HEAT] = heat


@bare_kernel
def sum_bodies(bodies: Bodies | None, atoms: Atoms, box: Box, measured: bool, begin: int, end: int) -> None:
    """Sums over each of the blocks `begin` to `end`; of what is within flexible molecules, if that is asked for."""
    if bodies is None:
        return
    for block in range(begin, end):
        px, py, kinetic, rotation, vibration = 0.0, 0.0, 0.0, 0.0, 0.0
        for row in range(block * BLOCK, min((block + 1) * BLOCK, bodies.style.shape[0])):
            if bodies.style[row] == RIGID:
                vx, vy, mass = bodies.vx[row], bodies.vy[row], bodies.mass[row]
                turns = 0.5 * bodies.inertia[row] * bodies.turning[row] ** 2
                px += mass * vx
                py += mass * vy
                kinetic += 0.5 * mass * (vx * vx + vy * vy) + turns
                rotation += turns
            elif bodies.style[row] == FLEXIBLE and measured:
                inertia, momentum, within = spin(bodies, atoms, box, row)
                turns = 0.5 * momentum * momentum / inertia if inertia > 0.0 else 0.0
                rotation += turns
                vibration += within - turns
        bodies.sums[block, BODY_PX], bodies.sums[block, BODY_PY] = px, py
        bodies.sums[block, BODY_KINETIC] = kinetic
        bodies.sums[block, ROTATION], bodies.sums[block, VIBRATION] = rotation, vibration


@bare_kernel
def body_sums(bodies: Bodies | None) -> tuple[float, float, float, float, float, float]:
    """Sums over all blocks, in their order: the columns of `Bodies.sums`."""
    px, py, kinetic, rotation, vibration, heat = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    if bodies is None:
        return px, py, kinetic, rotation, vibration, heat
    for block in range(bodies.sums.shape[0]):
        px += bodies.sums[block, BODY_PX]
        py += bodies.sums[block, BODY_PY]
        kinetic += bodies.sums[block, BODY_KINETIC]
        rotation += bodies.sums[block, ROTATION]
        vibration += bodies.sums[block, VIBRATION]
        heat += bodies.sums[block, BODY_HEAT]
    return px, py, kinetic, rotation, vibration, heat


@bare_kernel
def rescale_bodies(bodies: Bodies | None, by: float, ux: float, uy: float, begin: int, end: int) -> None:
    """Multiply the velocities of rigid bodies, relative to (ux, uy), and their angular velocities."""
    if bodies is None:
        return
    for row in range(begin, end):
        if bodies.style[row] == RIGID:
            bodies.vx[row] = (bodies.vx[row] - ux) * by + ux
            bodies.vy[row] = (bodies.vy[row] - uy) * by + uy
            bodies.turning[row] *= by
