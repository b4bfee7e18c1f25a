"""The step, phase by phase."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import DONE, FULL, Box, Gas, Ledger
from gasbox.kernels.stepped.bodies import Bodies, carry, show_bodies
from gasbox.kernels.stepped.execute import execute
from gasbox.kernels.stepped.filing import count, drift, file, fly, number, show
from gasbox.kernels.stepped.look import look
from gasbox.kernels.stepped.near import find, mark, move_walls
from gasbox.kernels.stepped.sweep import execute_bodies
from gasbox.kernels.stepped.tables import Grid, Room, Slots, Walls
from gasbox.kernels.team import meet

__all__ = ["GONE", "GROW", "LEFT", "advance"]

GROW = 10
"""Status: the lists of what touches are too short; give longer ones with the same progress and call again."""
GONE = 11
"""Status: not all threads of the team came."""
LEFT = 12
"""Status: so many discs have left the gas that it is time to let go of them."""
_MANY = 64
"""Discs that have left before the kernel says so; they cost a little each step."""

_DRIFT, _LOOK, _EXECUTE = 0, 1, 2


@bare_kernel
def _begin(room: Room, bodies: Bodies | None, threads: int) -> None:
    """Go on to the execution, if all that was found has been listed."""
    room.progress[0] = _EXECUTE
    if bodies is not None:
        bodies.cursor[:] = 0
    for thread in range(threads):
        room.lists.done[thread] = 0
        if room.lists.found[thread] > room.lists.key.shape[1]:
            room.progress[0] = _LOOK


@inlined_kernel
def _move(
    slots: Slots,
    box: Box,
    walls: Walls | None,
    bodies: Bodies | None,
    time_step: float,
    time: float,
    thread: int,
    threads: int,
) -> None:
    """Move this thread's share of the discs; the first thread moves the walls."""
    if bodies is not None:
        carry(bodies, slots, box, walls, time_step, thread, threads)
    elif walls is None:
        drift(slots, box, time_step, thread, threads)
    else:
        fly(slots, box, walls, time_step, thread, threads)
    if walls is not None and thread == 0:
        move_walls(walls, time_step, time)


@inlined_kernel
def _execute(
    slots: Slots,
    gas: Gas,
    box: Box,
    grid: Grid,
    room: Room,
    walls: Walls | None,
    bodies: Bodies | None,
    book: Ledger,
    time: float,
    threads: int,
) -> bool:
    """Execute what was found; False if the contacts are full."""
    if bodies is not None:
        return execute_bodies(slots, gas, bodies, box, grid, room.lists, walls, book, time, threads)
    return execute(slots, gas, box, grid, room.lists, walls, book, time, threads)


@bare_kernel
def advance(
    gas: Gas,
    box: Box,
    grid: Grid,
    room: Room,
    walls: Walls | None,
    bodies: Bodies | None,
    book: Ledger,
    clock: NDArray[np.int64],
    target: int,
    time_step: float,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> int:
    """Take whole steps until step number `target`, as one of a team of threads.

    Parameters
    ----------
    walls : of an enclosure; None for a plain rectangle, for which the kernel is compiled apart
    bodies : molecules, of which the rows of all else are the sites; None if all particles are discs
    clock : (1,) int64, steps done; counted on here
    target : step to stop at
    time_step : [time]
    flag : where the team meets, new for each call (`gasbox.kernels.team`)
    thread, threads : which one of how many

    Returns
    -------
    DONE, FULL (read the contacts, call again), GROW, GONE or LEFT; the same for each thread.
    """
    # What other threads may change is read before the first meeting.
    phase, step, turn = room.progress[0], clock[0], room.progress[1]
    if not meet(flag, thread, threads):
        return GONE
    status = DONE
    while step < target:
        # Bodies are filed anew from the order of their sites, in `even`.
        other = 1 - turn if bodies is None else 0
        old, new = (room.odd, room.even) if turn == 1 else (room.even, room.odd)
        if phase == _DRIFT:
            _move(old, box, walls, bodies, time_step, (step + 1) * time_step, thread, threads)
            if bodies is not None:
                # Its bodies are not the sites that a thread counts.
                meet(flag, thread, threads)
            count(old, box, grid, room, thread, threads)
            meet(flag, thread, threads)
            number(grid, room, thread, threads)
            if walls is not None:
                mark(old, box, grid, room.cell, walls, thread, threads)
            meet(flag, thread, threads)
            file(old, new, room, thread, threads)
            meet(flag, thread, threads)
        if phase != _EXECUTE:
            look(new, box, grid, room, walls, bodies, thread, threads)
            if walls is not None:
                find(new, walls, thread, threads)
            meet(flag, thread, threads)
        if thread == 0:
            if phase != _EXECUTE:
                _begin(room, bodies, threads)
            time = (step + 1) * time_step
            if room.progress[0] == _EXECUTE and _execute(
                new, gas, box, grid, room, walls, bodies, book, time, threads
            ):
                room.progress[0], room.progress[1], clock[0] = _DRIFT, other, step + 1
        meet(flag, thread, threads)
        phase = room.progress[0]
        if phase != _DRIFT:
            status = FULL if phase == _EXECUTE else GROW
            break
        step, turn = step + 1, other
        if walls is not None and walls.cursor[3] > _MANY:
            status = LEFT
            break
    if bodies is not None:
        show_bodies(bodies, gas, walls, thread, threads)
    else:
        show(room.odd if turn == 1 else room.even, gas, walls, thread, threads)
    return status
