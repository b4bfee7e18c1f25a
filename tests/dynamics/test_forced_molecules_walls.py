"""Rigid molecules under forces at walls: turned round at the contact, thermal walls, and the books."""

from __future__ import annotations

import math

import numpy as np
import pytest
from forced_gases import bits, rectangle
from forced_molecules import ATOM, DUMBBELL, SMOOTH, energy, gas
from gases import collect

from gasbox import Simulation
from gasbox.scenario import parse
from gasbox.state import Contacts

NONE = {"law": "none"}


def alone(position, velocity, angle, turning, molecule=DUMBBELL, **more):
    """One molecule between walls, without forces."""
    particle = {"position": position, "velocity": velocity, "angle": angle, "angular_velocity": turning}
    return Simulation(
        parse(
            {
                "container": rectangle(20, 20, []),
                "species": [ATOM],
                "molecules": [molecule],
                "particles": [{"species": "dumbbell", **particle}],
                "forces": NONE,
                "dynamics": {"kind": "forced", "time_step": 0.001},
                **more,
            }
        )
    )


def test_a_stick_that_meets_a_wall_with_one_end():
    """Standing at 45 degrees: I of two discs, the impulse at the lower one, by hand."""
    simulation = alone([10.0, 3.0], [0.5, -1.0], math.pi / 4, 0.0)
    simulation.advance(until=6.0)
    state = simulation.state
    inertia, lever = 2 * (0.09 + 0.125), 0.3 * math.cos(math.pi / 4)
    impulse = 2.0 / (1 / 2 + lever**2 / inertia)
    assert state.inertia[0] == pytest.approx(inertia, rel=1e-14)
    assert state.velocity[0] == pytest.approx([0.5, -1.0 + impulse / 2], rel=1e-12)
    # The arm of the lower end points to the lower left: a push upwards turns clockwise.
    assert state.angular_velocity[0] == pytest.approx(-impulse * lever / inertia, rel=1e-12)
    tallies = simulation.dynamics.tallies
    assert tallies.wall_impulse.sum() == pytest.approx(impulse, rel=1e-12)
    assert tallies.wall_collisions.sum() == 1
    # It was there when the lower rim touched, and no end of a step.
    touched = 3.0 - 0.5 - lever
    assert state.position[0, 1] == pytest.approx(
        0.5 + lever + (6.0 - touched) * (impulse / 2 - 1.0), abs=1e-9
    )


def test_energy_of_free_molecules_between_walls():
    """Hundreds of contacts, to rounding; also what turns round in corners."""
    simulation = Simulation(gas([40], periodic=[], forces=NONE, time_step=0.01))
    before = energy(simulation)
    simulation.advance(until=60.0)
    assert simulation.dynamics.tallies.wall_collisions.sum() > 150
    assert energy(simulation) == pytest.approx(before, rel=1e-12)
    assert deepest(simulation) < 1e-3


def deepest(simulation):
    """How far discs reach into walls."""
    sites, size = simulation.state.sites, simulation.geometry.size
    radius = sites.radius[:, None]
    return float(np.max(np.maximum(radius - sites.position, sites.position + radius - size)))


def test_angular_momentum_of_free_molecules_in_a_circle():
    circle = {"shape": "circle", "radius": 8.0}
    simulation = Simulation(gas([30], container=circle, forces=NONE, time_step=0.01))
    state = simulation.state

    def momentum():
        arm = state.position - 8.0
        flight = arm[:, 0] * state.velocity[:, 1] - arm[:, 1] * state.velocity[:, 0]
        return float(state.mass @ flight + state.inertia @ state.angular_velocity)

    before = momentum()
    simulation.advance(until=40.0)
    assert simulation.dynamics.tallies.wall_collisions.sum() > 100
    assert momentum() == pytest.approx(before, abs=1e-10)


def test_energy_in_gravity_between_walls():
    """Of each molecule: the error is of the second order, no contact adds one of the first."""
    gravity, errors = np.array([0.3, -0.5]), []
    for time_step in (0.008, 0.002):
        simulation = Simulation(
            gas([60], periodic=[], gravity=gravity.tolist(), forces=NONE, time_step=time_step)
        )
        state = simulation.state

        def whole(state=state):
            flight = state.mass * np.sum(state.velocity**2, axis=1)
            turning = state.inertia * state.angular_velocity**2
            return 0.5 * (flight + turning) - state.mass * (state.position @ gravity)

        before = whole()
        simulation.advance(until=10.0)
        errors.append(float(np.sqrt(np.mean((whole() - before) ** 2))))
        assert simulation.dynamics.tallies.wall_collisions.sum() > 80
    assert errors[0] < 1e-4
    assert 12.0 < errors[0] / errors[1] < 20.0


def test_energy_under_forces_between_walls():
    simulation = Simulation(
        gas([50], 12.0, 12.0, periodic=[], gravity=[0, -0.5], atoms=10, forces=SMOOTH, time_step=0.002)
    )
    state, found = simulation.state, []
    for time in np.linspace(0.1, 6.0, 60):
        simulation.advance(until=time)
        found.append(energy(simulation) + 0.5 * float(state.mass @ state.position[:, 1]))
    assert simulation.dynamics.tallies.wall_collisions.sum() > 50
    assert np.std(found) < 0.03


def test_thermal_walls_give_molecules_their_temperature():
    """Free molecules between two walls, from rest: flight and rotation come to it, and the heat is in the books."""
    walls = {"left": {"temperature": 2.0}, "right": {"temperature": 2.0}}
    simulation = Simulation(
        gas([80], 15.0, 15.0, periodic=["y"], forces=NONE, walls=walls, time_step=0.02, seed=5)
    )
    before = energy(simulation)
    simulation.advance(until=100.0)
    start = simulation.dynamics.tallies.copy()
    found = []
    for _ in range(30):
        earlier = simulation.dynamics.tallies.copy()
        simulation.advance(until=simulation.time + 40.0)
        change = simulation.dynamics.tallies - earlier
        found.append([change.kinetic_time[0] / 80, 2 * change.rotational_time[0] / 80])
    values = np.array(found) / 40.0
    error = values.std(axis=0, ddof=1) / math.sqrt(30)
    assert (error < 0.05).all()
    assert (np.abs(values.mean(axis=0) - 2.0) < 4 * error).all()
    heat = simulation.dynamics.tallies.wall_heat.sum()
    assert energy(simulation) - before == pytest.approx(heat, rel=1e-9)
    assert start.wall_collisions.sum() > 200


@pytest.mark.parametrize("threads", [1, 2])
def test_molecules_at_walls_to_the_bit(threads):
    """With a tiny buffer of contacts, in pieces, and together with discs that turn round, too."""
    scenario = gas(
        [50], 14.0, 14.0, periodic=["x"], atoms=20, walls={"bottom": {"temperature": 1.5}}, time_step=0.004
    )
    whole = Simulation(scenario, threads=1)
    whole.advance(until=3.0)
    simulation = Simulation(scenario, threads=threads)
    simulation.dynamics.contacts = Contacts.empty(2)
    rows = []
    for time in (0.7, 1.933, 3.0):
        rows += collect(simulation.dynamics, simulation.state, time)
    assert bits(simulation) == bits(whole)
    hits = whole.dynamics.tallies.wall_collisions
    assert len(rows) == hits.sum()
    assert hits[:, 0].sum() > 3
    assert hits[:, 2].sum() > 10
