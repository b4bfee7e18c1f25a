"""The step: kick, drift, look who is near, forces, kick; then thermostat, heating and barostat.

A step goes through stages, so that it can stop in the middle for longer lists or for contacts to be read.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import DONE, FULL, Gas, Ledger
from gasbox.kernels.forced.bath import (
    BAROSTAT,
    EVERY,
    LANGEVIN,
    OFF,
    P_FROM,
    POWER,
    THERMOSTAT,
    Bath,
    aim,
    factor,
    rescale,
    rub,
    stretch,
    sum_atoms,
    sum_blocks,
)
from gasbox.kernels.forced.lists_anew import GROW, Rule, box_of, list_share, sort_all
from gasbox.kernels.forced.motion import drift, furthest, kick, publish, scale, show
from gasbox.kernels.forced.push import push
from gasbox.kernels.forced.tables import BLOCK, Books, Crowd, Terms
from gasbox.kernels.forced.walls import Walls, push_back, turn_round
from gasbox.kernels.team import meet, share

__all__ = ["FORCE_FIRST", "GONE", "LISTED", "LIST_FIRST", "TOO_FAR", "advance"]

TOO_FAR = 21
"""Status: a disc has flown too far in one step."""
GONE = 22
"""Status: not all threads of the team came."""

LISTED = 23
"""Status: the first lists are made; atoms may be put to where they are by now, and stage FORCE_FIRST is next."""

MOVE, TURN, LOOK, LIST, FORCE, LIST_AGAIN, FORCE_AGAIN, LIST_FIRST, FORCE_FIRST = range(9)
"""Stages of a step; AGAIN follows a change of the area, FIRST comes before all steps."""


@bare_kernel
def _end(
    crowd: Crowd,
    rule: Rule,
    bath: Bath,
    books: Books,
    measured: bool,
    step: int,
    begin: int,
    end: int,
    thread: int,
) -> bool:
    """Thermostat, heating, and the books, after the last kick of step number `step`; whether the area changes."""
    atoms, room, drive = crowd.atoms, crowd.room, bath.drive
    n, time = room.stage[1], step * rule.time_step
    sums = sum_atoms(bath, room)
    by, heat, added = factor(bath, sums.thermal, n, rule.time_step, step, time)
    if by != 1.0:
        rescale(atoms, by, sums.ux, sums.uy, begin * BLOCK, end * BLOCK)
    thermal = sums.thermal + heat + added
    kinetic = sums.kinetic - sums.thermal + thermal
    area = room.size[0] * room.size[1]
    if thread == 0:
        books.thermostat_heat[0] += heat + sums.heat
        books.heater_heat[0] += added
        if measured:
            books.now[0], books.now[1], books.now[2] = sums.potential, sums.virial, kinetic
        if step % EVERY == 0:
            duration = EVERY * rule.time_step
            books.kinetic_time[0] += thermal * duration
            books.potential_time[0] += sums.potential * duration
            books.pair_virial[0] += sums.virial * duration
            books.area_time[0] += area * duration
            books.measured_time[0] += duration
    if step % EVERY != 0 or drive[BAROSTAT] == 0.0:
        return False
    by = stretch(bath, thermal, sums.virial, n, area, EVERY * rule.time_step, step, time)
    scale(atoms, by, begin * BLOCK, end * BLOCK)
    if thread == 0:
        room.before[0] = kinetic + sums.potential
        room.before[1] = by
        room.before[2] = area
    return True


@bare_kernel
def _settle(
    crowd: Crowd,
    rule: Rule,
    bath: Bath,
    books: Books,
    again: bool,
    step: int,
    begin: int,
    end: int,
    thread: int,
) -> None:
    """Book energies where no step was made: before the first, or (`again`) after the area has changed.

    A change of the area gives and takes energy as a heat bath does. If there is no thermostat, the velocities take that
    back, so that the enthalpy stays as it was.
    """
    room = crowd.room
    sums = sum_atoms(bath, room)
    kinetic = sums.kinetic
    if again:
        work = sums.kinetic + sums.potential - room.before[0]
        if bath.drive[THERMOSTAT] == OFF and sums.thermal > 0.0:
            area = room.size[0] * room.size[1]
            excess = work + aim(bath.drive, P_FROM, step * rule.time_step) * (area - room.before[2])
            excess = min(excess, 0.5 * sums.thermal)
            by = math.sqrt((sums.thermal - excess) / sums.thermal)
            rescale(crowd.atoms, by, sums.ux, sums.uy, begin * BLOCK, end * BLOCK)
            kinetic -= excess
            work -= excess
        if thread == 0:
            books.barostat_work[0] += work
    if thread == 0:
        books.now[0], books.now[1], books.now[2] = sums.potential, sums.virial, kinetic


@inlined_kernel
def _most(crowd: Crowd, threads: int) -> float:
    """Square of the largest way of all atoms since the lists were made; no number counts as the largest."""
    most = 0.0
    for thread in range(threads):
        if not crowd.room.far[thread] <= most:
            most = crowd.room.far[thread]
    return most


@inlined_kernel
def _any_full(crowd: Crowd, threads: int) -> bool:
    full = 0
    for thread in range(threads + 1):
        full += crowd.room.full[thread]
    return full > 0


@inlined_kernel
def _force(
    crowd: Crowd,
    terms: Terms,
    rule: Rule,
    gas: Gas,
    walls: Walls,
    book: Ledger,
    measured: bool,
    time: float,
    begin: int,
    end: int,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> None:
    """Forces on this thread's atoms; smooth walls book the impulse of a time `time`."""
    atoms, slots, lists, _, _ = crowd
    push(atoms, slots, lists, terms, rule.gx, rule.gy, measured, begin, end)
    if walls.strength > 0.0:
        meet(flag, thread, threads)
        if thread == 0:
            push_back(walls, atoms, gas, box_of(crowd, rule), book, time)
        meet(flag, thread, threads)


@bare_kernel
def advance(
    crowd: Crowd,
    terms: Terms,
    rule: Rule,
    bath: Bath,
    gas: Gas,
    walls: Walls,
    book: Ledger,
    books: Books,
    clock: NDArray[np.int64],
    target: int,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> int:
    """Take whole steps until step number `target`, as one of a team of threads.

    Parameters
    ----------
    clock : (1,) int64, steps done; counted on here
    target : step to stop at
    flag : where the team meets, new for each call (`gasbox.kernels.team`)
    thread, threads : which one of how many

    Returns
    -------
    DONE, FULL (read the contacts, call again), GROW, LISTED, TOO_FAR or GONE; the same for each thread.

    Precondition: in stage LIST_FIRST, atoms stand where the lists are to be made; in stage FORCE_FIRST, lists are made.
    """
    atoms, slots, _, _, room = crowd
    # What other threads may change is read before the first meeting.
    stage, step, n = room.stage[0], clock[0], room.stage[1]
    first, last = share(room.sums.shape[0], thread, threads)
    begin, end = first * BLOCK, last * BLOCK
    step_time, half = rule.time_step, 0.5 * rule.time_step
    if not meet(flag, thread, threads):
        return GONE
    status = DONE
    while step < target or stage != MOVE:
        if stage == MOVE:
            kick(atoms, half, begin, end)
            if bath.drive[THERMOSTAT] == LANGEVIN:
                drift(atoms, half, begin, end)
                rub(atoms, bath, room, gas.id, step_time, step + 1, (step + 0.5) * step_time, first, last)
                drift(atoms, half, begin, end)
            else:
                drift(atoms, step_time, begin, end)
            stage = TURN if walls.strength == 0.0 and walls.hall.kind.shape[0] > 0 else LOOK
        if stage == TURN:
            meet(flag, thread, threads)
            if thread == 0:
                time = (step + 1) * step_time
                room.full[threads] = turn_round(walls, atoms, gas, box_of(crowd, rule), book, time, step_time)
            meet(flag, thread, threads)
            if room.full[threads]:
                status = FULL
                break
            stage = LOOK
        if stage == LOOK:
            room.far[thread] = furthest(atoms, begin, end)
            meet(flag, thread, threads)
            most = _most(crowd, threads)
            if not most <= (0.5 * rule.skin + rule.most) ** 2:
                status = TOO_FAR
                break
            stage = LIST if most > 0.25 * rule.skin * rule.skin else FORCE
        elif stage in (LIST, LIST_AGAIN, LIST_FIRST):
            room.full[thread] = 0
            if thread == 0:
                room.full[threads] = sort_all(crowd, terms, rule, gas, walls)
            meet(flag, thread, threads)
            if not room.full[threads]:
                room.full[thread] = list_share(crowd, terms, rule, begin, min(end, n), thread, threads)
            meet(flag, thread, threads)
            if _any_full(crowd, threads):
                status = GROW
                break
            if stage == LIST_FIRST:
                stage, status = FORCE_FIRST, LISTED
                break
            stage = FORCE if stage == LIST else FORCE_AGAIN
        if stage in (FORCE, FORCE_AGAIN, FORCE_FIRST):
            begin_slot, end_slot = share(slots.size[0], thread, threads)
            publish(atoms, slots, begin_slot, end_slot)
            meet(flag, thread, threads)
            steps = 1 if stage == FORCE else 0
            step += steps
            measured = step % EVERY == 0 or step == target or steps == 0
            time, mine = steps * step_time, min(end, n)
            _force(crowd, terms, rule, gas, walls, book, measured, time, begin, mine, flag, thread, threads)
            if steps == 1:
                kick(atoms, half, begin, end)
            if measured or bath.drive[THERMOSTAT] != OFF or bath.drive[POWER] != 0.0:
                sum_blocks(atoms, room, measured, first, last)
                meet(flag, thread, threads)
                changes = False
                if steps == 1:
                    changes = _end(crowd, rule, bath, books, measured, step, first, last, thread)
                else:
                    _settle(crowd, rule, bath, books, stage == FORCE_AGAIN, step, first, last, thread)
                meet(flag, thread, threads)
                stage = LIST_AGAIN if changes else MOVE
                if changes and thread == 0:
                    room.size[0] *= room.before[1]
                    room.size[1] *= room.before[1]
            else:
                stage = MOVE
    if thread == 0:
        room.stage[0], clock[0] = stage, step
    if status == DONE:
        show(atoms, gas, box_of(crowd, rule), begin, min(end, n))
    return status
