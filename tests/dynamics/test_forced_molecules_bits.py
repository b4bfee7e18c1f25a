"""Molecules under forces to the bit: in pieces, resumed, by several threads; and discs that are called molecules."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import bits, rectangle, scenario
from forced_molecules import CHAIN, DUMBBELL, TRIMER, gas
from gases import collect

from gasbox import Simulation, load
from gasbox.scenario import parse
from gasbox.state import Contacts

LANGEVIN = {"kind": "langevin", "temperature": 1.0, "time": 0.5}
RESCALING = {"kind": "velocity-rescaling", "temperature": 1.0, "time": 0.5}
UNTIL = 2.0
MANY = {"width": 26.0, "height": 24.0, "atoms": 40, "time_step": 0.004}
GASES = {
    "rigid": gas([130], **MANY, thermostat=LANGEVIN),
    "both": gas(
        [60, 30],
        molecules=[DUMBBELL, TRIMER],
        **MANY,
        thermostat=RESCALING,
        barostat={"pressure": 2.0, "time": 3.0},
        heating={"power": 0.1},
    ),
    "walled": gas(
        [60, 15],
        molecules=[DUMBBELL, CHAIN],
        **MANY,
        periodic=["x"],
        gravity=[0, -0.1],
        forces={"walls": "repulsive"},
        thermostat=LANGEVIN,
    ),
    "thermal walls": gas(
        [30],
        18.0,
        16.0,
        [CHAIN],
        [],
        time_step=0.004,
        forces={"law": "wca"},
        walls={"left": {"temperature": 2.0}},
    ),
}
every_gas = pytest.mark.parametrize("name", GASES)


@pytest.fixture(scope="module")
def whole():
    """What a run in one go by one thread ends in, for each gas; made once."""
    found: dict[str, str] = {}

    def of(name) -> str:
        if name not in found:
            simulation = Simulation(GASES[name], threads=1)
            simulation.advance(until=UNTIL)
            found[name] = bits(simulation)
        return found[name]

    return of


@every_gas
def test_molecules_in_odd_pieces_by_three_threads_with_a_tiny_buffer(name, whole):
    simulation = Simulation(GASES[name], threads=3)
    simulation.dynamics.contacts = Contacts.empty(3)
    for time in (0.1, 0.333, 1.35, UNTIL):
        collect(simulation.dynamics, simulation.state, time)
    assert bits(simulation) == whole(name)


@every_gas
def test_molecules_stopped_and_resumed(name, whole, tmp_path):
    simulation = Simulation(GASES[name], threads=2)
    for threads, time in ((1, 0.0), (2, 0.153), (1, 0.153), (1, 1.477)):
        simulation.advance(until=time)
        simulation.save(tmp_path / "snapshot.json")
        simulation = Simulation(load(tmp_path / "snapshot.json"), threads=threads)
        assert simulation.warnings == ()
    simulation.advance(until=UNTIL)
    assert bits(simulation) == whole(name)


def test_chains_meet_walls(whole):
    """Otherwise the buffer of contacts would be tested by nothing."""
    simulation = Simulation(GASES["thermal walls"])
    simulation.advance(until=UNTIL)
    tallies = simulation.dynamics.tallies
    assert tallies.wall_collisions[:, 2].sum() > 10
    assert tallies.wall_collisions[:, :2].sum() == 0


@pytest.mark.parametrize("more", [{}, {"thermostat": LANGEVIN}, {"thermostat": RESCALING}])
@pytest.mark.parametrize("periodic", [("x", "y"), ("x",)])
def test_molecules_of_one_disc_are_discs(more, periodic):
    box = rectangle(17, 16, periodic)
    rng = np.random.default_rng(2)
    position = np.stack(np.meshgrid(np.arange(12), np.arange(12)), axis=-1).reshape(-1, 2) * 1.3 + 0.6
    velocity = rng.normal(size=position.shape)
    discs = scenario(box, position, velocity, **more)
    one = {"name": "one", "atoms": [{"species": "atom", "position": [3.0, 1.0]}]}
    particles = {
        "species": ["one"] * len(position),
        "position": position.tolist(),
        "velocity": velocity.tolist(),
    }
    called = parse(
        {
            "format": "gasbox-scenario/1",
            "seed": 3,
            "container": box,
            "species": [{"name": "atom", "radius": 0.5}],
            "molecules": [one],
            "particles": particles,
            "dynamics": {"kind": "forced", "time_step": 0.005},
            **more,
        }
    )
    found = []
    for start in (discs, called):
        simulation = Simulation(start)
        simulation.advance(until=1.0)
        state, tallies = simulation.state, simulation.dynamics.tallies
        found.append((state.position, state.velocity, state.potential, state.virial, tallies))
    for one, other in zip(found[0][:4], found[1][:4], strict=True):
        assert np.array_equal(one, other)
    assert found[0][4].kinetic_time == found[1][4].kinetic_time
    assert np.array_equal(found[0][4].wall_impulse[:, 0], found[1][4].wall_impulse[:, 1])
