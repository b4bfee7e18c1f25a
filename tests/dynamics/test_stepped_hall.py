"""The stepped rule in enclosures of every kind: the same bits however it is run, energy, and nobody gets out."""

from __future__ import annotations

import numpy as np
import pytest
from enclosures import (
    ACTIVE,
    ALL,
    AT_REST,
    BOX,
    DIVIDER,
    angular_momentum,
    enclosure,
    fill,
    internal_energy,
    star,
)
from gases import collect, state_of
from stepped_gases import bits, stepped

from gasbox.dynamics import Stepped
from gasbox.geometry import Block, Circle, Enclosure, Polygon, Post, Rectangle, Segment, regular_polygon
from gasbox.state import Contacts, Tallies

OPEN = {
    "leaking": enclosure(BOX, (Segment((8.0, 0.0), (8.0, 9.0)),), right={"open": True}),
    "draining": enclosure(BOX, gravity=(0.0, -0.2), right={"open": True}),
    "drain": enclosure(Circle(8.0), (Segment((6.0, 6.0), (9.0, 8.0)),), o0={"open": True}),
    "no rim": enclosure(Circle(8.0), rim={"open": True}),
}
every = pytest.mark.parametrize("place", (ALL | OPEN).values(), ids=(ALL | OPEN).keys())
at_rest = pytest.mark.parametrize("place", AT_REST.values(), ids=AT_REST.keys())
booked = ACTIVE | {name: place for name, place in OPEN.items() if place.gravity == (0.0, 0.0)}
active = pytest.mark.parametrize("place", booked.values(), ids=booked.keys())


@every
def test_looking_never_disturbs(place):
    """In one go; in odd pieces; with a tiny buffer of contacts; by several threads; and resumed: the same bits."""
    start, until = fill(place), 24.0
    whole = start.copy()
    engine = stepped(whole, place)
    engine.advance(whole, until)
    expected = bits(whole, engine)

    pieces = start.copy()
    engine = stepped(pieces, place)
    for time in [*np.sort(np.random.default_rng(1).uniform(0, until, 37)), until]:
        engine.advance(pieces, time)
    assert bits(pieces, engine) == expected

    for threads in (1, 3):
        watched = start.copy()
        engine = stepped(watched, place, contacts=2, threads=threads)
        rows = collect(engine, watched, until)
        tallies = engine.tallies
        booked = tallies.pair_collisions.sum() + tallies.wall_collisions.sum() + tallies.wall_passed.sum()
        assert len(rows) == booked
        assert booked > 20
        assert bits(watched, engine) == expected

    stopped = start.copy()
    first = stepped(stopped, place)
    for time in (0.0, 11.3, 11.3, 19.05):
        first.advance(stopped, time)
        resumed = stopped.copy()
        second = stepped(resumed, place, memory=first.memory())
        second.tallies = first.tallies.copy()
        first, stopped = second, resumed
    first.advance(stopped, until)
    assert bits(stopped, first) == expected


@pytest.mark.parametrize("speed", [1.0, 40.0, 3000.0])
@at_rest
def test_energy_stays_and_nobody_gets_out(place, speed):
    """Over 10^4 steps, at any speed: energy with gravity to 1e-11, and all centres inside after each step looked at."""
    state = fill(place, 12)
    state.velocity *= speed
    before = internal_energy(state, place)
    engine = stepped(state, place)
    for step in range(0, 10_000, 50):
        engine.advance(state, step * 0.02)
        assert place.holds(state.position, 0.0).all()
    engine.advance(state, 200.0)
    assert engine.tallies.wall_collisions.sum() > 50
    kinetic = 0.5 * (state.mass * (state.velocity**2).sum(axis=1)).sum()
    change = internal_energy(state, place) - before - engine.tallies.rest_energy[0]
    assert abs(change) < 1e-11 * kinetic


@active
def test_work_heat_and_what_is_carried_make_up_the_change_of_energy(place):
    state = fill(place, 30)
    before = internal_energy(state, place)
    engine = stepped(state, place, time_step=0.01)
    engine.advance(state, 40.0)
    tallies = engine.tallies
    booked = tallies.wall_work.sum() + tallies.wall_heat.sum() + tallies.rest_energy[0]
    change = internal_energy(state, place) + tallies.wall_carried.sum() - before
    assert change == pytest.approx(booked, abs=1e-10 * abs(before))


@every
def test_contacts_account_for_every_change_of_momentum(place):
    state = fill(place, 20)
    momentum = dict(zip(state.id.tolist(), state.mass[:, None] * state.velocity, strict=True))
    mass = dict(zip(state.id.tolist(), state.mass.tolist(), strict=True))
    engine = stepped(state, place, contacts=64)
    for kind, _, first, second, jx, jy in collect(engine, state, 10.0):
        if kind == 2:
            continue
        momentum[first] = momentum[first] + (jx, jy)
        if kind == 0:
            momentum[second] = momentum[second] - (jx, jy)
    for i, number in enumerate(state.id.tolist()):
        expected = momentum[number] + mass[number] * 10.0 * np.array(place.gravity)
        assert state.mass[i] * state.velocity[i] == pytest.approx(expected, abs=1e-10)


def test_a_smooth_circle_keeps_the_angular_momentum():
    """Also of discs so fast that they would fly out in one step."""
    for speed in (1.0, 300.0):
        place = AT_REST["circle"]
        state = fill(place, 40)
        state.velocity *= speed
        before = angular_momentum(state, (8.0, 8.0))
        engine = stepped(state, place)
        engine.advance(state, 200.0)
        assert engine.tallies.wall_collisions.sum() > 400 * min(speed, 100.0)
        scale = (state.mass * np.hypot(*(state.position - 8.0).T) * np.hypot(*state.velocity.T)).sum()
        assert angular_momentum(state, (8.0, 8.0)) == pytest.approx(before, abs=1e-12 * scale)


@pytest.mark.parametrize("speed", [5.0, 77.7, 1e3, 1e4])
@pytest.mark.parametrize("periodic", [(False, False), (True, False), (True, True)])
def test_no_wall_is_tunnelled(speed, periodic):
    """A thin divider across the box keeps two gases apart, and posts and blocks stay empty, at any speed.

    In a periodic box, as long as no disc flies more than 64 lengths of the box in a step.
    """
    if speed == 1e4 and any(periodic):
        speed = 2e3
    inside = (Post((4.0, 4.0), 1.5), Block(((12.0, 3.0), (14.0, 3.0), (13.0, 6.0))))
    dividers = (DIVIDER, Segment((0.0, 0.0), (0.0, 12.0))) if periodic[0] else (DIVIDER,)
    place = enclosure(Rectangle(16, 12, *periodic), inside + dividers)
    state = fill(place, 24)
    state.velocity *= speed
    left = state.position[:, 0] < 8.0
    energies = [0.5 * (state.mass * (state.velocity**2).sum(axis=1))[side].sum() for side in (left, ~left)]
    engine = stepped(state, place, time_step=0.05)
    for step in range(0, 6000, 20):
        engine.advance(state, step * 0.05)
        assert place.holds(state.position, 0.0).all()
        assert np.array_equal(state.position[:, 0] < 8.0, left)
    for side, energy in zip((left, ~left), energies, strict=True):
        # Nor do discs on its two sides collide with each other through it.
        after = 0.5 * (state.mass * (state.velocity**2).sum(axis=1))[side].sum()
        assert after == pytest.approx(energy, rel=1e-10)


def test_a_rectangle_as_enclosure_is_the_plain_one():
    """While no centre gets across a wall, the rule for enclosures is that of the plain rectangle, to the bit."""
    state = fill(enclosure(BOX), 24)
    other = state.copy()
    plain = stepped(state, enclosure(BOX))
    plain.advance(state, 40.0)
    rectangle = Stepped(other, BOX, 0.02, Tallies.zero(2, 4), Contacts.empty(0))
    rectangle.advance(other, 40.0)
    assert rectangle.tallies.wall_collisions.sum() > 50
    assert np.array_equal(state.position, other.position)
    assert np.array_equal(rectangle.tallies.wall_collisions, plain.tallies.wall_collisions)


def test_a_fast_disc_is_turned_where_it_touches():
    """One that would cross the wall within the step waits where it first touched; the rest of the step is lost."""
    place = enclosure(BOX, (DIVIDER,))
    state = state_of([[3.0, 2.0]], [[40.0, 8.0]], 0.5)
    engine = stepped(state, place, time_step=0.25)
    engine.advance(state, 0.25)
    assert state.position[0] == pytest.approx([7.5, 2.9], abs=1e-12)
    assert state.velocity.tolist() == [[-40.0, 8.0]]


def test_shapes_of_many_corners_at_speed():
    """A hundred-sided polygon, a star and a comb of narrow teeth lose nobody in 20 000 steps."""
    teeth = [(0.0, 0.0), (20.0, 0.0)]
    for k in range(9, 0, -1):
        teeth += [(2.0 * k + 2.0, 10.0), (2.0 * k + 1.0, 3.0)]
    comb = Polygon((*teeth, (0.0, 10.0)))
    shapes: list[Enclosure] = [
        enclosure(shape, gravity=(0.0, -1.0)) for shape in (Polygon(regular_polygon(100, 10.0)), star(), comb)
    ]
    for place in shapes:
        state = fill(place, 16, sizes=(0.3, 0.2))
        state.velocity *= np.geomspace(1, 1000, 16)[:, None]
        engine = stepped(state, place)
        for step in range(0, 20_000, 100):
            engine.advance(state, step * 0.02)
            assert place.holds(state.position, 0.0).all()
        assert state.count == 16
