"""Forces in company: mixtures share their energy, walls feel the pressure of the virial, gravity makes an atmosphere.

Expected values: equipartition, T (1 - m/M) for each disc of mass m where the total mass M has no momentum; the virial
theorem; the barometric law. At its Boyle temperature, 1.41979, the truncated fluid has B2 = 0, so that a dilute
atmosphere is that of an ideal gas but for the third coefficient. With P = T (n + B2 n² + B3 n³) at each height the mean
height of M g = P0 per width is [T/(m g)]² (n0 + 3/2 B2 n0² + (4 B3 + 2 B2²)/3 n0³)/(number per width), n0 at the floor.
"""

import math

import numpy as np
import pytest
from fluids import WRITTEN, Mean, langevin, rescaling, run_of
from scipy import integrate, optimize

from gasbox import observe
from gasbox.theory.finite import energy_share

BOYLE = 1.41979


def test_species_of_a_mixture_share_their_energy():
    # Not a bath but collisions do it: alone, from two temperatures.
    species = [
        {"name": "light", "mass": 1.0, "radius": 0.5, "count": 150, "temperature": 0.6},
        {"name": "heavy", "mass": 8.0, "radius": 0.7, "epsilon": 0.5, "count": 30, "temperature": 1.8},
    ]
    simulation = run_of(species, (22.0, 22.0), {"truncation": "force-shifted"}, 0.004, seed=2)
    simulation.advance(until=60.0)
    found = []
    for turn in range(1, 601):
        simulation.advance(until=60.0 + 0.5 * turn)
        state, geometry = simulation.state, simulation.geometry
        whole = observe.temperature(state, geometry)
        found.append([observe.species_temperature(state, geometry, number) / whole for number in (0, 1)])
    found, total = np.array(found), 150.0 + 30.0 * 8.0
    for number, mass in ((0, 1.0), (1, 8.0)):
        mean = Mean.of(found[:, number])
        assert mean.error < 0.03
        assert mean.agrees(energy_share(mass, total, 2))


@pytest.mark.parametrize(("law", "temperature"), [("lennard-jones", 0.7), ("soft-sphere", 1.0)])
def test_walls_feel_the_pressure_of_the_virial(law, temperature):
    count, side, radius, time = 200, 26.0, 0.5, 120.0
    atom = {"name": "atom", "radius": radius, "count": count, "temperature": temperature}
    forces = {"law": law, "truncation": "force-shifted"}
    bath = rescaling(temperature, 0.5)
    simulation = run_of([atom], (side, side), forces, 0.004, seed=6, periodic=(), thermostat=bath)
    simulation.advance(until=20.0)

    def lever():
        state = simulation.state
        return float(np.sum(state.mass @ ((state.position - 0.5 * side) * state.velocity)))

    before, begin, first = simulation.dynamics.tallies.copy(), simulation.time, lever()
    simulation.advance(until=begin + time)
    change = simulation.dynamics.tallies - before
    wall = observe.wall_pressure(change, simulation.geometry, np.array([radius]), time)
    virial = observe.virial_pressure(
        change,
        simulation.geometry,
        np.array([radius]),
        np.array([count]),
        temperature=simulation.temperature(),
        duration=time,
    )
    # The rest of the virial theorem is what sum m r·v has changed by.
    rest = (lever() - first) / (2.0 * time * (side - 2.0 * radius) ** 2)
    print(f"{wall:.5f} at the walls, {virial - rest:.5f} by the virial")
    # Energy and virial are written every tenth step: 3000 times, half of them independent, of relative spread 0.2.
    assert time / (WRITTEN * 0.004) == pytest.approx(3000)
    assert wall == pytest.approx(virial - rest, rel=4.0 * 0.2 / math.sqrt(1500))
    # It is not the pressure of an ideal gas.
    assert abs(wall * (side - 2.0 * radius) ** 2 / (count * temperature) - 1.0) > 0.1


def mean_height(second, third, temperature, gravity, per_width):
    """Mean height of discs of mass 1 over the lowest place of their centres, in a tall box."""
    weight = per_width * gravity

    def lacking(n):
        return temperature * (n + second * n**2 + third * n**3) - weight

    floor = optimize.brentq(lacking, 0.0, 2.0 * weight / temperature)
    inside = floor + 1.5 * second * floor**2 + (4.0 * third + 2.0 * second**2) / 3.0 * floor**3
    return (temperature / gravity) ** 2 * inside / per_width


def wca_coefficient(temperature):
    """B2 of the purely repulsive law, by quadrature."""

    def integrand(distance):
        energy = 4.0 * (distance**-12 - distance**-6) + 1.0
        return (1.0 - math.exp(-energy / temperature)) * distance

    inner = 0.5 * 0.3**2
    return math.pi * (inner + integrate.quad(integrand, 0.3, 2.0 ** (1.0 / 6.0))[0])


def atmosphere(law, thermostat, seed, count=200, width=400.0, gravity=0.2):
    """Heights and energies of all discs at many moments."""
    atom = {"name": "atom", "radius": 0.5, "count": count, "temperature": BOYLE, "region": {"y": [0.0, 20.0]}}
    simulation = run_of(
        [atom],
        (width, 90.0),
        {"law": law},
        seed=seed,
        periodic=("x",),
        gravity=[0.0, -gravity],
        thermostat=thermostat,
    )
    simulation.advance(until=150.0)
    height, energy = [], []
    for turn in range(1, 301):
        simulation.advance(until=150.0 + 2.0 * turn)
        height.append(simulation.state.position[:, 1] - 0.5)
        energy.append(0.5 * np.sum(simulation.state.velocity**2, axis=1))
    return np.array(height), np.array(energy)


def test_a_dilute_atmosphere_is_barometric():
    height, _ = atmosphere("lennard-jones", langevin(BOYLE, 5.0), seed=4)
    scale = BOYLE / 0.2
    mean = Mean.of(height.mean(axis=1))
    assert mean.error < 0.02 * scale
    assert mean.agrees(mean_height(0.0, 1.5, BOYLE, 0.2, 0.5))
    # The law itself: shares of discs in four layers, each of a quarter by the law of an ideal gas.
    edges = [-scale * math.log(1.0 - share) for share in (0.25, 0.5, 0.75)]
    layers = np.stack([(np.digitize(row, edges)[:, None] == np.arange(4)).mean(axis=0) for row in height])
    for number in range(4):
        # B3 takes 1 % off at the floor.
        assert Mean.of(layers[:, number]).agrees(0.25, allowance=0.005)


def test_repulsion_lifts_an_atmosphere():
    height, energy = atmosphere("wca", rescaling(BOYLE, 1.0), seed=5, count=400)
    second = wca_coefficient(BOYLE)
    expected = mean_height(second, 0.782 * second**2, BOYLE, 0.2, 1.0)
    assert expected > 1.07 * BOYLE / 0.2
    mean = Mean.of(height.mean(axis=1))
    # B4 and what the local density leaves out.
    assert mean.agrees(expected, allowance=0.005 * expected)
    # The bath knows nothing of height, and yet it is as warm above as below.
    high = height > 10.0
    above = Mean.of((energy * high).sum(axis=1) / high.sum(axis=1))
    below = Mean.of((energy * ~high).sum(axis=1) / (~high).sum(axis=1))
    assert above.agrees(below.value, below.error)
    assert above.agrees(BOYLE)
