"""A gas under gravity against the barometric law."""

from __future__ import annotations

import numpy as np
import pytest
from vessels import agrees, gas, kinetic_energy, run, vessel

from gasbox.dynamics import Stepped
from gasbox.geometry import Rectangle
from gasbox.state import Contacts, Tallies
from gasbox.theory import gravity, sediment

WIDTH, HEIGHT, G = 20.0, 60.0, 0.1
RADIUS = 0.05


def atmosphere(place, counts, masses, seed=1, radius=RADIUS):
    """Spread evenly at first: what they lose in height makes them warmer."""
    return gas(place, counts, [radius] * len(counts), masses, seed=seed)


def samples(at, blocks, looks, pause):
    """Blocks of looks at heights and kinetic energies."""
    for _ in range(blocks):
        heights, energies = [], []
        for _ in range(looks):
            at.advance(pause)
            heights.append(at.state.position[:, 1].copy())
            energies.append(0.5 * at.state.mass * (at.state.velocity**2).sum(axis=1))
        yield np.array(heights), np.array(energies)


def test_each_gas_has_its_own_atmosphere():
    # Three gases, Dalton: mean height of each by its own scale height at the common, measured temperature.
    place = vessel(Rectangle(WIDTH, HEIGHT, True), gravity=(0.0, -G))
    counts, masses = [150, 150, 150], [0.5, 1.0, 3.0]
    at = run(place, atmosphere(place, counts, masses))
    at.advance(1500.0)
    room = HEIGHT - 2 * RADIUS
    ratios = []
    for heights, energies in samples(at, 20, 24, 15.0):
        temperature = energies.mean()
        row = []
        for k, mass in enumerate(masses):
            expected = gravity.mean_height(gravity.scale_height(mass, temperature, G), room)
            row.append((heights[:, at.state.species == k].mean() - RADIUS) / expected)
        ratios.append(row)
    # Discs of this size in layers of 7 a unit of length: 0.5 % (local density).
    agrees(ratios, 1.0, bias=0.01, least=0.02)


def test_density_follows_the_barometric_law():
    place = vessel(Rectangle(WIDTH, HEIGHT, True), gravity=(0.0, -G))
    at = run(place, atmosphere(place, [400], [1.0]))
    at.advance(1500.0)
    edges = np.linspace(0.0, HEIGHT - 2 * RADIUS, 9)
    parts = []
    for heights, energies in samples(at, 20, 24, 15.0):
        scale = gravity.scale_height(1.0, energies.mean(), G)
        expected = gravity.expected_height_counts(edges, 400, scale, edges[-1])
        parts.append(np.histogram(heights - RADIUS, edges)[0] / len(heights) / expected)
    agrees(parts, 1.0, bias=0.015)


def test_temperature_is_the_same_at_all_heights():
    place = vessel(Rectangle(WIDTH, HEIGHT, True), gravity=(0.0, -G))
    at = run(place, atmosphere(place, [300], [1.0]))
    at.advance(1500.0)
    ratios = []
    for heights, energies in samples(at, 24, 40, 15.0):
        layers = np.clip((heights / 10.0).astype(int), 0, 3)
        ratios.append([energies[layers == k].mean() / energies.mean() for k in range(4)])
    agrees(ratios, 1.0, bias=2e-3, least=0.02)


def test_floor_and_ceiling_carry_the_weight():
    # P_floor - P_ceiling = N m g/W exactly, but for the momentum that the gas has at the ends of the run.
    place = vessel(Rectangle(WIDTH, 30.0, True), gravity=(0.0, -G))
    at = run(place, gas(place, [150, 50], [0.2, 0.4], [1.0, 4.0]))
    at.advance(300.0)
    momentum = float(at.state.mass @ at.state.velocity[:, 1])
    change = at.advance(4000.0)
    gained = float(at.state.mass @ at.state.velocity[:, 1]) - momentum
    floor, ceiling = change.wall_impulse[2].sum(), change.wall_impulse[3].sum()
    weight = gravity.weight_pressure(1, at.state.mass.sum(), G, WIDTH)
    assert (floor - ceiling - gained) / (4000.0 * WIDTH) == pytest.approx(weight, rel=1e-12)
    assert (floor - ceiling) / (4000.0 * WIDTH) == pytest.approx(weight, rel=1e-3)


def test_hard_discs_stand_higher_than_points():
    # Local density: with 2 discs a diameter of width and ell = 20 diameters, 1.0769 times as high.
    count, radius, width = 200, 0.5, 100.0
    place = vessel(Rectangle(width, 200.0, True), gravity=(0.0, -0.05))
    at = run(place, gas(place, [count], [radius], sampler=_barometric(width, 20.0)))
    at.advance(2000.0)
    ratios = []
    for heights, energies in samples(at, 10, 25, 40.0):
        scale = gravity.scale_height(1.0, energies.mean() * 2 * count / (2 * count - 1), 0.05)
        expected = sediment.hard_disc_mean_height(count, width, radius, scale)
        assert expected > 1.06 * scale
        ratios.append((heights.mean() - radius) / expected)
    agrees(ratios, 1.0, bias=0.01, least=0.02)


def _barometric(width, scale):
    def draw(rng, number):
        return np.stack([rng.random(number) * width, 0.6 + rng.exponential(scale, number)], axis=1)

    return draw


def test_the_stepped_rule_has_the_same_atmosphere():
    place = vessel(Rectangle(WIDTH, HEIGHT, True), gravity=(0.0, -G))
    state = atmosphere(place, [300], [1.0])
    engine = Stepped(state, place, 0.02, Tallies.zero(1, 4), Contacts.empty(0))
    engine.advance(state, 400.0)
    heights, energies = [], []
    for k in range(12):
        rows = []
        for i in range(15):
            engine.advance(state, 400.0 + 10.0 * (15 * k + i + 1))
            rows.append((state.position[:, 1].mean() - RADIUS, kinetic_energy(state) / 300))
        heights.append(np.mean(rows, axis=0)[0])
        energies.append(np.mean(rows, axis=0)[1])
    expected = gravity.mean_height(
        gravity.scale_height(1.0, float(np.mean(energies)), G), HEIGHT - 2 * RADIUS
    )
    agrees(np.array(heights) / expected, 1.0, bias=0.02)
