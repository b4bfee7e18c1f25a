"""Pistons that are free: how they swing on a gas, where they rest, and what they pass on."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import curve_fit
from vessels import agrees, gas, kinetic_energy, run, vessel

from gasbox.geometry import Piston, Rectangle, Segment
from gasbox.state import ContactKind
from gasbox.theory import fluid, piston

DIVIDER = Segment((20.0, 0.0), (20.0, 10.0))


def swing(time, middle, decay, omega, cosine, sine):
    return middle + np.exp(-decay * time) * (cosine * np.cos(omega * time) + sine * np.sin(omega * time))


def test_a_free_piston_swings_on_the_gas():
    # A lid is given a tenth of the column's height to swing; dense enough for sound, lambda = h/30, so that it swings
    # by the adiabatic stiffness. omega² + decay² = k/(M + N m/3). Of the tolerance, 0.2 % for the amplitude (of the
    # restoring force P L ((1 + x/h)^-2 - 1): -0.19 (x/h)²), the rest for noise that the fit takes for swinging.
    count, radius, width, height, heavy = 400, 0.2, 20.0, 40.0, 2000.0
    eta = count * math.pi * radius**2 / (width * height)
    length, room = width - 2 * radius, height - 2 * radius
    pressure = count * fluid.compressibility(eta) / (length * room)
    spring = piston.column_stiffness(piston.adiabatic_exponent(eta), pressure, length, room)
    expected = piston.piston_frequency(spring, heavy, float(count))
    outside = pressure * length / width
    place = vessel(Rectangle(width, height), top={"motion": Piston(heavy, outside, speed=4.0 * expected)})
    times, squares = np.arange(1, 141) * 5.0, []
    for seed in range(12):
        at = run(place, gas(place, [count], [radius], seed=seed))
        before = count + 0.5 * heavy * (4.0 * expected) ** 2
        lifts = []
        for _ in times:
            at.advance(5.0)
            lifts.append(at.state.wall_displacement[3])
        has = kinetic_energy(at.state) + 0.5 * heavy * at.state.wall_velocity[3] ** 2
        assert has + outside * width * lifts[-1] == pytest.approx(before, rel=1e-10)
        (_, decay, omega, *_), _ = curve_fit(swing, times, lifts, (0.0, 0.001, expected, 0.0, 4.0))
        squares.append((omega**2 + decay**2) / expected**2)
    agrees(squares, 1.0, bias=0.02, least=0.02)


def test_where_a_heavy_lid_rests():
    # Points in a field of gravity under a lid: the height h has the weight (ell (1 - exp(-h/ell)))^N exp(-F h/T), with
    # F = p L + M g; T = 2 K/(2 N + 1) with the piston. At fixed enthalpy instead of T, a part in N of the difference.
    count, width, heavy, outside, g = 200, 20.0, 100.0, 0.3, 0.01
    place = vessel(Rectangle(width, 30), gravity=(0.0, -g), top={"motion": Piston(heavy, outside)})
    state = gas(place, [count], [0.02])
    at = run(place, state)

    def whole() -> float:
        has = kinetic_energy(state) + 0.5 * heavy * at.state.wall_velocity[3] ** 2
        lifted = g * float(state.mass @ state.position[:, 1]) + heavy * g * at.state.wall_displacement[3]
        return has + lifted + outside * width * at.state.wall_displacement[3]

    before = whole()
    at.advance(500.0)
    ratios = []
    for _ in range(12):
        looks = []
        for _ in range(50):
            at.advance(20.0)
            energy = kinetic_energy(state) + 0.5 * heavy * at.state.wall_velocity[3] ** 2
            looks.append((30 - 0.04 + at.state.wall_displacement[3], energy))
        height, energy = np.mean(looks, axis=0)
        ratios.append(height / mean_height(count, energy / (count + 0.5), outside * width + heavy * g, g))
    agrees(ratios, 1.0, bias=2 / count, least=0.01)
    assert whole() == pytest.approx(before, rel=1e-10)


def mean_height(count, temperature, force, g) -> float:
    ell, h = temperature / g, np.linspace(1.0, 200.0, 20_000)
    logarithm = count * np.log(-np.expm1(-h / ell)) - force * h / temperature
    weight = np.exp(logarithm - logarithm.max())
    return float((h * weight).sum() / weight.sum())


def test_a_piston_comes_to_where_the_pressures_are_equal():
    # Over a long time P = p; exactly, but for the change of the piston's momentum.
    place = vessel(Rectangle(20, 30), top={"motion": Piston(50.0, 0.3)})
    at = run(place, gas(place, [200], [0.05]))
    at.advance(200.0)
    duration, begin = 3000.0, at.state.wall_velocity[3]
    force = at.advance(duration).wall_impulse[3].sum() / duration
    outside = 0.3 * 20 + 50.0 * (at.state.wall_velocity[3] - begin) / duration
    assert force == pytest.approx(outside, rel=1e-9)
    assert force == pytest.approx(0.3 * 20, rel=0.01)


def test_an_adiabatic_piston_between_two_gases():
    # No heat, but energy and momentum through its jitter: each impulse on the piston is one on the gas.
    place = vessel(Rectangle(40, 10), (DIVIDER,), o0={"motion": Piston(10.0)})
    state = gas(place, [120], [0.05])
    hot = state.position[:, 0] < 20
    state.velocity[hot] *= 1.4
    at = run(place, state)
    before = kinetic_energy(state)
    contacts = at.collect(600.0)
    hits = (contacts.kind == ContactKind.WALL) & (contacts.second == 4)
    sides = (contacts.kind == ContactKind.WALL) & (contacts.second < 2)
    assert hits.sum() > 1000
    speed, impulse = at.state.wall_velocity[4], contacts.impulse[:, 0]
    scale = np.abs(impulse[hits]).sum()
    assert 10.0 * speed == pytest.approx(-impulse[hits].sum(), abs=1e-12 * scale)
    assert kinetic_energy(state) + 5.0 * speed**2 == pytest.approx(before, rel=1e-10)
    # Nobody passes it, and in the end both gases press alike: on the walls behind them, within some errors of hits.
    now = state.position[:, 0] < 20 + at.state.wall_displacement[4]
    assert np.array_equal(now, hot)
    late = sides & (contacts.time > 100.0)
    left, right = (np.abs(impulse[late & (contacts.second == wall)]) for wall in (0, 1))
    error = math.sqrt((left**2).sum() + (right**2).sum())
    assert abs(left.sum() - right.sum()) < 4.5 * error
    assert error < 0.1 * left.sum()
