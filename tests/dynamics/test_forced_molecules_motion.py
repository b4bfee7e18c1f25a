"""Laws of motion of molecules under forces: momentum, reversal, energy, and angular momentum."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import apart
from forced_molecules import CHAIN, SMOOTH, TRIMER, WATER, energy, gas, set_going

from gasbox import Simulation

CHARGES = {**SMOOTH, "charges": {"strength": 1.5, "screening_length": 0.8, "cutoff": 3.0}}
GASES = {
    "rigid": {"counts": [70], "atoms": 20},
    "water": {"counts": [50], "molecules": [WATER], "width": 11.0, "height": 11.0, "forces": CHARGES},
    "flexible": {"counts": [25, 8], "molecules": [TRIMER, CHAIN], "atoms": 10},
}


def started(name, **more):
    simulation = Simulation(gas(**{"forces": SMOOTH, **GASES[name], **more}))
    set_going(simulation)
    return simulation


@pytest.mark.parametrize("name", GASES)
def test_energy_error_of_molecules_falls_as_the_square_of_the_step(name):
    errors = []
    for time_step in (0.002, 0.001, 0.0005):
        simulation = started(name, time_step=time_step)
        before, found = energy(simulation), []
        for time in np.linspace(0.05, 2.0, 40):
            simulation.advance(until=time)
            found.append(energy(simulation) - before)
        errors.append(np.sqrt(np.mean(np.square(found))))
    exponents = np.log2(errors[0] / np.array(errors[1:])) / [1, 2]
    assert exponents == pytest.approx(2.0, abs=0.1)


def test_energy_of_molecules_does_not_drift():
    """Over 40 000 steps: of two halves of the run the means agree as far as they scatter."""
    simulation = started("rigid", time_step=0.002)
    found = []
    for time in np.linspace(0.2, 80.0, 400):
        simulation.advance(until=time)
        found.append(energy(simulation))
    blocks = np.reshape(found, (20, 20)).mean(axis=1)
    error = blocks.std(ddof=1) * np.sqrt(4 / 20)
    assert abs(blocks[10:].mean() - blocks[:10].mean()) < 4 * error
    assert error < 1e-5 * 90


@pytest.mark.parametrize("baths", [{}, {"thermostat": {"kind": "velocity-rescaling", "temperature": 1.2}}])
@pytest.mark.parametrize("name", GASES)
def test_momentum_of_molecules(name, baths):
    simulation = started(name, **baths)
    before = np.array(simulation.momentum())
    simulation.advance(until=10.0)
    sites = simulation.state.sites
    scale = np.abs(sites.mass[:, None] * sites.velocity).sum()
    assert np.abs(simulation.momentum() - before).max() < 1e-13 * scale
    assert np.abs(sites.mass @ sites.velocity - simulation.momentum()).max() < 1e-13 * scale


@pytest.mark.parametrize("name", GASES)
def test_reversal_of_molecules(name):
    simulation = started(name, time_step=0.001)
    state, start = simulation.state, simulation.state.copy()
    simulation.advance(until=0.6)
    assert apart(state.sites.position, start.sites.position, simulation.geometry) > 0.3
    for velocity in (state.velocity, state.angular_velocity, state.sites.velocity):
        velocity *= -1.0
    simulation.dynamics.resync(state)
    simulation.advance(until=1.2)
    assert apart(state.sites.position, start.sites.position, simulation.geometry) < 1e-9
    assert np.abs(state.angular_velocity + start.angular_velocity).max() < 1e-8
    assert np.abs(state.sites.velocity + start.sites.velocity).max() < 1e-8


def angular_momentum(state, centre):
    """Of all flight and all rotation about a point."""
    arm = state.position - centre
    turning = state.inertia * state.angular_velocity
    return float(
        state.mass @ (arm[:, 0] * state.velocity[:, 1] - arm[:, 1] * state.velocity[:, 0]) + turning.sum()
    )


@pytest.mark.parametrize("name", GASES)
def test_angular_momentum_in_a_circle(name):
    """A smooth wall pushes to the middle, and forces of pairs and bonds have no moment together."""
    more = {**GASES[name], "forces": {**GASES[name].get("forces", SMOOTH), "walls": "repulsive"}}
    simulation = Simulation(gas(**more, container={"shape": "circle", "radius": 9.0}))
    set_going(simulation)
    state = simulation.state
    before = angular_momentum(state, (9.0, 9.0))
    simulation.advance(until=5.0)
    scale = float(np.sum(state.mass * np.hypot(*state.velocity.T))) * 9.0
    assert simulation.dynamics.tallies.wall_impulse.sum() > 10.0
    assert angular_momentum(state, (9.0, 9.0)) == pytest.approx(before, abs=1e-12 * scale)


BATHS = {
    "rescaling": {"thermostat": {"kind": "velocity-rescaling", "temperature": 1.5, "time": 0.5}},
    "langevin": {"thermostat": {"kind": "langevin", "temperature": 2.5, "time": 0.5}},
    "heating": {"heating": {"power": 0.1}},
    "barostat": {"barostat": {"pressure": 2.0, "time": 5.0}},
}


@pytest.mark.parametrize("baths", BATHS.values(), ids=BATHS.keys())
@pytest.mark.parametrize("name", ["rigid", "flexible"])
def test_first_law_of_molecules(name, baths):
    """What the energy gains is what was booked, but for the error of the integrator."""
    simulation = started(name, time_step=0.001, **baths)
    before = energy(simulation)
    simulation.advance(until=5.0)
    tallies = simulation.dynamics.tallies
    flows = np.concatenate([tallies.thermostat_heat, tallies.heater_heat, tallies.barostat_work])
    assert np.abs(flows).sum() > 10.0
    gain = energy(simulation) - before
    assert gain == pytest.approx(flows.sum(), abs=1e-3 * np.abs(flows).sum() + 0.01)
