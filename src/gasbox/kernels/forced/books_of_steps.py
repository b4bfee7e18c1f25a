"""What comes after the forces of a step: thermostat, heating, barostat, and the books."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.forced.bath import (
    BAROSTAT,
    EVERY,
    OFF,
    P_FROM,
    THERMOSTAT,
    Bath,
    Sums,
    aim,
    factor,
    rescale,
    stretch,
    sum_atoms,
)
from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.crowd import Crowd
from gasbox.kernels.forced.lists_anew import Rule, box_of
from gasbox.kernels.forced.molecules import scale_bodies
from gasbox.kernels.forced.motion import scale
from gasbox.kernels.forced.tables import BLOCK, Books
from gasbox.kernels.team import meet

__all__ = ["Share", "end_step", "settle"]


class Share(NamedTuple):
    """What is a thread's own: blocks of atoms, and particles where there are molecules."""

    first: int
    last: int
    begin_body: int
    end_body: int


@inlined_kernel
def _rescale(crowd: Crowd, by: float, sums: Sums, mine: Share) -> None:
    begin, end = mine.first * BLOCK, mine.last * BLOCK
    rescale(crowd.atoms, crowd.bodies, by, sums.ux, sums.uy, begin, end, mine.begin_body, mine.end_body)


@inlined_kernel
def _scale(
    crowd: Crowd,
    bodies: Bodies | None,
    box: Box,
    by: float,
    mine: Share,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> None:
    """Multiply places by a factor, and divide velocities by it."""
    if bodies is None:
        scale(crowd.atoms, by, mine.first * BLOCK, mine.last * BLOCK)
    else:
        meet(flag, thread, threads)
        scale_bodies(bodies, crowd.atoms, box, by, mine.begin_body, mine.end_body)


@bare_kernel
def end_step(
    crowd: Crowd,
    rule: Rule,
    bath: Bath,
    books: Books,
    measured: bool,
    step: int,
    mine: Share,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> bool:
    """Thermostat, heating, and the books, after the last kick of step number `step`; whether the area changes."""
    room, drive, time = crowd.room, bath.drive, step * rule.time_step
    sums = sum_atoms(bath, room, crowd.bodies)
    by, heat, added = factor(bath, sums.thermal, rule.time_step, step, time)
    if by != 1.0:
        _rescale(crowd, by, sums, mine)
    thermal = sums.thermal + heat + added
    kinetic = sums.kinetic - sums.thermal + thermal
    rotation, vibration = sums.rotation * by * by, sums.vibration * by * by
    flying = thermal - rotation - vibration
    area = room.size[0] * room.size[1]
    if thread == 0:
        books.thermostat_heat[0] += heat + sums.heat
        books.heater_heat[0] += added
        if measured:
            books.now[0], books.now[1], books.now[2] = sums.potential, sums.virial, kinetic
        if step % EVERY == 0:
            duration = EVERY * rule.time_step
            books.kinetic_time[0] += flying * duration
            books.rotational_time[0] += rotation * duration
            books.vibrational_time[0] += vibration * duration
            books.potential_time[0] += sums.potential * duration
            books.pair_virial[0] += sums.virial * duration
            books.area_time[0] += area * duration
            books.measured_time[0] += duration
    if step % EVERY != 0 or drive[BAROSTAT] == 0.0:
        return False
    by = stretch(bath, thermal, flying, sums.virial, area, EVERY * rule.time_step, step, time)
    _scale(crowd, crowd.bodies, box_of(crowd, rule), by, mine, flag, thread, threads)
    if thread == 0:
        room.before[0] = kinetic + sums.potential
        room.before[1] = by
        room.before[2] = area
    return True


@bare_kernel
def settle(
    crowd: Crowd,
    rule: Rule,
    bath: Bath,
    books: Books,
    again: bool,
    step: int,
    mine: Share,
    thread: int,
) -> None:
    """Book energies where no step was made: before the first, or (`again`) after the area has changed.

    A change of the area gives and takes energy as a heat bath does. If there is no thermostat, the velocities take that
    back, so that the enthalpy stays as it was.
    """
    room = crowd.room
    sums = sum_atoms(bath, room, crowd.bodies)
    kinetic = sums.kinetic
    if again:
        work = sums.kinetic + sums.potential - room.before[0]
        if bath.drive[THERMOSTAT] == OFF and sums.thermal > 0.0:
            area = room.size[0] * room.size[1]
            excess = work + aim(bath.drive, P_FROM, step * rule.time_step) * (area - room.before[2])
            excess = min(excess, 0.5 * sums.thermal)
            by = math.sqrt((sums.thermal - excess) / sums.thermal)
            _rescale(crowd, by, sums, mine)
            kinetic -= excess
            work -= excess
        if thread == 0:
            books.barostat_work[0] += work
    if thread == 0:
        books.now[0], books.now[1], books.now[2] = sums.potential, sums.virial, kinetic
