"""Thermostats, heating and barostat: what they aim at, how fast, and how much it fluctuates."""

from __future__ import annotations

import math

import numpy as np
import pytest
from forced_gases import energy, rectangle, scenario

from gasbox import Simulation
from gasbox.state import SetHeating, SetThermostat

FREE = {"law": "none"}


def ideal(count=2000, temperature=1.0, seed=1, side=40.0, masses=(1.0,), **more):
    """Discs without forces."""
    species = [{"name": f"s{k}", "radius": 0.3, "mass": mass} for k, mass in enumerate(masses)]
    rng = np.random.default_rng(seed)
    kind = np.arange(count) % len(masses)
    position = rng.uniform(0, side, (count, 2))
    velocity = rng.normal(size=(count, 2)) * np.sqrt(temperature / np.take(masses, kind))[:, None]
    mass = np.take(masses, kind)[:, None]
    velocity -= (mass * velocity).sum(axis=0) / mass.sum()
    names = [f"s{k}" for k in kind]
    scene = scenario(
        rectangle(side, side), position, velocity, names, species, forces=FREE, time_step=0.02, **more
    )
    return Simulation(scene)


def bath(kind, temperature, time=1.0):
    return {"kind": kind, "temperature": temperature, "time": time}


def test_langevin_forgets_at_its_rate_and_warms_every_mass():
    simulation = ideal(2000, 1.0, thermostat=bath("langevin", 1.0, 2.0), masses=(0.2, 5.0))
    state, start = simulation.state, simulation.state.velocity.copy()
    weight = state.mass[:, None]
    for time in (1.0, 3.0):
        simulation.advance(until=time)
        kept = float((weight * start * state.velocity).sum() / (weight * start * start).sum())
        assert kept == pytest.approx(math.exp(-time / 2.0), abs=4 / math.sqrt(4000))
    # Independent velocities every few relaxation times: 10 times 1000 discs of each mass.
    found = np.zeros(2)
    for turn in range(10):
        simulation.advance(until=3.0 + 5.0 * (turn + 1))
        energies = 0.5 * state.mass * (state.velocity**2).sum(axis=1)
        found += [energies[state.species == kind].mean() for kind in (0, 1)]
    # Energies of single discs scatter as much as they are large.
    assert found / 10 == pytest.approx([1.0, 1.0], abs=4.5 / math.sqrt(10 * 1000))


def test_langevin_spreads_free_discs():
    """Einstein: the mean square of the way is 4 D t, D = T time/mass, after long times."""
    simulation = ideal(3000, 1.0, thermostat=bath("langevin", 1.0, 0.2))
    start = simulation.dynamics.memory()["position"]
    way, last = np.zeros_like(start), start
    for step in range(1, 41):
        simulation.advance(until=0.5 * step)
        now = simulation.state.position.copy()
        hop = now - last
        way += hop - 40.0 * np.rint(hop / 40.0)
        last = now
    expected = 4 * 0.2 * (20.0 - 0.2 * (1 - math.exp(-20.0 / 0.2)))
    assert (way**2).sum(axis=1).mean() == pytest.approx(expected, rel=4.5 / math.sqrt(3000))


def test_rescaling_relaxes_at_its_rate():
    simulation = ideal(5000, 1.0, thermostat=bath("velocity-rescaling", 3.0, 2.0))
    for time in (1.0, 2.0, 5.0):
        simulation.advance(until=time)
        expected = 3.0 - 2.0 * math.exp(-time / 2.0)
        assert simulation.temperature() == pytest.approx(expected, rel=4.5 / math.sqrt(5000))


def test_rescaling_gives_the_canonical_fluctuations():
    """The kinetic energy of f degrees of freedom has the mean f T/2 and the variance f T²/2."""
    simulation = ideal(11, 0.7, thermostat=bath("velocity-rescaling", 0.7, 0.3))
    energies = []
    for turn in range(1500):
        simulation.advance(until=0.6 * (turn + 1))
        energies.append(simulation.energy())
    energies, freedom = np.array(energies[10:]), 20
    spread = 0.7 * math.sqrt(freedom / 2)
    assert energies.mean() == pytest.approx(freedom * 0.7 / 2, abs=5 * spread / math.sqrt(1490))
    # The gamma distribution of 10 has an excess of 0.6; neighbours in time are correlated by 0.14.
    assert energies.var() == pytest.approx(spread**2, rel=5 * math.sqrt(2.8 / 1490))
    assert np.abs(simulation.momentum()).max() < 1e-10


def test_two_species_under_rescaling_have_one_temperature():
    simulation = ideal(400, 1.0, masses=(1.0, 10.0), thermostat=bath("velocity-rescaling", 2.0))
    simulation.advance(until=20.0)
    tallies = simulation.dynamics.tallies
    assert energy(simulation) == pytest.approx(800 / 2 + float(tallies.thermostat_heat[0]), rel=0.1)


@pytest.mark.parametrize("power", [0.25, -0.03])
def test_heating_is_so_much_for_each_disc(power):
    simulation = ideal(300, 1.0, heating={"power": power})
    before = simulation.energy()
    simulation.advance(until=10.0)
    gain = 300 * power * 10.0
    assert simulation.dynamics.tallies.heater_heat[0] == pytest.approx(gain, rel=1e-9)
    assert simulation.energy() - before == pytest.approx(gain, rel=1e-9)


@pytest.mark.small
def test_no_more_heat_is_taken_than_there_is():
    simulation = ideal(6, 1.0, heating={"power": -1.0})
    before = simulation.energy()
    simulation.advance(until=3.0)
    assert simulation.energy() == pytest.approx(0.0, abs=1e-20)
    assert simulation.dynamics.tallies.heater_heat[0] == pytest.approx(-before, rel=1e-9)


def test_a_barostat_relaxes_an_ideal_gas_at_its_rate():
    """1/A goes to P/(N T) exponentially, with the time of the barostat."""
    count, side, time = 4000, 40.0, 8.0
    simulation = ideal(
        count,
        side=side,
        thermostat=bath("velocity-rescaling", 1.0, 0.1),
        barostat={"pressure": 2 * count / side**2, "time": time},
    )
    for until in (4.0, 8.0, 24.0, 60.0):
        simulation.advance(until=until)
        area = simulation.geometry.at(simulation.state.wall_displacement).size.prod()
        expected = 2.0 - 1.0 * math.exp(-until / time)
        # ln A fluctuates by 1/sqrt(N); the pressure follows the thermostat with a delay of its own.
        assert side**2 / area == pytest.approx(expected, rel=4.5 / math.sqrt(count) + 0.02)


def test_a_barostat_gives_the_fluctuations_of_the_area():
    """Of an ideal gas: ln A has the variance 1/N, and a mean that is of this order, too."""
    simulation = ideal(
        25, side=10.0, thermostat=bath("langevin", 1.0, 1.0), barostat={"pressure": 0.25, "time": 60.0}
    )
    found = []
    for turn in range(800):
        simulation.advance(until=15.0 * (turn + 1))
        area = simulation.geometry.at(simulation.state.wall_displacement).size.prod()
        found.append(math.log(area / 100.0))
    # Two hundred times the time of the barostat: a hundred independent values.
    assert np.mean(found) == pytest.approx(0.0, abs=2.5 / 25 + 4 * math.sqrt(1 / 25 / 100))
    assert np.var(found) == pytest.approx(1 / 25, rel=3 * math.sqrt(2 / 100))


def test_aims_go_evenly():
    simulation = ideal(3000, 1.0, thermostat=bath("velocity-rescaling", 1.0, 0.02))
    simulation.advance(until=1.0)
    simulation.dynamics.control(simulation.state, SetThermostat(5.0, 8.0))
    for time, aim in ((3.0, 2.0), (5.0, 3.0), (9.0, 5.0), (12.0, 5.0)):
        simulation.advance(until=time)
        assert simulation.temperature() == pytest.approx(aim, rel=5 / math.sqrt(3000))
    # Another aim on the way begins where the first one is.
    simulation.dynamics.control(simulation.state, SetThermostat(1.0, 4.0))
    simulation.advance(until=14.0)
    simulation.dynamics.control(simulation.state, SetThermostat(6.0, 3.0))
    simulation.advance(until=15.0)
    assert simulation.temperature() == pytest.approx(4.0, rel=5 / math.sqrt(3000))
    simulation.dynamics.control(simulation.state, SetThermostat(None))
    simulation.dynamics.control(simulation.state, SetHeating(0.5))
    before = simulation.energy()
    simulation.advance(until=17.0)
    assert simulation.energy() - before == pytest.approx(3000, rel=1e-9)


def test_time_integrals_are_those_of_what_is_seen():
    """Kinetic and potential energy, virial and area, sampled every ten steps."""
    position = np.stack(np.meshgrid(np.arange(8), np.arange(8)), axis=-1).reshape(-1, 2) * 1.2 + 0.3
    velocity = np.random.default_rng(1).normal(size=position.shape)
    velocity -= velocity.mean(axis=0)
    barostat = {"pressure": 1.0, "time": 5.0}
    simulation = Simulation(scenario(rectangle(9.6, 9.6), position, velocity, barostat=barostat))
    sums = np.zeros(3)
    for step in range(10, 401, 10):
        simulation.advance(until=0.005 * step)
        state = simulation.state
        size = simulation.geometry.at(state.wall_displacement).size
        sums += 0.05 * np.array([simulation.energy(), state.potential, size.prod()])
    tallies = simulation.dynamics.tallies
    found = [tallies.kinetic_time[0], tallies.potential_time[0], tallies.area_time[0]]
    # The area is changed at the very step at which it is sampled.
    assert found == pytest.approx(sums, rel=0.01)
