"""The forced rule to the bit: whoever looks, stops and goes on, or helps."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import bits, lattice, rectangle, scattered, scenario
from gases import collect

from gasbox import Simulation, load
from gasbox.scenario import with_settings
from gasbox.state import Contacts

ATOM = {"name": "atom", "radius": 0.5, "count": 220, "temperature": 1.0}
SALT = [
    {"name": "atom", "radius": 0.5, "count": 80, "temperature": 1.0, "charge": 1.0},
    {"name": "anion", "radius": 0.35, "mass": 2.0, "count": 80, "temperature": 1.0, "charge": -1.0},
]
BOX, WALLED = rectangle(20, 18), rectangle(20, 18, [])
RESCALING = {"kind": "velocity-rescaling", "temperature": 1.0, "time": 0.5}
LANGEVIN = {"kind": "langevin", "temperature": 1.0, "time": 0.5}
UNTIL = 2.0

GASES = {
    "alone": {"container": BOX},
    "force-shifted": {"container": BOX, "forces": {"truncation": "force-shifted"}},
    "langevin": {"container": BOX, "thermostat": LANGEVIN},
    "rescaling": {"container": BOX, "thermostat": RESCALING},
    "barostat": {
        "container": BOX,
        "thermostat": RESCALING,
        "barostat": {"pressure": 3.0, "time": 5.0},
        "heating": {"power": 0.1},
    },
    "walled": {"container": WALLED, "gravity": [0, -0.1], "walls": {"left": {"temperature": 2.0}}},
    "circle": {"container": {"shape": "circle", "radius": 11}, "heating": {"power": 0.05}},
    "soft walls": {
        "container": rectangle(20, 18, ["x"]),
        "forces": {"walls": "repulsive"},
        "thermostat": LANGEVIN,
    },
    "salt": {"container": BOX, "species": SALT, "forces": {"charges": {"strength": 2.0}}},
}
every_gas = pytest.mark.parametrize("gas", GASES.values(), ids=GASES.keys())


def scene(gas):
    return scenario(**{"species": [ATOM], **gas})


@pytest.fixture(scope="module")
def whole():
    """What a run in one go by one thread ends in, for each gas; made once."""
    found: dict[int, tuple[str, int]] = {}

    def of(gas) -> tuple[str, int]:
        if id(gas) not in found:
            simulation = Simulation(scene(gas), threads=1)
            simulation.advance(until=UNTIL)
            hits = int(simulation.dynamics.tallies.wall_collisions.sum())
            found[id(gas)] = bits(simulation), hits
        return found[id(gas)]

    return of


@every_gas
def test_in_odd_pieces(gas, whole):
    simulation = Simulation(scene(gas))
    for time in np.sort(np.random.default_rng(1).uniform(0, UNTIL, 29)):
        simulation.advance(until=time)
    simulation.advance(until=UNTIL)
    assert bits(simulation) == whole(gas)[0]


@every_gas
@pytest.mark.parametrize("threads", [2, 3])
def test_by_several_threads(gas, threads, whole):
    simulation = Simulation(scene(gas), threads=threads)
    simulation.advance(until=UNTIL)
    assert bits(simulation) == whole(gas)[0]


@every_gas
@pytest.mark.parametrize("threads", [1, 2])
def test_with_a_tiny_buffer_of_contacts(gas, threads, whole):
    simulation = Simulation(scene(gas), threads=threads)
    simulation.dynamics.contacts = Contacts.empty(3)
    rows = collect(simulation.dynamics, simulation.state, UNTIL)
    assert (bits(simulation), len(rows)) == whole(gas)
    assert all(kind == 1 for kind, *_ in rows)
    times = [row[1] for row in rows]
    assert times == sorted(times)


@every_gas
def test_stopped_and_resumed(gas, whole, tmp_path):
    """From snapshots at odd moments, with other numbers of threads."""
    simulation = Simulation(scene(gas), threads=2)
    for k, time in enumerate((0.0, 0.503, 0.503, 1.277)):
        simulation.advance(until=time)
        simulation.save(tmp_path / "snapshot.json")
        simulation = Simulation(load(tmp_path / "snapshot.json"), threads=1 + k % 3)
        assert simulation.warnings == ()
    simulation.advance(until=UNTIL)
    assert bits(simulation) == whole(gas)[0]


def test_resumed_in_a_box_that_has_grown_much(tmp_path):
    """Strips follow the box as it is: who goes on divides it as who never stopped."""
    bath = {"thermostat": {**LANGEVIN, "temperature": 1.5}, "barostat": {"pressure": 0.1, "time": 1.0}}
    crystal = {"name": "atom", "radius": 0.5, "count": 400, "temperature": 1.5, "lattice": 1.0}
    simulation = Simulation(scenario(rectangle(20, 17.32), species=[crystal], time_step=0.002, **bath))
    simulation.advance(until=1.5)
    simulation.save(tmp_path / "snapshot.json")
    later = Simulation(load(tmp_path / "snapshot.json"))
    for one in (simulation, later):
        one.advance(until=2.0)
    assert simulation.state.wall_displacement[1] > 10.0
    assert bits(simulation) == bits(later)


def test_resumed_with_something_else_asked_for(tmp_path):
    """Another bath replaces what was remembered; another time step keeps the time."""
    simulation = Simulation(scene(GASES["rescaling"]))
    simulation.advance(until=1.0)
    simulation.save(tmp_path / "snapshot.json")
    snapshot = load(tmp_path / "snapshot.json")
    warmer = Simulation(with_settings(snapshot, {"thermostat.temperature": "3"}))
    warmer.advance(until=5.0)
    assert warmer.temperature() == pytest.approx(3.0, rel=0.35)
    finer = Simulation(with_settings(snapshot, {"dynamics.time_step": "0.001"}))
    assert finer.time == 1.0


def test_walls_are_met(whole):
    """Otherwise the buffer of contacts would be tested by nothing."""
    for name in ("walled", "circle"):
        assert whole(GASES[name])[1] > 20


@every_gas
def test_whenever_a_run_ends(gas):
    """Energy and virial of the present are known at every step, and looking at them costs no bit."""
    looked = Simulation(scene(gas))
    for step in (1, 7, 10, 33):
        looked.advance(until=0.005 * step)
        fresh = Simulation(scene(gas))
        fresh.advance(until=0.005 * step)
        assert bits(fresh) == bits(looked)


@pytest.mark.small
def test_small_ones_too(tmp_path):
    """In pieces and resumed, with thermostat and barostat; also without the JIT."""
    position, velocity = scattered(1, 5.0, 5.0, 9)
    baths = {"thermostat": RESCALING, "barostat": {"pressure": 1.0, "time": 1.0}, "heating": {"power": 0.1}}
    start = scenario(rectangle(5, 5), position, velocity, **baths)
    expected = Simulation(start)
    expected.advance(until=0.2)
    simulation = Simulation(start)
    for time in (0.031, 0.05, 0.1234):
        simulation.advance(until=time)
    simulation.save(tmp_path / "snapshot.json")
    simulation = Simulation.restore(tmp_path / "snapshot.json")
    simulation.advance(until=0.2)
    assert bits(simulation) == bits(expected)


def test_which_disc_has_which_number_changes_no_bit():
    """Sums are taken in the order of places."""
    container, position = lattice(12, 12, 1.15)
    rng = np.random.default_rng(4)
    position = position + rng.uniform(-0.1, 0.1, position.shape)
    velocity = rng.normal(size=position.shape)
    order = rng.permutation(len(position))
    found = []
    for rows in (np.arange(len(position)), order):
        simulation = Simulation(scenario(container, position[rows], velocity[rows]))
        simulation.advance(until=2.0)
        found.append((simulation.state.position, simulation.state.velocity, simulation.state.potential))
    assert np.array_equal(found[0][0][order], found[1][0])
    assert np.array_equal(found[0][1][order], found[1][1])
    assert found[0][2] == found[1][2]


def test_the_seed_is_that_of_the_noise():
    position, velocity = scattered(1, 18, 16, 50)
    start, ends = scenario(rectangle(18, 16), position, velocity, thermostat=LANGEVIN), set()
    for seed in (1, 1, 2, 2**40 + 1):
        simulation = Simulation(start.model_copy(update={"seed": seed}))
        simulation.advance(until=0.1)
        ends.add(bits(simulation))
    assert len(ends) == 3
