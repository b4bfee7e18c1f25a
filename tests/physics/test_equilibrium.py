"""Event-driven gases in equilibrium: Maxwell's law by Kolmogorov and Smirnov, equipartition, and few particles."""

import math

import numpy as np
import pytest
from runs import critical, distance, gas, one_gas, settle, theory_of

import gasbox
from gasbox import observe
from gasbox.observe.histograms import energies
from gasbox.observe.motion import speeds
from gasbox.theory import finite, kinetic, maxwell

THREE = [
    {"count": 100, "mass": 1.0},
    {"count": 80, "mass": 4.0, "radius": 0.75},
    {"count": 60, "mass": 16.0, "radius": 1.25},
]


def slowest_exchange(simulation):
    """Rate at which the species that exchanges energy most slowly forgets its own [1/time]."""
    mixture = theory_of(simulation)
    omega = kinetic.collision_rates(mixture, simulation.temperature())
    exchange = 4 * mixture.reduced_mass / (mixture.mass[:, None] + mixture.mass[None, :])
    return float(np.min(np.sum(exchange * omega, axis=1)))


def independent(simulation, frames):
    """The simulation at times far enough apart for energies to be independent: five decay times of the slowest."""
    step = 5.0 / slowest_exchange(simulation)
    for _ in range(frames):
        simulation.advance(until=simulation.time + step)
        yield simulation


@pytest.fixture(scope="module")
def mixture_samples():
    """Speeds and velocities of three species in a walled box, and the temperature."""
    simulation = gas(THREE, 0.15, periodic=False, seed=5)
    settle(simulation, 40)
    samples = [[], [], []]
    for _ in independent(simulation, 150):
        for species in range(3):
            samples[species].append(simulation.state.velocity[simulation.state.species == species].copy())
    return [np.concatenate(one) for one in samples], simulation.temperature()


@pytest.mark.parametrize("species", [0, 1, 2])
def test_speeds_obey_maxwell(mixture_samples, species):
    velocities, temperature = mixture_samples
    values = np.hypot(*velocities[species].T)
    mass = THREE[species]["mass"]
    limit = critical(values.size)
    assert distance(values, lambda v: maxwell.speed_cdf(v, mass, temperature)) < limit
    # The test can tell: a tenth more temperature, and the law of three dimensions, are refused.
    assert distance(values, lambda v: maxwell.speed_cdf(v, mass, 1.1 * temperature)) > limit
    s = math.sqrt(temperature / mass)

    def in_three_dimensions(v):
        x = v / s
        return np.array(
            [math.erf(u / math.sqrt(2)) - math.sqrt(2 / math.pi) * u * math.exp(-u * u / 2) for u in x]
        )

    assert distance(values, in_three_dimensions) > limit


@pytest.mark.parametrize("species", [0, 1, 2])
def test_directions_are_even(mixture_samples, species):
    velocities, _ = mixture_samples
    angle = np.arctan2(velocities[species][:, 1], velocities[species][:, 0])
    assert distance(angle, lambda a: (a + math.pi) / (2 * math.pi)) < critical(angle.size)


def test_equipartition(mixture_samples):
    velocities, temperature = mixture_samples
    for one, sample in zip(THREE, velocities, strict=True):
        mean = 0.5 * one["mass"] * float(np.mean(np.sum(sample**2, axis=1)))
        assert mean == pytest.approx(temperature, rel=3.3 / math.sqrt(len(sample)))


def test_speeds_of_the_default_scenario_settle_on_their_curves():
    simulation = gasbox.Simulation(gasbox.load("three-gases"))
    settle(simulation, 20)
    for species, one in enumerate(simulation.scenario.species):
        values = speeds(simulation.state, species)
        law = distance(values, lambda v, m=one.mass: maxwell.speed_cdf(v, m, simulation.temperature()))
        assert law < critical(values.size)
        edges = observe.bin_edges(
            simulation.scenario.histograms.bins, 0.0, simulation.scenario.histograms.maximum
        )
        shown = observe.speed_histogram(simulation.state, species, edges)
        assert shown.total == one.count
        assert shown.overflow < 0.01 * one.count


@pytest.mark.parametrize("periodic", [True, False])
def test_few_discs_share_a_fixed_energy_evenly(periodic):
    # Four discs, one of mass 3: not Maxwell's law but that of the sphere, 1 - (1 - E/E_max)^(f/2 - 1), with a mean of
    # T (1 - m/M) in a periodic box, where the total momentum is conserved.
    simulation = gas([{"count": 1, "mass": 3.0}, {"count": 3, "mass": 1.0}], 0.15, periodic=periodic, seed=3)
    state, geometry = simulation.state, simulation.geometry
    freedom = observe.degrees_of_freedom(4, geometry)
    drift = observe.momentum(state) / state.mass.sum()
    heat = observe.thermal_energy(state, geometry)
    assert not periodic or np.all(np.abs(drift) < 1e-12)
    samples = [[], []]
    for _ in range(6000):
        simulation.advance(until=simulation.time + 8.0)
        for species in range(2):
            samples[species].append(energies(state, species))
    for species, mass in enumerate((3.0, 1.0)):
        values = np.concatenate(samples[species])
        share = finite.energy_share(mass, 6.0, 2 if periodic else 0)
        law = distance(values, lambda e, top=share * heat: finite.finite_energy_cdf(e, top, freedom))
        # Three light discs of one moment are not independent of each other.
        assert law < critical(len(samples[species]))
        assert distance(values, lambda e: maxwell.energy_cdf(e, simulation.temperature())) > critical(6000)


def test_energy_and_momentum_are_what_they_were():
    simulation = one_gas(200, 0.2)
    energy, momentum = simulation.energy(), np.array(simulation.momentum())
    settle(simulation, 500)
    assert simulation.energy() == pytest.approx(energy, rel=1e-12)
    np.testing.assert_allclose(simulation.momentum(), momentum, atol=1e-11)
