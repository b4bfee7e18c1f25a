"""Thermostats, heating and barostat, on sums that are taken in fixed blocks.

Langevin: B. Leimkuhler, C. Matthews, Appl. Math. Res. Express 2013, 34, doi:10.1093/amrx/abs010 (the order BAOAB).
Stochastic velocity rescaling: G. Bussi, D. Donadio, M. Parrinello, J. Chem. Phys. 126, 014101 (2007),
doi:10.1063/1.2408420. Stochastic cell rescaling: M. Bernetti, G. Bussi, J. Chem. Phys. 153, 114107 (2020),
doi:10.1063/5.0020514; here with the compressibility of an ideal gas, A/(N T), whatever the phase: it only sets the
pace, and makes the mobility of ln A independent of A. Without a thermostat the enthalpy is kept: see `advance`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.molecules_bath import body_sums, part_of, rescale_bodies, rub_bodies
from gasbox.kernels.forced.noise import gamma, gaussians
from gasbox.kernels.forced.tables import BLOCK, HEAT, KINETIC, MASS, POTENTIAL, PX, PY, VIRIAL, Atoms, Room
from gasbox.kernels.lanes import WIDTH, choose, load, spread, store, total
from gasbox.rng import Stream

__all__ = ["EVERY", "Bath", "Sums", "aim", "factor", "rescale", "rub", "stretch", "sum_atoms", "sum_blocks"]

# Columns of `Bath.drive`: the thermostat's kind, its aim from, to, begin and end of the way between, its time; whether
# the barostat is on, likewise; power for each disc.
THERMOSTAT, T_FROM, T_TO, T_BEGIN, T_END, T_TIME, BAROSTAT, P_FROM, P_TO, P_BEGIN, P_END, P_TIME, POWER = (
    range(13)
)
# Kinds of thermostat.
OFF, LANGEVIN, RESCALING = range(3)

EVERY = 10
"""Steps between two measurements of energy and virial, and between two changes of the area."""
_MOST = 0.05
"""Largest change of ln A at once, apart from noise."""
_LANGEVIN, _RESCALING, _BAROSTAT = int(Stream.LANGEVIN), int(Stream.RESCALING), int(Stream.BAROSTAT)


class Bath(NamedTuple):
    """What acts on the gas as a whole.

    Attributes
    ----------
    drive : (13,) float64, see the columns above
    seed : (2,) int64, halves of the scenario's seed
    particles : how many there are
    freedom : degrees of freedom
    drifts_x, drifts_y : whether momentum along x, along y is conserved, so that it is no heat
    """

    drive: NDArray[np.float64]
    seed: NDArray[np.int64]
    particles: int
    freedom: int
    drifts_x: bool
    drifts_y: bool


class Sums(NamedTuple):
    """Of all atoms: velocity that is no heat, thermal kinetic energy, whole one, potential energy, virial, heat.

    And what part of the kinetic energy is rotation, or motion within flexible molecules.
    """

    ux: float
    uy: float
    thermal: float
    kinetic: float
    potential: float
    virial: float
    heat: float
    rotation: float
    vibration: float


@inlined_kernel
def aim(drive: NDArray[np.float64], first: int, time: float) -> float:
    """What a thermostat or barostat aims at: on the way from drive[first] to drive[first + 1]."""
    begin, end = drive[first + 2], drive[first + 3]
    if time >= end:
        return drive[first + 1]
    share = max(time - begin, 0.0) / (end - begin)
    return drive[first] + share * (drive[first + 1] - drive[first])


@bare_kernel
def rub(
    atoms: Atoms,
    bodies: Bodies | None,
    bath: Bath,
    room: Room,
    id: NDArray[np.int64],
    time_step: float,
    step: int,
    time: float,
    begin: int,
    end: int,
    begin_body: int,
    end_body: int,
) -> None:
    """Friction and noise of the Langevin thermostat in one step, for blocks `begin` to `end`.

    begin_body, end_body : likewise, of molecules
    """
    keep = math.exp(-time_step / bath.drive[T_TIME])
    noise = math.sqrt((1.0 - keep * keep) * max(aim(bath.drive, T_FROM, time), 0.0))
    for block in range(begin, end):
        heat = 0.0
        for k in range(block * BLOCK, min((block + 1) * BLOCK, room.stage[1])):
            if atoms.rate[k] == 0.0:
                continue
            site = atoms.row[k]
            one, two = gaussians(bath.seed, _LANGEVIN, id[site], part_of(bodies, site), step)
            spreading = noise * math.sqrt(atoms.rate[k])
            vx, vy = keep * atoms.vx[k] + spreading * one, keep * atoms.vy[k] + spreading * two
            heat += 0.5 * atoms.mass[k] * (vx**2 - atoms.vx[k] ** 2 + vy**2 - atoms.vy[k] ** 2)
            atoms.vx[k], atoms.vy[k] = vx, vy
        room.sums[block, HEAT] = heat
    rub_bodies(bodies, keep, noise, bath.seed, step, begin_body, end_body)


@bare_kernel
def sum_blocks(atoms: Atoms, room: Room, measured: bool, begin: int, end: int) -> None:
    """Sums over each of the blocks `begin` to `end`."""
    for block in range(begin, end):
        mass, px, py, square = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        u, w = spread(0.0), spread(0.0)
        for k in range(block * BLOCK, (block + 1) * BLOCK, WIDTH):
            m, vx, vy = load(atoms.mass, k), load(atoms.vx, k), load(atoms.vy, k)
            mass, px, py = mass + m, px + m * vx, py + m * vy
            square = square + m * (vx * vx + vy * vy)
            if measured:
                u, w = u + load(atoms.u, k), w + load(atoms.w, k)
        room.sums[block, MASS] = total(mass)
        room.sums[block, PX], room.sums[block, PY] = total(px), total(py)
        room.sums[block, KINETIC] = 0.5 * total(square)
        room.sums[block, POTENTIAL], room.sums[block, VIRIAL] = total(u), total(w)


@bare_kernel
def sum_atoms(bath: Bath, room: Room, bodies: Bodies | None) -> Sums:
    """Sums over all blocks, in their order."""
    mass, px, py, kinetic, potential, virial, heat = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for block in range(room.sums.shape[0]):
        mass += room.sums[block, MASS]
        px += room.sums[block, PX]
        py += room.sums[block, PY]
        kinetic += room.sums[block, KINETIC]
        potential += room.sums[block, POTENTIAL]
        virial += room.sums[block, VIRIAL]
        heat += room.sums[block, HEAT]
    rotation, vibration = 0.0, 0.0
    if bodies is not None:
        body_px, body_py, body_kinetic, rotation, vibration, body_heat = body_sums(bodies)
        px, py, kinetic, heat = px + body_px, py + body_py, kinetic + body_kinetic, heat + body_heat
    ux = px / mass if bath.drifts_x and mass > 0.0 else 0.0
    uy = py / mass if bath.drifts_y and mass > 0.0 else 0.0
    thermal = kinetic - 0.5 * mass * (ux * ux + uy * uy)
    return Sums(ux, uy, thermal, kinetic, potential, virial, heat, rotation, vibration)


@bare_kernel
def factor(
    bath: Bath, kinetic: float, time_step: float, step: int, time: float
) -> tuple[float, float, float]:
    """By what thermal velocities are multiplied in this step; heat of the thermostat, and of the heating."""
    drive, freedom = bath.drive, float(bath.freedom)
    if not kinetic > 0.0 or freedom == 0.0:
        return 1.0, 0.0, 0.0
    aimed = kinetic
    if drive[THERMOSTAT] == RESCALING:
        keep = math.exp(-time_step / drive[T_TIME])
        mean = 0.5 * aim(drive, T_FROM, time) / kinetic
        one, _ = gaussians(bath.seed, _RESCALING, 0, 0, step)
        squares = one * one
        if freedom > 1.0:
            squares += 2.0 * gamma(bath.seed, _RESCALING, 0.5 * (freedom - 1.0), step)
        part = (1.0 - keep) * mean
        aimed *= max(keep + part * squares + 2.0 * one * math.sqrt(keep * part), 0.0)
    added = max(drive[POWER] * bath.particles * time_step, -aimed)
    return math.sqrt((aimed + added) / kinetic), aimed - kinetic, added


@bare_kernel
def rescale(
    atoms: Atoms,
    bodies: Bodies | None,
    by: float,
    ux: float,
    uy: float,
    begin: int,
    end: int,
    begin_body: int,
    end_body: int,
) -> None:
    """Multiply velocities relative to (ux, uy), but not where there is no atom. begin, end : multiples of WIDTH."""
    for k in range(begin, end, WIDTH):
        taken = load(atoms.rate, k) > 0.0
        vx, vy = load(atoms.vx, k), load(atoms.vy, k)
        store(atoms.vx, k, choose(taken, (vx - ux) * by + ux, vx))
        store(atoms.vy, k, choose(taken, (vy - uy) * by + uy, vy))
    rescale_bodies(bodies, by, ux, uy, begin_body, end_body)


@bare_kernel
def stretch(
    bath: Bath,
    thermal: float,
    flying: float,
    virial: float,
    area: float,
    duration: float,
    step: int,
    time: float,
) -> float:
    """By what the barostat multiplies all lengths, after a time `duration` without it.

    thermal, flying : thermal kinetic energy, and that of centres of mass alone

    d ln A = [(P - P0) A + T] / (N T tau) dt + sqrt(2 / (N tau)) dW, with the present pressure P and the thermostat's
    aim, or the present temperature, T. The centre of mass, whose motion is no heat, counts to the pressure with T. So A
    is distributed as the partition function at A times exp(-P0 A / T), of an ideal gas as A^N exp(-P0 A / T).
    """
    drive = bath.drive
    temperature = 2.0 * thermal / bath.freedom
    if drive[THERMOSTAT] != OFF:
        temperature = aim(drive, T_FROM, time)
    n = bath.particles
    if n == 0 or not temperature > 0.0:
        return 1.0
    push = flying + 0.5 * virial + 2.0 * temperature - aim(drive, P_FROM, time) * area
    pace = duration / (n * drive[P_TIME])
    one, _ = gaussians(bath.seed, _BAROSTAT, 0, 0, step)
    change = max(-_MOST, min(push / temperature * pace, _MOST))
    return math.exp(0.5 * (change + math.sqrt(2.0 * pace) * one))
