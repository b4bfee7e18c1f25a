"""Gases of molecules, event-driven: no overlap ever, what is conserved, the same bits, there and back."""

from __future__ import annotations

import numpy as np
import pytest
from enclosures import enclosure, star
from gases import collect
from molecular_gases import (
    BARBELL,
    BENT,
    DISC,
    DUMBBELL,
    ROD,
    angular_momentum,
    body,
    energy,
    engine_of,
    gas_of,
    momentum,
    overlap,
    scattered,
)

from gasbox.geometry import Circle, Piston, Polygon, Post, Rectangle, Segment, Sinusoid, regular_polygon
from gasbox.state import Contacts

BOX = Rectangle(14, 12)
PERIODIC = Rectangle(14, 12, True, True)
DOWN = (0.03, -0.3)
POSTS = (Post((4.0, 4.0), 1.0), Segment((8.0, 6.0), (11.0, 9.0)))
PLACES = {
    "box": BOX,
    "periodic": PERIODIC,
    "slab falling": enclosure(Rectangle(14, 12, True), gravity=(0.0, -0.3)),
    "circle": enclosure(Circle(7.0)),
    "circle falling": enclosure(Circle(7.0), gravity=DOWN),
    "hexagon": enclosure(Polygon(regular_polygon(6, 7.5, 0.2))),
    "star falling": enclosure(star(outer=12.0, inner=7.0), gravity=DOWN),
    "obstacles falling": enclosure(BOX, POSTS, DOWN),
    "shaken": enclosure(BOX, top={"motion": Sinusoid(0.4, 5.0)}),
    "lid": enclosure(BOX, gravity=DOWN, top={"motion": Piston(10.0, 0.5)}),
    "warm": enclosure(BOX, left={"temperature": 2.0}, right={"temperature": 0.5}),
}
MIXED = [DUMBBELL, BENT, ROD, DISC, BARBELL]


def gas(place, count=15, bodies=MIXED, seed=1):
    return scattered(bodies, np.arange(count) % len(bodies), place, seed)


@pytest.mark.parametrize("name", PLACES)
def test_nothing_ever_overlaps_and_the_books_balance(name):
    place = PLACES[name]
    state = gas(place)
    gravity = getattr(place, "gravity", (0.0, 0.0))
    engine = engine_of(state, place)
    before, now = energy(state, gravity), place
    for time in np.linspace(0.0, 20.0, 200)[1:]:
        engine.advance(state, time)
        assert overlap(state, place) < 1e-11
        now = place.at(state.wall_displacement) if state.wall_displacement.size else place
        assert now.holds(now.wrap(state.sites.position), state.sites.radius * (1 - 1e-10)).all()
    tallies = engine.tallies
    assert tallies.pair_collisions.sum() > 50
    added = tallies.wall_work.sum() + tallies.wall_heat.sum() + tallies.rest_energy[0]
    assert energy(state, gravity) - before == pytest.approx(added, abs=1e-11 * before + 1e-12 * abs(added))


def test_energy_is_kept_over_a_hundred_thousand_collisions():
    state = gas(PERIODIC, 24)
    engine = engine_of(state, PERIODIC)
    before, pushed = energy(state), momentum(state)
    while engine.tallies.pair_collisions.sum() < 100_000:
        engine.advance(state, state.time + 200.0)
    assert energy(state) == pytest.approx(before, rel=1e-12)
    np.testing.assert_allclose(momentum(state), pushed, atol=1e-11)


def test_angular_momentum_is_kept_in_a_circle():
    place = PLACES["circle"]
    state = gas(place)
    before = angular_momentum(state, (7, 7))
    engine = engine_of(state, place)
    engine.advance(state, 100.0)
    assert engine.tallies.wall_collisions.sum() > 100
    assert angular_momentum(state, (7, 7)) == pytest.approx(before, abs=1e-11)


def bits(state):
    return [
        array.tobytes() for array in (state.position, state.velocity, state.angle, state.angular_velocity)
    ]


@pytest.mark.parametrize("name", ["periodic", "obstacles falling", "lid"])
def test_the_bits_do_not_depend_on_how_one_looks(name):
    """In pieces, resumed from references, with tiny buffers, sorted often: the same contacts, the same end."""
    place, until = PLACES[name], 40.0
    one = gas(place)
    engine = engine_of(one, place, contacts=100_000)
    rows = collect(engine, one, until)
    other, found = gas(place), []
    engine = engine_of(other, place, contacts=2)
    engine.sort_after = 1
    for time in [1.7, 1.7 + 1e-9, 11.0, 25.0]:
        found += collect(engine, other, time)
    other = other.copy()
    engine = engine_of(other, place, 3, {name: np.copy(entry) for name, entry in engine.memory().items()})
    found += collect(engine, other, until)
    assert found == rows
    assert bits(other) == bits(one)
    assert other.sites.position.tobytes() == one.sites.position.tobytes()


def test_reversed_the_gas_comes_back():
    place = Rectangle(9, 9, True, True)
    state = scattered([DUMBBELL, DISC], np.arange(24) % 2, place, seed=2)
    start = state.copy()
    engine = engine_of(state, place)
    engine.advance(state, 2.0)
    met = int(engine.tallies.pair_collisions.sum())
    assert met > 2 * state.count
    state.velocity *= -1
    state.angular_velocity *= -1
    engine.resync(state)
    engine.advance(state, 4.0)
    away = state.position - start.position
    away -= np.round(away / place.size) * place.size
    assert np.abs(away).max() < 1e-7
    turned = np.exp(1j * state.angle) / np.exp(1j * start.angle)
    assert np.abs(turned - 1).max() < 1e-7
    assert int(engine.tallies.pair_collisions.sum()) == 2 * met


def test_discs_beside_a_molecule_have_the_bits_of_discs():
    """A dumbbell, or a disc, alone in a chamber of its own: the other discs cannot tell."""
    place = enclosure(Rectangle(16, 12), (Segment((12.0, 0.0), (12.0, 12.0)),))
    ends = []
    for bodies in ([DISC, DUMBBELL], [DISC, DISC]):
        kind = np.arange(20) // 19
        state = scattered([DISC], np.zeros(20, int), place, 3, room=[[0, 0], [12, 12]])
        position, velocity = state.position, state.velocity
        position[19], velocity[19] = (14, 6), (0.1, 0)
        state = gas_of(bodies, kind, position, velocity)
        engine = engine_of(state, place, contacts=4000)
        rows = [row for row in collect(engine, state, 60.0) if row[2] < 19]
        ends.append((rows, state.position[:19].tobytes(), engine.memory()["epoch_length"]))
    assert len(ends[0][0]) > 200
    assert ends[0] == ends[1]


@pytest.mark.small
def test_molecules_of_one_atom_are_discs():
    disc = gas(BOX, 12, [DISC])
    plain = disc.copy()
    plain.sites = None
    plain.angle = plain.angular_velocity = plain.inertia = np.zeros(0)
    rows = [collect(engine_of(state, BOX, contacts=1000), state, 8.0) for state in (disc, plain)]
    assert rows[0] == rows[1]
    assert disc.position.tobytes() == plain.position.tobytes()
    assert disc.sites.position.tobytes() == plain.position.tobytes()


def test_long_rods_in_a_dense_gas():
    """Sticks of 21 discs, whose bounding circles overlap all the time."""
    stick = body([[0.2 * k, 0] for k in range(21)], 0.15, 0.1)
    place = Rectangle(12, 12, True, True)
    state = scattered([stick], np.zeros(14, int), place, 4)
    before = energy(state)
    engine = engine_of(state, place)
    for time in np.linspace(0.0, 8.0, 40)[1:]:
        engine.advance(state, time)
        assert overlap(state, place) < 1e-11
    assert engine.tallies.pair_collisions.sum() > 50
    assert energy(state) == pytest.approx(before, rel=1e-13)


def test_spinning_molecules_at_rest_wait_for_the_first_touch():
    """Nobody flies, and all bounding circles that overlap do so for ever: looking goes on without an end."""
    state = gas_of(
        [BARBELL], [0, 0, 0], [[4, 6], [6.9, 6], [6.9, 9]], np.zeros((3, 2)), 0.0, [0.7, -1.3, 0.4]
    )
    engine = engine_of(state, BOX, contacts=100)
    before = energy(state)
    for time in np.linspace(0.0, 60.0, 400)[1:]:
        assert engine.advance(state, time) is not None
        engine.contacts.clear()
        assert overlap(state, BOX) < 1e-11
    assert energy(state) == pytest.approx(before, rel=1e-13)


def test_molecules_come_to_rest_on_the_floor_and_do_not_sink():
    """A dumbbell that lies on the floor under strong gravity trembles on what the rule for bodies at rest gives."""
    place = enclosure(BOX, gravity=(0.0, -1.0))
    state = gas_of([DUMBBELL, DISC], [0, 1], [[5, 0.5], [9, 0.5]], np.zeros((2, 2)))
    engine = engine_of(state, place)
    for time in np.arange(1, 40) * 0.5:
        engine.advance(state, time)
        assert place.holds(state.sites.position, state.sites.radius * (1 - 1e-9)).all()
        assert np.abs(state.position[:, 1] - 0.5).max() < 1e-4


def test_a_full_buffer_is_told_before_each_contact():
    state = gas(PERIODIC)
    engine = engine_of(state, PERIODIC)
    engine.contacts = Contacts.empty(1)
    rows = collect(engine, state, 3.0)
    assert [row[1] for row in rows] == sorted(row[1] for row in rows)
    assert len(rows) == engine.tallies.pair_collisions.sum() > 5
