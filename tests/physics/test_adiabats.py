"""Walls that are moved: adiabats, and pistons too fast for them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from vessels import agrees, gas, kinetic_energy, run, vessel

from gasbox.geometry import Path, Rectangle
from gasbox.theory import adiabat

SLOW = 0.01


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


def pressure_on_a_moving_wall(speed: float) -> float:
    """Of points that know nothing of it yet, over n T; `speed` towards them in units of sqrt(T/m).

    Flux v + u times momentum 2 m (v + u), over all with v > -u of Maxwell's law; 1 at rest.
    """
    gauss = math.sqrt(2 / math.pi) * speed * math.exp(-0.5 * speed**2)
    return (1 + speed**2) * (1 + math.erf(speed / math.sqrt(2))) + gauss


@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_a_fast_piston_does_more_work(speed):
    # Into points, until those that it has met could have come back: 2.08 times the work of a slow one at u = 0.5,
    # and 0.42 times as it draws back.
    assert pressure_on_a_moving_wall(0.0) == 1.0
    works = []
    for seed in range(20):
        _, change = pushed(Rectangle(40, 10), -4 * speed, abs(speed), counts=[4000], radii=[1e-6], seed=seed)
        works.append(change.wall_work.sum() / (4000 / 400 * 10 * 4 * speed))
    agrees(works, pressure_on_a_moving_wall(speed), least=0.03)


def test_a_piston_runs_into_points_at_rest():
    # Everybody whom it sweeps leaves with 2 u, and nobody meets it twice.
    place = vessel(Rectangle(20, 10), right={"motion": Path((0.0,), (0.0,), (-1.0,))})
    state = gas(place, [60], [1e-6])
    state.velocity[:] = 0.0
    swept = state.position[:, 0] > 12.0
    at = run(place, state)
    change = at.advance(8.0)
    assert np.array_equal(state.velocity[:, 0] == -2.0, swept)
    assert change.wall_collisions[1].sum() == swept.sum() > 10
    assert change.wall_work.sum() == pytest.approx(2.0 * swept.sum(), rel=1e-12)
