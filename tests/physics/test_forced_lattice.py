"""Crystals at T = 0: energies and pressures of the engine are sums over the neighbours of a lattice.

Expected values: sums over a triangular lattice, by an independent code, to all digits given; the truncated law reaches
18 neighbours. The whole table agrees with `gasbox.theory.lattice`.
"""

import math

import numpy as np
import pytest
from fluids import crystal

from gasbox.scenario import pair_laws
from gasbox.theory.lattice import lattice_density, lattice_energy, lattice_pressure

# Cutoff, spacing at rest, density, energy of each disc.
AT_REST = [(2.5, 1.113201, 0.931798, -3.172077), (3.0, 1.112180, 0.933510, -3.273551)]
# Density, energy of each disc and pressure, cutoff 2.5.
SQUEEZED = [(0.9165, -3.16429, -0.84141), (1.0, -2.98716, 5.81002)]


def cold(density, cutoff, truncation="shifted"):
    return crystal(196, density, 0.0, forces={"cutoff": cutoff, "truncation": truncation})


def energy_and_pressure(simulation):
    state = simulation.state
    return state.potential / state.count, 0.5 * state.virial / simulation.geometry.area


@pytest.mark.parametrize(("cutoff", "spacing", "density", "energy"), AT_REST)
def test_crystal_at_rest(cutoff, spacing, density, energy):
    simulation = cold(lattice_density(spacing), cutoff)
    found, pressure = energy_and_pressure(simulation)
    assert lattice_density(spacing) == pytest.approx(density, abs=2e-6)
    assert found == pytest.approx(energy, abs=1e-6)
    # The spacing is rounded to 5e-7, and the pressure has the slope -180 there.
    assert pressure == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize(("density", "energy", "pressure"), SQUEEZED)
def test_crystal_stretched_and_squeezed(density, energy, pressure):
    found = energy_and_pressure(cold(density, 2.5))
    assert found == pytest.approx((energy, pressure), abs=1e-5)


@pytest.mark.parametrize("truncation", ["shifted", "force-shifted"])
@pytest.mark.parametrize("cutoff", [2.5, 3.0, 4.0])
def test_crystal_as_theory_has_it(cutoff, truncation):
    simulation = cold(0.95, cutoff, truncation)
    law = pair_laws(simulation.scenario)[0, 0]
    assert energy_and_pressure(simulation) == pytest.approx(
        (lattice_energy(law, 0.95), lattice_pressure(law, 0.95)), rel=1e-11
    )


def test_crystal_without_end():
    # A long cutoff, and what is beyond it as if spread evenly: the energy -3.382123 of the full law, to its shells.
    spacing = 1.111455
    simulation = crystal(900, lattice_density(spacing), 0.0, forces={"cutoff": 12.0})
    cut, density = 12.0, lattice_density(spacing)
    within = cut / spacing
    neighbours = _neighbours(within)
    shift = 0.5 * neighbours * 4.0 * (cut**-12 - cut**-6)
    tail = math.pi * density * (0.4 * cut**-10 - cut**-4)
    found, _ = energy_and_pressure(simulation)
    assert found + shift + tail == pytest.approx(-3.382123, abs=5e-6)


def _neighbours(within):
    """How many places of a triangular lattice of spacing 1 are nearer than this."""
    one, two = np.meshgrid(np.arange(-40, 41), np.arange(-40, 41))
    return int(np.count_nonzero(one**2 + one * two + two**2 < within**2)) - 1


def test_crystal_at_rest_stays():
    simulation = cold(lattice_density(1.113201), 2.5)
    assert np.abs(simulation.dynamics.forces(simulation.state)).max() < 1e-11
    simulation.advance(until=5.0)
    assert simulation.energy() < 1e-20
    assert simulation.state.potential / simulation.state.count == pytest.approx(-3.172077, abs=1e-6)


def test_warm_crystal_has_the_heat_capacity_of_dulong_and_petit():
    # Two quadratic terms of T/2 in potential as in kinetic energy; the next term is of order T², measured 1.3 T² here.
    from fluids import Mean, course, rescaling

    temperature = 0.02
    simulation = crystal(196, 0.931798, temperature, thermostat=rescaling(temperature, 0.2))
    simulation.advance(until=20.0)
    warm = Mean.of(course(simulation, 100.0).potential)
    expected = -3.172077 + temperature * (1.0 - 1.0 / 196.0)
    assert warm.agrees(expected, allowance=2.0 * temperature**2)
