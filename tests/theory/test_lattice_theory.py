"""Crystals at T = 0, tails beyond a cutoff, and the tables of the literature."""

import math

import numpy as np
import pytest
from some_laws import FULL, TRUNCATED, Law

from gasbox.theory import lattice, lennard_jones

pytestmark = pytest.mark.small


@pytest.mark.parametrize(
    ("law", "expected"),
    [
        (FULL, (1.111455, 0.934729, -3.382123)),
        (TRUNCATED, (1.113201, 0.931798, -3.172077)),
        (Law(cutoff=3.0), (1.112180, 0.933510, -3.273551)),
    ],
)
def test_crystals_without_pressure(law, expected):
    # Static sums, known to the last digit given.
    assert tuple(lattice.crystal(law)) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(
    ("law", "density", "energy", "pressure"),
    [
        (FULL, 0.9165, -3.37099, -1.00581),
        (TRUNCATED, 0.9165, -3.16429, -0.84141),
        (FULL, 1.0, -3.21173, 5.57714),
        (TRUNCATED, 1.0, -2.98716, 5.81002),
    ],
)
def test_squeezed_and_stretched_crystals(law, density, energy, pressure):
    assert lattice.lattice_energy(law, density) == pytest.approx(energy, abs=5.1e-6)
    assert lattice.lattice_pressure(law, density) == pytest.approx(pressure, abs=5.1e-6)


@pytest.mark.parametrize("law", [FULL, TRUNCATED, Law("soft-sphere"), Law("yukawa", cutoff=6.0), Law("wca")])
def test_pressure_is_the_slope_of_the_energy(law):
    density, step = 1.07, 1e-5
    slope = (lattice.lattice_energy(law, density + step) - lattice.lattice_energy(law, density - step)) / (
        2 * step
    )
    # P = -de/da = n² de/dn; the difference is good to step² of the third derivative, some 1e3.
    assert lattice.lattice_pressure(law, density) == pytest.approx(density**2 * slope, rel=1e-6, abs=1e-8)


def test_spacing_and_density_belong_together():
    assert lattice.lattice_density(1.0) == pytest.approx(2 / math.sqrt(3))
    assert lattice.lattice_spacing(lattice.lattice_density(1.3)) == pytest.approx(1.3)


def test_what_only_pushes_holds_no_crystal():
    with pytest.raises(ValueError, match="'wca' holds no crystal"):
        lattice.crystal(Law("wca"))


def test_tails_are_integrals():
    distance = np.linspace(2.5, 400.0, 2_000_001)
    energy = 4.0 * (distance**-12 - distance**-6)
    push = 24.0 * (2.0 * distance**-12 - distance**-6)
    whole = math.pi * 0.7 * np.trapezoid(energy * distance, distance)
    assert lennard_jones.energy_tail(0.7, 2.5) == pytest.approx(whole, rel=1e-6)
    whole = 0.5 * math.pi * 0.7**2 * np.trapezoid(push * distance, distance)
    assert lennard_jones.pressure_tail(0.7, 2.5) == pytest.approx(whole, rel=1e-6)


def test_tables_of_the_literature_agree_with_each_other():
    critical = next(point for point in lennard_jones.CRITICAL_POINTS if point.model == "truncated")
    rows = lennard_jones.COEXISTENCE
    assert [row.temperature for row in rows] == sorted(row.temperature for row in rows)
    for row in rows:
        assert row.gas < critical.density < row.liquid
        assert row.temperature < critical.temperature
    # The Ising exponent of two dimensions: eight widths with errors of some 4 %, so 1.5 % of their mean.
    widths = [
        (row.liquid - row.gas) / (1.06 * (critical.temperature - row.temperature) ** 0.125) for row in rows
    ]
    assert np.mean(widths) == pytest.approx(1.0, abs=0.05)
    triple = {point.model: point.temperature for point in lennard_jones.TRIPLE_POINTS}
    assert all(triple[point.model] < point.temperature for point in lennard_jones.CRITICAL_POINTS)
