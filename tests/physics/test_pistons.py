"""Walls that move: adiabats, fast and slow pistons, and one that swings freely on a gas."""

from __future__ import annotations

import math

import numpy as np
import pytest
from vessels import agrees, gas, kinetic_energy, run, vessel

from gasbox.geometry import Path, Piston, Rectangle
from gasbox.theory import adiabat, piston

SLOW, FAST = 0.01, 0.5


def pushed(container, way, speed, **state):
    """A gas after its right wall has moved by `way` at a constant speed; temperature and work."""
    duration = abs(way) / speed
    motion = Path((0.0, duration), (0.0, way), (math.copysign(speed, way), 0.0))
    place = vessel(container, right={"motion": motion})
    at = run(place, gas(place, **state))
    change = at.advance(duration)
    return at, change


def test_slow_compression_of_points():
    # T A = const to 1 % at 0.01 thermal speeds (points of radius 0.02 at 0.5 a unit of area; A of their centres).
    radius, ratios = 0.02, []
    for seed in range(6):
        at, change = pushed(Rectangle(20, 10), -10.0, SLOW, counts=[100], radii=[radius], seed=seed)
        expected = adiabat.ideal_temperature(
            (10 - 2 * radius) * (10 - 2 * radius), 1.0, (20 - 2 * radius) * (10 - 2 * radius)
        )
        assert change.wall_work.sum() == pytest.approx(kinetic_energy(at.state) - 100.0, abs=1e-9)
        ratios.append(at.temperature / expected)
    agrees(ratios, 1.0, bias=0.01, least=0.01)


def test_slow_expansion_cools_and_compression_brings_back():
    # Half as warm at twice the area; and back again, but for what a finite speed costs.
    ends = []
    for seed in range(4):
        way = Path((0.0, 1000.0, 2000.0), (0.0, 10.0, 0.0), (SLOW, -SLOW, 0.0))
        place = vessel(Rectangle(10, 10), right={"motion": way})
        at = run(place, gas(place, [100], [0.02], seed=seed))
        at.advance(1000.0)
        middle = at.temperature
        at.advance(1000.0)
        ends.append((middle * (20 - 0.04) / (10 - 0.04), at.temperature))
    agrees(ends, 1.0, bias=0.01, least=0.015)


def test_the_adiabat_of_hard_discs():
    # eta 0.05 -> 0.10: T rises 2.2395 times (physics of the Kolafa-Rottner equation), not twice. A long slab, so that
    # what the walls do to the density, of the order of eta sigma/width, stays below a part in 500.
    ratios = []
    for seed in range(3):
        count, radius = 200, 0.5
        height = count * math.pi * radius**2 / 0.05 / 200.0
        slab = Rectangle(201.0, height, False, True)
        at, _ = pushed(slab, -100.0, SLOW, counts=[count], radii=[radius], seed=seed)
        begin, end = 200.0 * height, 100.0 * height
        expected = adiabat.adiabatic_temperature(end, 1.0, count, radius, begin)
        assert expected == pytest.approx(2.2395, abs=2e-4)
        # Along y, momentum is conserved: one degree of freedom less in 2 N.
        ratios.append(at.temperature / expected ** (2 * count / (2 * count - 1)))
    agrees(ratios, 1.0, bias=0.01)
    assert np.mean(ratios) * 2.2395 > 2.15  # and the ideal 2 is refuted


def test_a_fast_piston_does_more_work():
    # Into points at rest at the speed u every one of them leaves with 2u; into a warm gas, more than the adiabat.
    slow, fast = (
        pushed(Rectangle(20, 10), -10.0, speed, counts=[100], radii=[0.02])[1].wall_work.sum()
        for speed in (SLOW, FAST)
    )
    assert fast > 1.3 * slow


def test_a_piston_runs_into_cold_points():
    place = vessel(Rectangle(20, 10), right={"motion": Path((0.0,), (0.0,), (-1.0,))})
    state = gas(place, [60], [0.02])
    state.velocity[:] = 0.0
    at = run(place, state)
    change = at.advance(10.0)
    met = state.position[:, 0] != 0
    swept = np.count_nonzero(np.abs(state.velocity[:, 0]) > 0)
    # Each one gets 2u: energy 2 m u²; those that have hit a second one share theirs with it.
    assert change.wall_work.sum() == pytest.approx(2.0 * change.wall_collisions[1].sum(), rel=0.2)
    assert swept > 20
    assert met.all()


@pytest.mark.parametrize("seed", [1, 2])
def test_a_free_piston_swings_on_the_gas(seed):
    # omega² = 2 P L/h / (M + N m/3): the adiabatic stiffness for f = 2, a third of the gas swings along.
    count, length, height, heavy = 1000, 20.0, 50.0, 1000.0
    outside = count / (length * height)
    lid = Piston(heavy, outside)
    place = vessel(Rectangle(length, height), top={"motion": lid})
    state = gas(place, [count], [0.05], seed=seed)
    # As warm as makes the lid too light by a sixth: it rises and swings about a height above.
    state.velocity *= math.sqrt(1.15)
    at = run(place, state)
    before = kinetic_energy(at.state)
    times, lifts = np.arange(1, 301) * 2.0, []
    for _ in times:
        at.advance(2.0)
        lifts.append(at.state.wall_displacement[3])
    total = kinetic_energy(at.state) + 0.5 * heavy * at.state.wall_velocity[3] ** 2
    total += outside * length * at.state.wall_displacement[3]
    assert total == pytest.approx(before, rel=1e-10)
    middle = float(np.mean(lifts))
    assert 1.0 < middle < 8.0
    crossings = times[:-1][np.diff(np.sign(np.array(lifts) - middle)) != 0]
    # Half periods between clear crossings; noise at a crossing makes several, which count as one.
    crossings = crossings[np.concatenate([[True], np.diff(crossings) > 40.0])]
    found = math.pi / float(np.mean(np.diff(crossings)))
    spring = piston.column_stiffness(2.0, outside, length, height + middle)
    expected = piston.piston_frequency(spring, heavy, float(count))
    assert found == pytest.approx(expected, rel=0.12)


def test_a_piston_comes_to_where_the_pressures_are_equal():
    # The time average of what the gas does is what the outside does: P = p, but for the change of its momentum.
    place = vessel(Rectangle(20, 30), top={"motion": Piston(50.0, 0.3)})
    at = run(place, gas(place, [200], [0.05]))
    at.advance(200.0)
    duration, begin = 3000.0, at.state.wall_velocity[3]
    change = at.advance(duration)
    force = change.wall_impulse[3].sum() / duration
    outside = 0.3 * 20 + 50.0 * (at.state.wall_velocity[3] - begin) / duration
    assert force == pytest.approx(outside, rel=1e-9)


def test_an_adiabatic_piston_between_two_gases():
    # No heat, but energy through its jitter; energy of both gases and of the piston stays.
    place = vessel(Rectangle(40, 10), o0={"motion": Piston(10.0)}, obstacles=(_divider(),))
    state = gas(place, [120], [0.05])
    state.velocity[state.position[:, 0] < 20] *= 1.4
    at = run(place, state)
    before = kinetic_energy(at.state)
    places = []
    for _ in range(60):
        at.advance(10.0)
        places.append(at.state.wall_displacement[4])
    after = kinetic_energy(at.state) + 5.0 * at.state.wall_velocity[4] ** 2
    assert after == pytest.approx(before, rel=1e-10)
    # The warm gas has pushed it over, and it trembles there; later it comes back as both get equally warm.
    assert np.mean(places[:15]) > 1.0


def _divider():
    from gasbox.geometry import Segment

    return Segment((20.0, 0.0), (20.0, 10.0))
