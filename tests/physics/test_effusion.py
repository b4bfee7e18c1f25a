"""Gases that leave, mix, or pass a membrane."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from scipy.stats import kstest
from vessels import agrees, gas, run, vessel

from gasbox.dynamics import altered
from gasbox.geometry import Passage, Polygon, Rectangle, Segment
from gasbox.state import ContactKind, SetWall
from gasbox.theory import walls

SIDE, SLIT, RADIUS = 40.0, 2.0, 0.02
CHEST = Polygon(((0, 0), (SIDE, 0), (SIDE, 19), (SIDE, 19 + SLIT), (SIDE, SIDE), (0, SIDE)))
LEAKING = vessel(CHEST, side_3={"open": True})


@dataclasses.dataclass
class Flow:
    """What left in a short time: counts by species, speeds and angles of the light ones, and the energy carried."""

    expected: np.ndarray
    left: np.ndarray
    speed: np.ndarray
    angle: np.ndarray
    carried: np.ndarray


def flow(seed: int, duration: float = 60.0) -> Flow:
    counts, masses = [3000, 3000], [1.0, 4.0]
    at = run(LEAKING, gas(LEAKING, counts, [RADIUS, RADIUS], masses, seed=seed))
    contacts = at.collect(duration)
    out = contacts.kind == ContactKind.CROSSING
    light = out & (contacts.first < counts[0])
    velocity = contacts.impulse[light]
    area = LEAKING.accessible_area(RADIUS)
    expected = [
        count * -math.expm1(-duration / walls.decay_time(mass, 1.0, area, SLIT, RADIUS))
        for count, mass in zip(counts, masses, strict=True)
    ]
    tallies = at.engine.tallies
    left = tallies.wall_passed[2].sum(axis=1)
    assert left.sum() == out.sum() == 6000 - at.state.count
    speed, angle = np.hypot(*velocity.T), np.arctan2(velocity[:, 1], velocity[:, 0])
    # What they carry is what the contacts say, to the last digits.
    heavy = np.array(masses)[(contacts.first[out] >= counts[0]).astype(int)]
    energy = 0.5 * float((np.sum(contacts.impulse[out] ** 2, axis=1) / heavy).sum())
    assert tallies.wall_carried[2].sum() == pytest.approx(energy, rel=1e-12)
    return Flow(np.array(expected), left, speed, angle, tallies.wall_carried[2])


@pytest.fixture(scope="module")
def flows():
    return [flow(seed) for seed in range(6)]


def test_effusion_rate_and_grahams_law(flows):
    # n vbar L/pi of what is left, each by its own speed; sqrt(4) = 2 times as many light ones. Points as good as
    # without collisions: mean free path 4 slits. The rest cools by a few thousandths in this time.
    left, expected = sum(one.left for one in flows), sum(one.expected for one in flows)
    assert np.all(np.abs(left - expected) < 4.5 * np.sqrt(expected) + 0.01 * expected)
    ratio = left[0] / left[1]
    error = ratio * math.sqrt(1 / left[0] + 1 / left[1])
    assert abs(ratio - walls.graham_ratio(1.0, 4.0) * expected[0] / expected[1] / 2.0) < 4.5 * error + 0.02
    assert expected[0] / expected[1] == pytest.approx(2.0, rel=0.03)


def test_who_effuses_is_faster_than_the_rest(flows):
    # 1.5 T each; speeds v² exp(-m v²/2T), angles by the cosine law.
    for k in range(2):
        carried, left = sum(one.carried[k] for one in flows), sum(one.left[k] for one in flows)
        # The energy of one has variance 1.5 T².
        assert carried / left == pytest.approx(
            walls.effusing_energy(1.0), abs=4.5 * math.sqrt(1.5 / left) + 0.015
        )
    speed, angle = (np.concatenate([getattr(one, name) for one in flows]) for name in ("speed", "angle"))
    assert kstest(speed, lambda v: walls.effusing_speed_cdf(v, 1.0, 1.0)).pvalue > 1e-4
    assert kstest(angle, walls.effusing_angle_cdf).pvalue > 1e-4
    # A gas's own speeds would be refused.
    assert kstest(speed, lambda v: -np.expm1(-(v**2) / 2)).pvalue < 1e-10


def test_the_rest_cools():
    # T ~ N^(1/2), since each takes 1.5 T where the others have T, until a quarter is left after 1.66 decay times.
    # Collisions, 10 to 40 lengths apart, keep the rest in equilibrium much longer than it takes to leave (2000 times).
    # A part in N = 150 and the square of the scatter of one run, 0.09, make the bias.
    count, radius = 600, 0.04
    decay = walls.decay_time(1.0, 1.0, LEAKING.accessible_area(radius), SLIT, radius)
    duration = 4.0 * (math.sqrt(2.0) - 1.0) * decay
    assert walls.cooling_count(duration, count, decay) == pytest.approx(count / 4)
    left, ratios = [], []
    for seed in range(16):
        at = run(LEAKING, gas(LEAKING, [count], [radius], seed=seed))
        at.advance(duration)
        left.append(at.state.count / count)
        ratios.append(at.temperature / walls.cooling_temperature(at.state.count, 1.0, count))
    agrees(left, 0.25, bias=0.01, least=0.05)
    agrees(ratios, 1.0, bias=0.015, least=0.04)
    # At 1 to 2 one could tell T ~ N^(1/3) too.
    assert np.mean(ratios) * 0.5 < 0.57


def test_free_expansion_leaves_the_temperature():
    # No work, no heat: not a digit but rounding. And both halves hold as many in the end.
    divider = Segment((20.0, 0.0), (20.0, 20.0))
    shut = vessel(Rectangle(40, 20), (divider,))
    at = run(shut, gas(shut, [400], [0.2], sampler=lambda rng, n: rng.random((n, 2)) * (20.0, 20.0)))
    before = at.temperature
    at.advance(20.0)
    assert np.all(at.state.position[:, 0] < 20)
    opened = altered(shut, 20.0, SetWall("o0", present=False), shut)
    at.engine.alter(at.state, opened)
    at.advance(300.0)
    assert at.temperature == pytest.approx(before, rel=1e-12)
    right = []
    for _ in range(20):
        at.advance(60.0)
        right.append(np.count_nonzero(at.state.position[:, 0] > 20) / 400)
    agrees(right, 0.5, least=0.05)


def test_a_membrane_makes_osmotic_pressure():
    # The solvent passes and is as dense on both sides; the solute presses on the membrane with n T, as if alone.
    membrane = Segment((20.0, 0.0), (20.0, 20.0))
    place = vessel(Rectangle(40, 20), (membrane,), o0={"passes": Passage((0,))})
    solvent, solute = 300, 60

    def sampler(rng, number):
        return rng.random((number, 2)) * (20.0, 20.0)

    at = run(place, gas(place, [solvent, solute], [0.05, 0.1], [1.0, 5.0], sampler=sampler))
    at.advance(300.0)
    right, pressure = [], []
    length, area = 20 - 0.2, (20 - 0.2) * (20 - 0.2)
    for _ in range(16):
        change = at.advance(250.0)
        mine = at.state.position[at.state.species == 0, 0]
        right.append(np.count_nonzero(mine > 20) / solvent)
        pressure.append(change.wall_impulse[4, 1] / (250.0 * length) / (solute / area))
        assert change.wall_impulse[4, 0] == 0.0
        assert np.all(at.state.position[at.state.species == 1, 0] < 20)
    # The room beside the solute is smaller by a few thousandths: area fraction 0.005.
    agrees(right, 0.5, bias=0.005, least=0.03)
    # B_2 terms of solute with solute and solvent: n_s pi (2R)²/2 and n pi (R + r)²/2, together 1.8 %.
    second = 0.5 * math.pi * (0.04 * solute / area + 0.0225 * solvent / 800)
    agrees(pressure, 1.0 + second, bias=0.01, least=0.03)
