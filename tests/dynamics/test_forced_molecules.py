"""Molecules under forces against their slow twin: forces, torques, energy, virial, and the first steps."""

from __future__ import annotations

import numpy as np
import pytest
from forced_molecules import CHAIN, DUMBBELL, TRIMER, WATER, gas, set_going
from molecule_twin import MoleculeTwin, rotated

from gasbox import Simulation

CHARGES = {"charges": {"strength": 1.5, "screening_length": 0.8, "cutoff": 3.0}}
GASES = {
    "dumbbells": gas([60], atoms=20),
    "small box": gas([3], width=3.3, height=3.4, atoms=1, forces={"cutoff": 4.0}),
    "narrow": gas([6], width=3.3, height=40.0),
    "water": gas([40], molecules=[WATER], width=11.0, height=11.0, forces=CHARGES),
    "trimers": gas([25], molecules=[TRIMER], atoms=30),
    "trimers in a small box": gas([2], molecules=[TRIMER], width=6.3, height=6.2, forces={"cutoff": 6.0}),
    "chains": gas([8, 10], molecules=[CHAIN, DUMBBELL], forces={"truncation": "force-shifted"}),
}
every_gas = pytest.mark.parametrize("name", GASES)


def started(name, until=0.0, **more):
    simulation = Simulation(GASES[name], **more)
    set_going(simulation)
    if until:
        simulation.advance(until=until)
    return simulation, MoleculeTwin(GASES[name], simulation.state)


@every_gas
@pytest.mark.parametrize("until", [0.0, 0.2])
def test_forces_torques_energy_and_virial(name, until):
    simulation, twin = started(name, until)
    state = simulation.state
    forces, potential, virial = twin.push(state.sites.position)
    expected = twin.torques(state.sites.position, forces)
    found = simulation.dynamics.forces_and_torques(state)
    for one, other in zip(found, expected, strict=True):
        assert np.abs(one - other).max() < 1e-10 * max(np.abs(other).max(), 1.0)
    assert state.potential == pytest.approx(potential, rel=1e-12, abs=1e-11)
    assert state.virial == pytest.approx(virial, rel=1e-11, abs=1e-10)


@every_gas
def test_discs_belong_to_their_molecules(name):
    simulation, twin = started(name, 0.1)
    state = simulation.state
    centre = twin.centres(state.sites.position)
    assert np.abs(centre - state.position).max() < 1e-12 * 40
    assert ((state.position >= 0) & (state.position < simulation.geometry.size)).all()
    for row in np.flatnonzero((np.diff(state.sites.first) > 1) & ~state.sites.flexible):
        mine = slice(state.sites.first[row], state.sites.first[row + 1])
        place = state.position[row] + rotated(state.sites.place[mine], state.angle[row])
        assert np.abs(state.sites.position[mine] - place).max() < 1e-12 * 40


@pytest.mark.parametrize("threads", [1, 3])
@every_gas
def test_the_first_steps(name, threads):
    """Half a kick, a drift, half a kick: of discs, and of centres and angles."""
    simulation, twin = started(name, threads=threads)
    start = simulation.state.copy()
    simulation.advance(until=0.02)
    position, velocity = steps(twin, start, 0.002, 10)
    size, periodic = simulation.geometry.size, simulation.geometry.periodic
    gap = simulation.state.sites.position - position
    gap -= np.where(periodic, np.rint(gap / size) * size, 0.0)
    assert np.abs(gap).max() < 1e-9
    assert np.abs(simulation.state.sites.velocity - velocity).max() < 1e-8


def steps(twin, state, time_step, count):
    """Places and velocities of all discs after some steps of velocity Verlet."""
    sites, owner = state.sites, state.sites.owner
    rigid = ~sites.flexible[owner]
    ease = np.where(state.inertia > 0, 1 / np.where(state.inertia > 0, state.inertia, 1), 0.0)
    centre, speed = state.position.copy(), state.velocity.copy()
    angle, turning = state.angle.copy(), state.angular_velocity.copy()
    position, velocity = sites.position.copy(), sites.velocity.copy()

    def put():
        for row in range(state.count):
            mine = slice(sites.first[row], sites.first[row + 1])
            if not sites.flexible[row]:
                arm = rotated(sites.place[mine], angle[row])
                position[mine] = centre[row] + arm
                velocity[mine] = speed[row] + turning[row] * np.stack([-arm[:, 1], arm[:, 0]], axis=1)

    def kick(forces):
        force, torque = twin.torques(position, forces)
        speed[:] += 0.5 * time_step * force / state.mass[:, None]
        turning[:] += 0.5 * time_step * torque * ease
        velocity[~rigid] += (0.5 * time_step * forces / sites.mass[:, None])[~rigid]

    put()
    forces = twin.push(position)[0]
    for _ in range(count):
        kick(forces)
        centre += time_step * speed
        angle += time_step * turning
        position[~rigid] += time_step * velocity[~rigid]
        put()
        forces = twin.push(position)[0]
        kick(forces)
    put()
    return position, velocity
