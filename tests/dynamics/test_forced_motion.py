"""Laws of motion under the forced rule: momentum, reversal, symmetries, and energy in the books."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import apart, energy, lattice, rectangle, scattered, scenario

from gasbox import Simulation

RESCALING = {"kind": "velocity-rescaling", "temperature": 1.5, "time": 0.5}
LANGEVIN = {"kind": "langevin", "temperature": 1.5, "time": 0.5}
BAROSTAT = {"pressure": 2.0, "time": 5.0}
BATHS = {
    "rescaling": {"thermostat": RESCALING},
    "langevin": {"thermostat": LANGEVIN},
    "heating": {"heating": {"power": 0.1}},
    "cooling": {"heating": {"power": -0.05}},
    "barostat": {"barostat": BAROSTAT},
    "all": {"thermostat": RESCALING, "heating": {"power": 0.3}, "barostat": {"pressure": 0.5, "time": 5.0}},
}
SMOOTH = {"truncation": "force-shifted"}


def crystal(seed=1, spacing=1.3, speed=1.0):
    """144 discs on a lattice, with velocities that add up to nothing."""
    container, position = lattice(12, 12, spacing)
    velocity = speed * np.random.default_rng(seed).normal(size=position.shape)
    return container, position, velocity - velocity.mean(axis=0)


def drift(simulation):
    """Total momentum along either direction, over the sum of all momenta."""
    state = simulation.state
    return np.abs(simulation.momentum()).max() / np.abs(state.mass[:, None] * state.velocity).sum()


@pytest.mark.parametrize("baths", [{}, BATHS["rescaling"], BATHS["all"]], ids=["alone", "rescaling", "all"])
def test_momentum_over_ten_thousand_steps(baths):
    position, velocity = scattered(1, 20.0, 18.0, 180)
    simulation = Simulation(scenario(rectangle(20, 18), position, velocity, **baths))
    simulation.advance(until=50.0)
    assert drift(simulation) < 1e-13


def test_momentum_of_a_mixture():
    species = [{"name": "atom", "radius": 0.5}, {"name": "large", "radius": 1.0, "mass": 7.0, "charge": -1.0}]
    position, velocity = scattered(2, 20.0, 18.0, 60, gap=[0.97, 1.9] * 30)
    velocity[1::2] *= -1.0 / 7.0
    forces = {"charges": {"strength": 3.0}}
    simulation = Simulation(
        scenario(rectangle(20, 18), position, velocity, ["atom", "large"] * 30, species, forces=forces)
    )
    before = np.array(simulation.momentum())
    simulation.advance(until=50.0)
    scale = np.abs(simulation.state.mass[:, None] * simulation.state.velocity).sum()
    assert np.abs(simulation.momentum() - before).max() < 1e-13 * scale


@pytest.mark.parametrize("truncation", ["shifted", "force-shifted"])
def test_reversal(truncation):
    """Velocities turned round, the gas goes back to where it came from, by other lists than on its way there."""
    container, position, velocity = crystal()
    simulation = Simulation(scenario(container, position, velocity, forces={"truncation": truncation}))
    simulation.advance(until=1.0)
    assert apart(simulation.state.position, position, simulation.geometry) > 0.5
    simulation.state.velocity *= -1.0
    simulation.dynamics.resync(simulation.state)
    simulation.advance(until=2.0)
    assert apart(simulation.state.position, position, simulation.geometry) < 1e-9
    assert np.abs(simulation.state.velocity + velocity).max() < 1e-9


@pytest.mark.small
def test_reversal_of_a_few():
    position, velocity = scattered(3, 4.0, 4.0, 5)
    simulation = Simulation(scenario(rectangle(4, 4), position, velocity))
    simulation.advance(until=0.1)
    simulation.state.velocity *= -1.0
    simulation.dynamics.resync(simulation.state)
    simulation.advance(until=0.2)
    assert apart(simulation.state.position, position, simulation.geometry) < 1e-11


def test_a_common_velocity_changes_nothing_but_the_place():
    container, position, velocity = crystal(2)
    common, ends = np.array([1.75, -0.5]), []
    for extra in (0.0, 1.0):
        simulation = Simulation(scenario(container, position, velocity + extra * common))
        simulation.advance(until=1.5)
        ends.append(simulation.state.position - extra * 1.5 * common)
    assert apart(*ends, simulation.geometry) < 1e-9


@pytest.mark.parametrize("turned", [False, True], ids=["mirrored", "axes exchanged"])
def test_mirrors(turned):
    """Rounding alone differs, since strips lie along x."""
    position, velocity = scattered(4, 15.0, 11.0, 100)
    one = Simulation(scenario(rectangle(15, 11), position, velocity))
    if turned:
        other = Simulation(scenario(rectangle(11, 15), position[:, ::-1], velocity[:, ::-1]))
    else:
        other = Simulation(
            scenario(rectangle(15, 11), [15.0, 0.0] + [-1.0, 1.0] * position, velocity * [-1, 1])
        )
    for simulation in (one, other):
        simulation.advance(until=1.0)
    back = other.state.position[:, ::-1] if turned else [15.0, 0.0] + [-1.0, 1.0] * other.state.position
    assert apart(back, one.state.position, one.geometry) < 1e-9


def books(simulation):
    """All heat and work that was booked, and the sum of their sizes."""
    tallies = simulation.dynamics.tallies
    parts = [tallies.thermostat_heat, tallies.heater_heat, tallies.barostat_work, tallies.wall_heat]
    flows = [float(part.sum()) for part in parts]
    return sum(flows), sum(map(abs, flows))


@pytest.mark.parametrize("baths", BATHS.values(), ids=BATHS.keys())
def test_first_law(baths):
    """What the energy gains is what was booked, but for the error of the integrator."""
    container, position, velocity = crystal(5)
    simulation = Simulation(scenario(container, position, velocity, time_step=0.002, forces=SMOOTH, **baths))
    before = energy(simulation)
    simulation.advance(until=8.0)
    gain, gross = books(simulation)
    assert gross > 10.0
    assert energy(simulation) - before == pytest.approx(gain, abs=1e-3 * gross + 1e-4 * len(position))


def test_first_law_between_thermal_walls():
    """One warm wall and one cold one: far more heat goes through the gas than stays in it."""
    position, velocity = scattered(6, 14.0, 14.0, 90, periodic=(False, False))
    walls = {"left": {"temperature": 3.0}, "right": {"temperature": 0.5}}
    simulation = Simulation(
        scenario(
            rectangle(15, 15, ["y"]), position + 0.5, velocity, time_step=0.002, forces=SMOOTH, walls=walls
        )
    )
    before = energy(simulation)
    simulation.advance(until=30.0)
    heat = simulation.dynamics.tallies.wall_heat.sum(axis=1)
    assert heat.max() > 50.0
    assert heat.min() < -20.0
    assert energy(simulation) - before == pytest.approx(heat.sum(), abs=2e-3 * np.abs(heat).sum())


@pytest.mark.parametrize("law", ["lennard-jones", "wca", "soft-sphere", "square-well", "yukawa"])
def test_energy_error_falls_as_the_square_of_the_step(law):
    container, position, velocity = crystal(7)
    wanted, errors = np.linspace(0.096, 3.84, 40), []
    for time_step in (0.004, 0.001):
        forces = {"law": law, **SMOOTH}
        if law == "square-well":  # its steep core wants shorter steps
            time_step, wanted = time_step / 4, np.linspace(0.096, 1.92, 20)
        simulation = Simulation(scenario(container, position, velocity, time_step=time_step, forces=forces))
        before, found = energy(simulation), []
        for time in wanted:
            simulation.advance(until=time)
            found.append(energy(simulation) - before)
        errors.append(np.sqrt(np.mean(np.square(found))))
    assert errors[0] < 2e-3 * len(position)
    assert errors[0] / errors[1] > 9.0
