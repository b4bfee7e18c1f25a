"""What discs are is told from how they stand: made-up cases, and runs far from every border."""

from __future__ import annotations

import numpy as np
import pytest

from gasbox.sweep import MATTERS, Recipe, measure, scenario_at, verdict
from gasbox.sweep.verdict import unevenness

SMALL = Recipe(particles=120, settle=60.0, measure=20.0)


@pytest.mark.parametrize(
    ("gas", "solid", "uneven", "matter"),
    [
        (0.95, 0.0, 0.05, "gas"),
        (0.50, 0.0, 0.08, "fluid"),
        (0.02, 0.1, 0.02, "liquid"),
        (0.00, 0.97, 0.01, "solid"),
        (0.00, 0.50, 0.02, "liquid and solid"),
        (0.20, 0.05, 0.50, "gas and liquid"),
        (0.10, 0.40, 0.50, "gas, liquid, solid"),
        (0.10, 0.80, 0.50, "gas and solid"),
    ],
)
def test_every_case(gas: float, solid: float, uneven: float, matter: str) -> None:
    assert verdict(gas, solid, uneven, 500) == matter


def test_every_case_has_been_tried() -> None:
    tried = {
        verdict(gas, solid, uneven, 500)
        for gas in np.linspace(0.0, 1.0, 21)
        for solid in np.linspace(0.0, 1.0 - gas, 21)
        for uneven in (0.0, 0.5)
    }
    assert tried == set(MATTERS)


def test_chance_alone_is_not_uneven() -> None:
    random = np.random.default_rng(3)
    size = np.array([30.0, 20.0])
    for number in (50, 500):
        assert verdict(0.9, 0.0, unevenness(random.random((number, 2)) * size, size), number) == "gas"


def test_a_slab_is_as_uneven_as_its_formula_says() -> None:
    # Half of the box along x is full, evenly: 1/pi * sin(pi/2) * 2.
    size = np.array([10.0, 10.0])
    row = np.stack([np.linspace(3.0, 8.0, 4000, endpoint=False), np.full(4000, 1.0)], axis=1)
    row[::2, 1] = 6.0
    assert unevenness(row, size) == pytest.approx(2.0 / np.pi, abs=1e-3)


@pytest.mark.parametrize("density", [0.03, 0.4, 0.73, 0.92, 0.98])
@pytest.mark.parametrize("particles", [20, 201, 500])
def test_every_point_can_be_placed(density: float, particles: int) -> None:
    scenario = scenario_at(0.4, density, Recipe(particles=particles))
    assert scenario.species[0].count == particles
    area = scenario.geometry().area
    assert particles / area == pytest.approx(density)


@pytest.mark.parametrize(
    ("temperature", "density", "matter"),
    [(0.3, 0.3, "gas and solid"), (0.3, 0.92, "solid"), (0.7, 0.72, "liquid"), (1.0, 0.08, "gas")],
)
def test_points_far_from_every_border(temperature: float, density: float, matter: str) -> None:
    found = measure(temperature, density, SMALL)
    assert found is not None
    assert found.matter == matter
    assert found.gas + found.liquid + found.solid == pytest.approx(1.0)


def test_pressure_and_energy_of_a_known_point() -> None:
    # Monte Carlo of 400 discs: U/N = -1.7644(9), P = 1.8102(43) at density 0.7 and temperature 1, cut off at 2.5.
    found = measure(1.0, 0.7, Recipe(particles=400, settle=30.0, measure=100.0))
    assert found is not None
    assert found.potential == pytest.approx(-1.7644, abs=0.01)
    assert found.pressure == pytest.approx(1.8102, abs=0.03)


def test_a_run_can_be_given_up() -> None:
    assert measure(0.4, 0.3, SMALL, lambda: True) is None
