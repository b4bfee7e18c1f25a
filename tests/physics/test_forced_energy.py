"""Energy under forces: what velocity Verlet keeps, and what baths and heating add.

Expected values: velocity Verlet follows a shadow energy that differs from the true one by terms of order time_step²
(E. Hairer, C. Lubich and G. Wanner, Acta Numerica 12, 399 (2003), doi:10.1017/S0962492902000144), where the force has
no jump: with the force shifted to zero at the cutoff. The size of the wobble, 5.4 time_step² of each disc, was found by
an independent code for 196 discs at density 0.7 and temperature 1 (5.31, 5.36, 5.43, 5.45 at steps of 0.001 to 0.008).
"""

import numpy as np
import pytest
from fluids import fluid, rescaling

from gasbox import observe
from gasbox.state import SetHeating, SetThermostat

STEPS = (0.001, 0.002, 0.004, 0.008)
WOBBLE = 5.4
SMOOTH = {"truncation": "force-shifted"}


def settled(forces, time_step, seed, temperature=1.0):
    """196 discs at density 0.7, in equilibrium, and then left alone."""
    simulation = fluid(
        196,
        0.7,
        temperature,
        forces=forces,
        time_step=time_step,
        seed=seed,
        thermostat=rescaling(temperature, 0.5),
    )
    simulation.advance(until=16.0)
    simulation.apply(SetThermostat(None))
    return simulation


def going_on_from(simulation, time_step):
    """The same places and velocities under another time step."""
    other = fluid(196, 0.7, 1.0, forces=SMOOTH, time_step=time_step)
    other.state.position[:], other.state.velocity[:] = simulation.state.position, simulation.state.velocity
    other.dynamics.resync(other.state)
    return other


def energies(simulation, duration, every=0.08):
    """Energy of each disc at equal times apart."""
    begin, found = simulation.time, []
    for turn in range(1, round(duration / every) + 1):
        simulation.advance(until=begin + turn * every)
        found.append(observe.internal_energy(simulation.state, simulation.geometry))
    return np.array(found) / simulation.state.count


def drift(values, every=0.08):
    """Slope of a course in time, and its standard error from sixteen pieces of it."""
    pieces = np.array_split(values, 16)
    middle = np.array([piece.mean() for piece in pieces])
    time = every * len(values) * (np.arange(16) + 0.5) / 16
    (slope, _), covariance = np.polyfit(time, middle, 1, cov=True)
    return slope, np.sqrt(covariance[0, 0])


def test_energy_wobbles_with_the_square_of_the_step():
    # From the same starts, since a fluid that is warmer by chance wobbles more.
    starts = [settled(SMOOTH, 0.004, seed) for seed in range(4)]
    wobble = [
        np.mean([energies(going_on_from(start, step), 24.0).std() for start in starts]) for step in STEPS
    ]
    slope, _ = np.polyfit(np.log(STEPS), np.log(wobble), 1)
    assert slope == pytest.approx(2.0, abs=0.1)
    # Of single starts it scatters by 13 %, since their energies do: three standard errors of four.
    assert np.array(wobble) / np.array(STEPS) ** 2 == pytest.approx(WOBBLE, rel=0.2)


def check_no_drift(steps):
    simulation = settled(SMOOTH, 0.004, seed=7)
    found = energies(simulation, steps * 0.004)
    slope, error = drift(found)
    assert abs(slope) < 4.0 * error
    # Over the whole run it would be less than the wobble.
    assert abs(slope) * steps * 0.004 < WOBBLE * 0.004**2
    return simulation


def test_energy_does_not_drift_in_a_hundred_thousand_steps():
    simulation = check_no_drift(100_000)
    assert np.abs(simulation.momentum()).max() < 1e-13 * np.abs(simulation.state.velocity).sum()


@pytest.mark.validate
def test_energy_does_not_drift_in_a_million_steps():
    simulation = check_no_drift(1_000_000)
    assert np.abs(simulation.momentum()).max() < 1e-13 * np.abs(simulation.state.velocity).sum()


def test_heating_adds_its_power():
    power, time = 0.002, 40.0
    simulation = settled(SMOOTH, 0.004, seed=3, temperature=0.6)
    begin, count = simulation.time, simulation.state.count
    before = observe.internal_energy(simulation.state, simulation.geometry)
    given = count * power * time
    for turn, sign in enumerate((1.0, -1.0), 1):
        simulation.apply(SetHeating(sign * power))
        simulation.advance(until=begin + turn * time)
        rise = observe.internal_energy(simulation.state, simulation.geometry) - before
        expected = given if sign > 0.0 else 0.0
        assert simulation.dynamics.tallies.heater_heat[0] == pytest.approx(expected, abs=1e-10 * given)
        # Two moments of the wobble, with a margin of six.
        assert rise == pytest.approx(expected, abs=6.0 * WOBBLE * 0.004**2 * count)
    assert simulation.dynamics.tallies.thermostat_heat[0] != 0.0


@pytest.mark.parametrize("kind", ["velocity-rescaling", "langevin"])
def test_heat_of_a_thermostat_is_what_the_gas_gains(kind):
    thermostat = {"kind": kind, "temperature": 0.7, "time": 0.5}
    simulation = fluid(196, 0.7, 0.7, forces=SMOOTH, time_step=0.004, thermostat=thermostat)
    simulation.advance(until=10.0)
    tallies, count = simulation.dynamics.tallies, simulation.state.count
    before = observe.internal_energy(simulation.state, simulation.geometry)
    heat = float(tallies.thermostat_heat[0])
    simulation.apply(SetThermostat(2.0))
    simulation.advance(until=30.0)
    rise = observe.internal_energy(simulation.state, simulation.geometry) - before
    assert rise > 1.3 * count
    # What Verlet loses is the wobble, whose phase a thermostat shifts, so that it walks at random.
    assert rise == pytest.approx(float(tallies.thermostat_heat[0]) - heat, abs=0.005 * rise)
