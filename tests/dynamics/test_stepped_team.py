"""The stepped rule by one thread and by several: the same bits, and nobody waits for ever."""

from __future__ import annotations

import numpy as np
import pytest
from gases import collect, random_gas

from gasbox import Simulation, UsageError, load
from gasbox.dynamics import Stepped
from gasbox.dynamics.team import Team
from gasbox.geometry import Rectangle
from gasbox.kernels.team import flags, give_up, meet
from gasbox.state import Contacts, Tallies

BOXES = [Rectangle(60, 45), Rectangle(60, 45, True, True), Rectangle(60, 45, True, False), Rectangle(4, 4)]
RADII = [3.0, 2.0] + [0.8] * 60 + [0.3] * 200


def outcome(start, geometry, threads, contacts=0):
    state = start.copy()
    dynamics = Stepped(state, geometry, 0.5, Tallies.zero(1, 4), Contacts.empty(contacts), threads=threads)
    rows = collect(dynamics, state, 60.0) if contacts else dynamics.advance(state, 60.0)
    tallies = dynamics.tallies
    return rows, [
        state.position.tobytes(),
        state.velocity.tobytes(),
        tallies.pair_virial.tobytes(),
        tallies.wall_impulse.tobytes(),
        int(tallies.pair_collisions.sum()),
        int(tallies.wall_collisions.sum()),
    ]


@pytest.mark.parametrize("geometry", BOXES, ids=["walled", "periodic", "slab", "few cells"])
@pytest.mark.parametrize("threads", [2, 3])
def test_the_number_of_threads_changes_no_bit(geometry, threads):
    radii = RADII if geometry.width > 4 else [0.3] * 5
    start = random_gas(3, geometry, radii)
    _, expected = outcome(start, geometry, 1)
    assert expected[-2] > 30
    assert outcome(start, geometry, threads)[1] == expected
    rows, watched = outcome(start, geometry, threads, contacts=3)
    assert watched == expected
    assert len(rows) == expected[-2] + expected[-1]


def test_more_touching_pairs_than_the_lists_were_made_for():
    """All in a heap: some 20 touching pairs a disc."""
    geometry = Rectangle(100, 100)
    start = random_gas(5, geometry, [0.1] * 900)
    start.position[:] = 50 + np.random.default_rng(1).uniform(-3, 3, (900, 2))
    start.radius[:] = 0.5
    _, expected = outcome(start, geometry, 1)
    assert expected[-2] > 900
    assert outcome(start, geometry, 2)[1] == expected


def test_an_empty_gas_and_more_threads_than_discs():
    geometry = Rectangle(10, 10)
    assert outcome(random_gas(1, geometry, []), geometry, 2)[1][-2] == 0
    start = random_gas(1, geometry, [0.5] * 2)
    assert outcome(start, geometry, 4)[1] == outcome(start, geometry, 1)[1]


def test_who_waits_is_let_go_when_the_first_cannot_come():
    def kernel(flag, thread, threads):
        if thread == 0:
            raise KeyboardInterrupt
        return int(meet(flag, thread, threads))

    with pytest.raises(KeyboardInterrupt):
        Team(3).run(kernel)


def test_a_meeting_that_was_given_up():
    flag = flags(2)
    give_up(flag)
    assert not meet(flag, 1, 2)


def test_fewer_than_one_thread_is_refused():
    with pytest.raises(UsageError, match="threads is 0"):
        Simulation(load("three-gases"), threads=0)
