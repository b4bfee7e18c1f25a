"""The step: kick, drift, look who is near, forces, kick; then thermostat, heating and barostat.

A step goes through stages, so that it can stop in the middle for longer lists or for contacts to be read.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import DONE, FULL, Gas, Ledger
from gasbox.kernels.forced.bath import EVERY, LANGEVIN, OFF, POWER, THERMOSTAT, Bath, rub
from gasbox.kernels.forced.books_of_steps import Share, end_step, settle
from gasbox.kernels.forced.crowd import Crowd
from gasbox.kernels.forced.lists_anew import GROW, Rule, box_of, list_share, sort_all
from gasbox.kernels.forced.molecule_walls import turn_all_round
from gasbox.kernels.forced.molecules import drift_bodies, face, kick_bodies
from gasbox.kernels.forced.motion import drift, furthest, kick, publish
from gasbox.kernels.forced.passing import note_places
from gasbox.kernels.forced.phases import blocks_of, follow, force, rows_of, show_all, sum_all
from gasbox.kernels.forced.tables import BLOCK, Books, Terms
from gasbox.kernels.forced.wall_tables import Walls, note_walls, stand
from gasbox.kernels.team import meet, share

__all__ = ["FORCE_FIRST", "GONE", "LEFT", "LISTED", "LIST_FIRST", "TOO_FAR", "WALL_TOO_FAR", "advance"]

TOO_FAR = 21
"""Status: a disc has flown too far in one step."""
GONE = 22
"""Status: not all threads of the team came."""

LISTED = 23
"""Status: the first lists are made; atoms may be put to where they are by now, and stage FORCE_FIRST is next."""

LEFT = 24
"""Status: discs have left through an open wall; take them out of the state."""
WALL_TOO_FAR = 25
"""Status: a wall has moved too far in one step."""

MOVE, TURN, LOOK, LIST, FORCE, LIST_AGAIN, FORCE_AGAIN, LIST_FIRST, FORCE_FIRST = range(9)
"""Stages of a step; AGAIN follows a change of the area, FIRST comes before all steps."""


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
    DONE, FULL (read the contacts, call again), GROW, LISTED, LEFT, TOO_FAR, WALL_TOO_FAR or GONE; the same for each
    thread.

    Precondition: in stage LIST_FIRST, atoms stand where the lists are to be made; in stage FORCE_FIRST, lists are made.
    """
    atoms, slots, _, _, room, bodies = crowd
    # What other threads may change is read before the first meeting.
    stage, step, n = room.stage[0], clock[0], room.stage[1]
    first, last = share(room.sums.shape[0], thread, threads)
    begin, end = first * BLOCK, last * BLOCK
    first_body, last_body = blocks_of(bodies, thread, threads)
    begin_body, end_body = rows_of(bodies, thread, threads)
    step_time, half = rule.time_step, 0.5 * rule.time_step
    if not meet(flag, thread, threads):
        return GONE
    status = DONE
    while step < target or stage != MOVE:
        if stage == MOVE:
            note_places(walls, atoms, begin, end)
            kick(atoms, half, begin, end)
            kick_bodies(bodies, half, begin_body, end_body)
            if bath.drive[THERMOSTAT] == LANGEVIN:
                time = (step + 0.5) * step_time
                drift(atoms, half, begin, end)
                drift_bodies(bodies, half, begin_body, end_body)
                rub(
                    atoms,
                    bodies,
                    bath,
                    room,
                    gas.id,
                    step_time,
                    step + 1,
                    time,
                    first,
                    last,
                    first_body,
                    last_body,
                )
                drift(atoms, half, begin, end)
                drift_bodies(bodies, half, begin_body, end_body)
            else:
                drift(atoms, step_time, begin, end)
                drift_bodies(bodies, step_time, begin_body, end_body)
            follow(bodies, atoms, box_of(crowd, rule), flag, thread, threads)
            if thread == 0 and walls.hall.moving.shape[0] > 0:
                stand(walls, (step + 1) * step_time)
            stage = TURN if walls.strength == 0.0 and walls.hall.kind.shape[0] > 0 else LOOK
        if stage == TURN:
            meet(flag, thread, threads)
            if thread == 0:
                time, box = (step + 1) * step_time, box_of(crowd, rule)
                room.full[threads] = turn_all_round(bodies, walls, atoms, gas, box, book, time, step_time)
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
            if not walls.way[0] <= (0.5 * rule.skin + rule.most) ** 2:
                status = WALL_TOO_FAR
                break
            stage = LIST if max(most, walls.way[0]) > 0.25 * rule.skin * rule.skin else FORCE
        elif stage in (LIST, LIST_AGAIN, LIST_FIRST):
            room.full[thread] = 0
            if thread == 0:
                if stage == LIST:
                    note_walls(walls)
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
            if stage == FORCE_FIRST:
                face(bodies, begin_body, end_body)
            begin_slot, end_slot = share(slots.size[0], thread, threads)
            publish(atoms, slots, begin_slot, end_slot)
            meet(flag, thread, threads)
            steps = 1 if stage == FORCE else 0
            step += steps
            measured = step % EVERY == 0 or step == target or steps == 0
            time, mine = steps * step_time, min(end, n)
            force(crowd, terms, rule, gas, walls, book, measured, time, begin, mine, flag, thread, threads)
            if steps == 1:
                kick(atoms, half, begin, end)
                kick_bodies(bodies, half, begin_body, end_body)
            if measured or bath.drive[THERMOSTAT] != OFF or bath.drive[POWER] != 0.0:
                sum_all(crowd, rule, measured, first, last, flag, thread, threads)
                ours = Share(first, last, begin_body, end_body)
                changes = False
                if steps == 1:
                    changes = end_step(crowd, rule, bath, books, measured, step, ours, flag, thread, threads)
                else:
                    settle(crowd, rule, bath, books, stage == FORCE_AGAIN, step, ours, thread)
                meet(flag, thread, threads)
                stage = LIST_AGAIN if changes else MOVE
                if changes and thread == 0:
                    room.size[0] *= room.before[1]
                    room.size[1] *= room.before[1]
            else:
                stage = MOVE
            if walls.left[0] > 0:
                status = LEFT
                break
    if thread == 0:
        room.stage[0], clock[0] = stage, step
    if status in (DONE, LEFT):
        show_all(crowd, rule, gas, begin, min(end, n), bodies, begin_body, end_body)
    return status
