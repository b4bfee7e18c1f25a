"""Hard dumbbells come to equilibrium: equal energies, the laws of speeds and spins, heat capacity and pressure."""

import math

import numpy as np
import pytest
from rotor_gases import INERTIA, between_collisions, collided, dumbbells, looks, modes
from runs import critical, distance

from gasbox import observe
from gasbox.theory import maxwell, rotors

COUNT = 100


@pytest.fixture(scope="module", params=["rotation", "flight"])
def settled(request):
    """Looks at a gas that had all of its energy in rotation at the start, or in flight: energies, speeds and spins."""
    start = (
        {"flight": 0.0, "rotation": 3.0} if request.param == "rotation" else {"flight": 1.5, "rotation": 0.0}
    )
    simulation = dumbbells(COUNT, 0.3, seed=len(request.param), **start)
    begin = modes(simulation)
    simulation.advance(until=60.0)
    apart = 4.0 * between_collisions(simulation)
    found, speeds, spins = [], [], []
    for one in looks(simulation, 120, apart):
        found.append(modes(one))
        speeds.append(np.hypot(*one.state.velocity.T))
        spins.append(one.state.angular_velocity.copy())
    return begin, np.array(found), np.concatenate(speeds), np.concatenate(spins), simulation


def test_energy_is_shared_evenly(settled):
    begin, found, _, _, simulation = settled
    temperature = simulation.temperature()
    assert temperature == pytest.approx(1.0, rel=0.02)
    # At the start one of both had nothing.
    assert min(begin) == 0.0
    assert max(begin) > 0.7
    share = np.mean(found, axis=0) / (0.5 * temperature)
    # In a periodic box a flight has 1 - 1/N of T/2.
    expected = np.array([1 - 1 / COUNT, 1 - 1 / COUNT, 1.0])
    error = observe.block_error(found / (0.5 * temperature))
    assert np.all(error < 0.03)
    assert np.all(np.abs(share - expected) < 4 * np.maximum(error, math.sqrt(2 / COUNT / len(found))))


def test_speeds_and_spins_obey_their_laws(settled):
    _, _, speeds, spins, simulation = settled
    temperature, limit = simulation.temperature(), critical(speeds.size)
    energy = 0.5 * INERTIA * spins**2
    laws = {
        "speed": distance(speeds, lambda v: maxwell.speed_cdf(v, 1.0, temperature * (1 - 1 / COUNT))),
        "spin": distance(spins, lambda w: rotors.angular_velocity_cdf(w, INERTIA, temperature)),
        "rotation": distance(energy, lambda e: rotors.energy_cdf(e, temperature, 1)),
        "whole": distance(energy + 0.5 * speeds**2, lambda e: rotors.energy_cdf(e, temperature, 3)),
    }
    assert {name: value for name, value in laws.items() if value > limit} == {}
    # The moment of inertia of two points, and laws with a degree of freedom more or less, are refused.
    false = [
        distance(spins, lambda w: rotors.angular_velocity_cdf(w, 0.25, temperature)),
        distance(energy, lambda e: rotors.energy_cdf(e, temperature, 2)),
        distance(energy + 0.5 * speeds**2, lambda e: rotors.energy_cdf(e, temperature, 2)),
    ]
    assert min(false) > limit


def test_heat_capacity_by_fluctuations():
    # Fluctuations do not know of the number of molecules, only of the number of looks: a few molecules, often.
    count, number = 12, 800
    simulation = dumbbells(count, 0.3, seed=5)
    apart = 4.0 * between_collisions(simulation, 100.0)
    flight = [np.sum(modes(one)[:2]) for one in looks(simulation, number, apart)]
    found = observe.capacity_at_fixed_energy(flight, 2 * count - 2)
    # A sphere in 3N - 2 dimensions: the share of flight is a Beta variable of N - 1 and N/2.
    a, b = count - 1.0, 0.5 * count
    expected = a / (1 - b / (a + b + 1))
    assert expected == pytest.approx(1.5 * count - 1, rel=1 / count)
    # C ~ 1/variance, which is known to sqrt(2/looks).
    assert found == pytest.approx(expected, rel=4 * math.sqrt(2 / number))
    # Discs alone would have 1 each.
    assert found / count > 1.15


def test_pressure_of_a_dilute_gas():
    # P A/(N T) = 1 + B_2 n + B_3 n²; the third, of which the value is not known, is 0.78 B_2² for discs.
    simulation = dumbbells(COUNT, 0.08, seed=7)
    simulation.advance(until=100.0)
    found, error = collided(simulation, 40_000)
    assert abs(found - 1 - 0.7 * 0.08) < 0.2 * 0.08 + 4 * error
