"""Phases of a step that discs and molecules go through together, each thread with its share."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger
from gasbox.kernels.forced.bath import sum_blocks
from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.bonds import hold
from gasbox.kernels.forced.crowd import Crowd
from gasbox.kernels.forced.lists_anew import Rule, box_of
from gasbox.kernels.forced.molecules import gather, place, show_bodies, take_arms
from gasbox.kernels.forced.molecules_bath import sum_bodies
from gasbox.kernels.forced.motion import show
from gasbox.kernels.forced.push import push
from gasbox.kernels.forced.tables import BLOCK, Atoms, Terms
from gasbox.kernels.forced.wall_tables import Walls
from gasbox.kernels.forced.walls import push_back
from gasbox.kernels.team import meet, share

__all__ = ["blocks_of", "follow", "force", "rows_of", "show_all", "sum_all"]


@inlined_kernel
def blocks_of(bodies: Bodies | None, thread: int, threads: int) -> tuple[int, int]:
    """This thread's blocks of particles, where there are molecules."""
    if bodies is None:
        return 0, 0
    return share(bodies.sums.shape[0], thread, threads)


@inlined_kernel
def rows_of(bodies: Bodies | None, thread: int, threads: int) -> tuple[int, int]:
    """This thread's particles, likewise."""
    if bodies is None:
        return 0, 0
    first, last = share(bodies.sums.shape[0], thread, threads)
    return first * BLOCK, min(last * BLOCK, bodies.style.shape[0])


@inlined_kernel
def follow(
    bodies: Bodies | None, atoms: Atoms, box: Box, flag: NDArray[np.int64], thread: int, threads: int
) -> None:
    """Let the discs of rigid bodies follow them."""
    if bodies is None:
        return
    begin, end = rows_of(bodies, thread, threads)
    meet(flag, thread, threads)
    place(bodies, atoms, box, begin, end)
    meet(flag, thread, threads)


@inlined_kernel
def _virial_of_molecules(
    bodies: Bodies | None,
    atoms: Atoms,
    box: Box,
    measured: bool,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> None:
    """Bring the virial from discs to molecules, before other forces than those of pairs are added."""
    if bodies is None:
        return
    meet(flag, thread, threads)
    if measured:
        begin, end = rows_of(bodies, thread, threads)
        take_arms(bodies, atoms, box, begin, end)


@inlined_kernel
def _hold_together(
    bodies: Bodies | None,
    atoms: Atoms,
    terms: Terms,
    box: Box,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> None:
    """What acts within molecules, and on them as a whole."""
    if bodies is None:
        return
    begin, end = rows_of(bodies, thread, threads)
    hold(bodies, atoms, terms, box, begin, end)
    gather(bodies, atoms, begin, end)
    meet(flag, thread, threads)


@inlined_kernel
def force(
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
    """Forces on this thread's atoms and molecules; smooth walls book the impulse of a time `time`."""
    atoms, slots, lists, _, _, bodies = crowd
    box = box_of(crowd, rule)
    push(atoms, slots, lists, terms, bodies, rule.gx, rule.gy, measured, begin, end)
    _virial_of_molecules(bodies, atoms, box, measured, flag, thread, threads)
    if walls.strength > 0.0:
        meet(flag, thread, threads)
        if thread == 0:
            push_back(walls, atoms, gas, box, book, time)
        meet(flag, thread, threads)
    _hold_together(bodies, atoms, terms, box, flag, thread, threads)


@inlined_kernel
def sum_all(
    crowd: Crowd,
    rule: Rule,
    measured: bool,
    first: int,
    last: int,
    flag: NDArray[np.int64],
    thread: int,
    threads: int,
) -> None:
    """Sums over this thread's atoms and molecules."""
    atoms, _, _, _, room, bodies = crowd
    sum_blocks(atoms, room, measured, first, last)
    if bodies is not None:
        meet(flag, thread, threads)
    begin, end = blocks_of(bodies, thread, threads)
    sum_bodies(bodies, atoms, box_of(crowd, rule), measured, begin, end)
    meet(flag, thread, threads)


@inlined_kernel
def show_all(
    crowd: Crowd, rule: Rule, gas: Gas, begin: int, end: int, bodies: Bodies | None, first: int, last: int
) -> None:
    """Write this thread's share into the state."""
    if bodies is None:
        show(crowd.atoms, gas, box_of(crowd, rule), begin, end)
    else:
        show_bodies(bodies, crowd.atoms, gas, box_of(crowd, rule), first, last)
