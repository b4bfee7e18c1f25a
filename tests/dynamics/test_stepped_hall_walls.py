"""What walls do to discs under the stepped rule: push, warm, let pass, let out, come and go."""

from __future__ import annotations

import dataclasses
from math import erf

import numpy as np
import pytest
from enclosures import BOX, DIVIDER, enclosure, fill, internal_energy
from gases import collect, state_of
from stepped_gases import stepped

from gasbox.dynamics import Stepped
from gasbox.geometry import Circle, Path, Piston, Polygon, Rectangle, Sinusoid
from gasbox.state import Contacts, Tallies

DOWN = (0.0, -1.0)


@pytest.mark.small
@pytest.mark.parametrize(("speed", "after"), [(-0.25, -1.5), (0.25, -0.5), (0.0, -1.0)])
def test_a_moving_wall_gives_twice_its_speed(speed, after):
    """v' = 2u - v, and the work is the change of energy: u times the impulse."""
    place = enclosure(BOX, right={"motion": Path((0.0,), (0.0,), (speed,))})
    state = state_of([[10, 6]], [[1, 0.5]], 0.5, 2.0)
    engine = stepped(state, place, time_step=0.125)
    engine.advance(state, 7.5)
    assert state.velocity.tolist() == [[after, 0.5]]
    assert engine.tallies.wall_work[1, 0] == pytest.approx(after**2 - 1.0, abs=1e-14)
    assert engine.tallies.wall_impulse[1, 0] == pytest.approx(2.0 * (1.0 - after), abs=1e-14)
    assert state.wall_displacement.tolist() == [0.0, 7.5 * speed, 0.0, 0.0]
    assert state.wall_velocity.tolist() == [0.0, speed, 0.0, 0.0]


@pytest.mark.small
@pytest.mark.parametrize("speed", [2.0, 90.0])
def test_a_wall_overtakes_a_slow_disc(speed):
    """However far the wall moves in a step: the disc stays before it, and is given twice its speed."""
    place = enclosure(Rectangle(1000, 12), left={"motion": Path((0.3,), (0.0,), (speed,))})
    state = state_of([[4, 6]], [[0.5, 0]], 0.5)
    engine = stepped(state, place, time_step=0.1)
    for step in range(1, 31):
        engine.advance(state, 0.1 * step)
        assert state.position[0, 0] > state.wall_displacement[0]
    assert state.velocity.tolist() == [[2 * speed - 0.5, 0.0]]


@pytest.mark.small
def test_a_path_is_followed_to_its_corners():
    """At the end of each step a wall is exactly where its path is, also if a step leads over several corners."""
    path = Path((0.5, 2.0, 2.02, 4.0), (0.0, -3.0, -2.9, 1.0), (-2.0, 5.0, 3.9 / 1.98, 0.0))
    place = enclosure(BOX, (DIVIDER,), o0={"motion": path})
    state = state_of([[2, 6]], [[0, 0]], 0.5)
    engine = stepped(state, place, time_step=0.07)
    for step in range(1, 80):
        engine.advance(state, step * 0.07)
        assert state.wall_displacement[4] == pytest.approx(path.piece(step * 0.07)[0], abs=1e-12)
        assert state.wall_velocity[4] == path.piece(step * 0.07)[1]


@pytest.mark.small
def test_a_swinging_wall_is_where_its_sine_is():
    motion = Sinusoid(1.5, 9.0, 0.4)
    place = enclosure(BOX, (DIVIDER,), o0={"motion": motion})
    state = state_of([[2, 6]], [[0, 0]], 0.5)
    engine = stepped(state, place, time_step=0.1)
    engine.advance(state, 12.3)
    angle = 2 * np.pi / 9.0 * state.time + 0.4
    assert state.wall_displacement[4] == pytest.approx(1.5 * (np.sin(angle) - np.sin(0.4)), abs=1e-12)
    assert state.wall_velocity[4] == pytest.approx(1.5 * 2 * np.pi / 9.0 * np.cos(angle), abs=1e-12)


@pytest.mark.small
def test_a_free_piston_and_a_disc_exchange_momentum():
    place = enclosure(BOX, (DIVIDER,), o0={"motion": Piston(3.0)})
    state = state_of([[2, 6]], [[1, 0]], 0.5)
    engine = stepped(state, place, time_step=0.125)
    engine.advance(state, 6.5)
    assert state.velocity.tolist() == [[-0.5, 0.0]]
    assert state.wall_velocity[4] == 0.5
    assert state.wall_displacement[4] == pytest.approx(0.5 * 1.0)
    assert engine.tallies.wall_work[4, 0] == -0.375


@pytest.mark.small
def test_a_piston_bounces_from_its_stops_with_its_energy():
    place = enclosure(
        BOX, (DIVIDER,), (0.25, 0.0), o0={"motion": Piston(3.0, speed=1.0, lower=-2.0, upper=2.0)}
    )
    state = state_of(np.zeros((0, 2)), np.zeros((0, 2)))
    engine = stepped(state, place, time_step=0.03)
    for step in range(1, 2000):
        engine.advance(state, step * 0.03)
        move, rate = state.wall_displacement[4], state.wall_velocity[4]
        assert -2.0 <= move <= 2.0
        assert 0.5 * rate * rate - 0.25 * move == pytest.approx(0.5, abs=1e-10)


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.0, -0.3), (-0.3, 0.0)])
def test_gas_and_piston_together_keep_their_energy(gravity):
    """The work on the gas is the change of its energy, and what the piston has lost, to 1e-10."""
    place = enclosure(Rectangle(20, 12), gravity=gravity, right={"motion": Piston(30.0, 0.5)})
    state = fill(place, 40)
    before = internal_energy(state, place)
    engine = stepped(state, place, time_step=0.01)
    engine.advance(state, 200.0)
    work = engine.tallies.wall_work.sum()
    change = internal_energy(state, place) - before - engine.tallies.rest_energy[0]
    assert abs(work) > 1.0
    assert change == pytest.approx(work, abs=1e-10 * before)
    push = -0.5 * 12 + 30.0 * gravity[0]
    piston = 0.5 * 30.0 * state.wall_velocity[1] ** 2 - push * state.wall_displacement[1]
    assert piston == pytest.approx(-work, abs=1e-10 * before)


def test_work_of_slow_compression_follows_the_adiabat():
    """A wall ten times slower than the discs: T grows as 1/area in two dimensions, up to the first power of u/v."""
    place = enclosure(Rectangle(20, 12), right={"motion": Path((0.0, 100.0), (0.0, -8.0), (-0.08, 0.0))})
    state = fill(place, 60, sizes=(0.05, 0.05))
    before = internal_energy(state, place)
    engine = stepped(state, place, time_step=0.01)
    engine.advance(state, 100.0)
    # Accessible to centres; sixty discs fluctuate by 1/sqrt(60), which the work of thousands of hits averages.
    assert internal_energy(state, place) / before == pytest.approx((20 - 0.1) / (12 - 0.1), rel=0.05)


def test_a_geometry_that_changes_on_the_way():
    """A divider taken away and put back, gravity turned on, a piston held: walls go on from where they are."""
    start = enclosure(BOX, (DIVIDER,), top={"motion": Piston(20.0, 0.4)})
    state = fill(start, 20)
    engine = stepped(state, start)
    engine.advance(state, 5.0)
    moved, rate = state.wall_displacement[3], state.wall_velocity[3]
    assert moved != 0.0
    gone = dataclasses.replace(start.with_wall(4, present=False), gravity=(0.0, -0.1))
    engine.alter(state, gone)
    assert (state.wall_displacement[3], state.wall_velocity[3]) == (moved, rate)
    hits = engine.tallies.wall_collisions[4].sum()
    before = internal_energy(state, gone)
    work = engine.tallies.wall_work.sum()
    engine.advance(state, 15.0)
    assert engine.tallies.wall_collisions[4].sum() == hits
    change = internal_energy(state, gone) - before - engine.tallies.rest_energy[0]
    assert change == pytest.approx(engine.tallies.wall_work.sum() - work, abs=1e-9)
    assert 0 < (state.position[:, 0] > 8.0).sum() < 20
    held = start.with_wall(3, motion=Path((15.0,), (float(state.wall_displacement[3]),), (0.0,)))
    moved = state.wall_displacement[3]
    engine.alter(state, held)
    right = state.position[:, 0] > 8.0
    engine.advance(state, 40.0)
    assert state.wall_displacement[3] == moved
    assert np.array_equal(state.position[:, 0] > 8.0, right)


@pytest.mark.parametrize("threads", [1, 2])
def test_from_plain_to_enclosure_and_on(threads):
    """Gravity turned on in a plain rectangle, whose discs may stand beyond its walls: they come back."""
    state = state_of([[0.2, 6.0], [3.0, 3.0]], [[-9.0, 0.0], [0.0, 0.0]], 0.5)
    engine = Stepped(state, BOX, 0.1, Tallies.zero(1, 4), Contacts.empty(0), threads=threads)
    engine.advance(state, 0.1)
    assert state.position[0, 0] < 0.0
    # So strong that it pulls the one that is outside further out.
    engine.alter(state, enclosure(BOX, gravity=(-100.0, -1.0)))
    engine.advance(state, 0.2)
    assert (state.position > 0.0).all()
    engine.advance(state, 30.0)
    assert enclosure(BOX).holds(state.position, 0.0).all()


@pytest.mark.small
def test_the_tables_grow_with_a_side_that_moves_out():
    place = enclosure(BOX, right={"motion": Path((0.0,), (0.0,), (4.0,))})
    state = state_of([[2, 6], [2, 3]], [[9, 0], [7, 0]], 0.5)
    engine = stepped(state, place, time_step=0.05)
    engine.advance(state, 20.0)
    assert state.velocity == pytest.approx(np.array([[-1.0, 0.0], [1.0, 0.0]]), abs=1e-12)
    assert engine.tallies.wall_work[1, 0] == pytest.approx(-64.0)
    assert enclosure(Rectangle(96, 12)).holds(state.position, state.radius).all()


HALF = 0.5**0.5
WARM = {"temperature": 2.0}
TRIANGLE = Polygon(((0.0, 0.0), (8.0, 0.0), (0.0, 8.0)))
CASES = {
    "rim": (enclosure(Circle(8.0), rim=WARM), 0, None),
    "left": (enclosure(Rectangle(6, 6), left=WARM), 0, (1.0, 0.0)),
    "falling": (enclosure(Rectangle(6, 6), gravity=DOWN, bottom=WARM), 2, (0.0, 1.0)),
    "slope": (enclosure(TRIANGLE, gravity=(0.0, -0.1), side_2=WARM), 1, (-HALF, -HALF)),
}


@pytest.mark.parametrize(("place", "wall", "normal"), CASES.values(), ids=CASES.keys())
def test_a_thermal_wall_gives_the_law_of_flux(place, wall, normal):
    """Normal speeds v exp(-m v²/2T), tangential ones Gaussian: Kolmogorov and Smirnov at one in ten thousand."""
    mass, temperature, gravity = 3.0, 2.0, np.array(place.gravity)
    state = state_of([[2.5, 2.5]], [[0.7, -0.4]], 0.3, mass)
    engine = Stepped(state, place, 0.05, Tallies.zero(1, len(place.walls)), Contacts.empty(4096), seed=11)
    x, v, now = state.position[0].copy(), state.velocity[0].copy(), 0.0
    away, along = [], []
    for _, time, _, second, jx, jy in collect(engine, state, 30_000.0):
        x = x + v * (time - now)
        v = v + gravity * (time - now) + np.array((jx, jy)) / mass
        now = time
        if second == wall:
            nx, ny = normal if normal is not None else (8.0 - x) / np.hypot(*(8.0 - x))
            away.append(v[0] * nx + v[1] * ny)
            along.append(v[1] * nx - v[0] * ny)
    assert len(away) > 1000
    assert v + gravity * (state.time - now) == pytest.approx(state.velocity[0], abs=1e-8)
    away, along = np.sort(away), np.sort(along)
    rank = (np.arange(len(away)) + 0.5) / len(away)
    flux = 1.0 - np.exp(-0.5 * mass * away**2 / temperature)
    gauss = np.array([0.5 + 0.5 * erf(v * np.sqrt(0.5 * mass / temperature)) for v in along])
    assert np.abs(flux - rank).max() < 2.22 / np.sqrt(len(away))
    assert np.abs(gauss - rank).max() < 2.22 / np.sqrt(len(away))
    assert engine.tallies.wall_heat[wall, 0] != 0.0
