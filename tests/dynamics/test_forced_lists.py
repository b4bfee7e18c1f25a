"""Lists of neighbours: wherever discs stand and however they move, the forces are those of the slow twin."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import energy, lattice, rectangle, scattered, scenario
from forced_twin import Twin

from gasbox import Simulation
from gasbox.dynamics import forced_room


def check(simulation, tolerance=1e-11):
    """Forces, energy and virial are those of the twin, at the present places."""
    state = simulation.state
    size = simulation.geometry.at(state.wall_displacement).size if state.wall_displacement.size else None
    forces, potential, virial = Twin(simulation.scenario, state, size).push(state.position)
    scale = max(1.0, np.abs(forces).max(initial=0.0))
    assert np.abs(simulation.dynamics.forces(state) - forces).max(initial=0.0) <= tolerance * scale
    assert state.potential == pytest.approx(potential, rel=tolerance, abs=tolerance * scale)
    assert state.virial == pytest.approx(virial, rel=tolerance, abs=tolerance * scale * (state.count + 1))


def in_a_corner():
    """A heap over the corner where the periodic borders meet."""
    position, velocity = scattered(1, 11.0, 10.0, 60, periodic=(False, False))
    return rectangle(60, 50), (position - 5.0) % [60, 50], velocity


def in_a_line(along):
    position = np.full((70, 2), 3.0)
    position[:, along] = 1.0 * np.arange(70) + 0.4
    size = [6.0, 6.0]
    size[along] = 71.0
    velocity = 0.2 * np.random.default_rng(1).normal(size=(70, 2))
    return rectangle(*size), position, velocity


def dilute():
    return rectangle(100, 90), *scattered(2, 100, 90, 50, speed=3.0)


def dense():
    container, position = lattice(14, 14, 1.0)
    rng = np.random.default_rng(3)
    position = position + rng.uniform(-0.04, 0.04, position.shape)
    return container, position, 2.0 * rng.normal(size=position.shape)


def in_a_narrow_box():
    return rectangle(1.4, 30), *scattered(4, 1.4, 30, 14, gap=0.92)


def in_a_tiny_box():
    return rectangle(1.3, 1.2), *scattered(5, 1.3, 1.2, 1)


def in_a_channel():
    """Periodic along x alone; the walls are far enough not to be met."""
    position, velocity = scattered(6, 12.0, 5.0, 26, periodic=(True, False))
    return rectangle(12, 30, ["x"]), position + np.array([0.0, 12.0]), velocity


PLACES = {
    "corner": in_a_corner,
    "row": lambda: in_a_line(0),
    "column": lambda: in_a_line(1),
    "dilute": dilute,
    "dense": dense,
    "narrow": in_a_narrow_box,
    "tiny": in_a_tiny_box,
    "channel": in_a_channel,
}


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_wherever_discs_stand(place, threads):
    simulation = Simulation(scenario(*place(), time_step=0.002), threads=threads)
    check(simulation)
    for time in (0.5, 1.5):
        simulation.advance(until=time)
        check(simulation)


@pytest.mark.small
@pytest.mark.parametrize("count", [0, 1, 2])
@pytest.mark.parametrize("width", [1.5, 40.0])
def test_hardly_any_discs(count, width):
    position = np.array([[0.2, 0.1], [1.3, 0.9 * width]])[:count]
    velocity = np.array([[-2.0, -3.0], [1.0, 0.5]])[:count]
    simulation = Simulation(scenario(rectangle(width, width), position, velocity))
    check(simulation)
    simulation.advance(until=0.2)
    check(simulation)
    assert simulation.time == pytest.approx(0.2)


@pytest.mark.small
def test_across_a_corner_of_the_box():
    """Two that see each other only through both borders at once, and go through them."""
    position, velocity = [[0.3, 0.2], [11.4, 9.6]], [[-3.0, -2.0], [-3.0, -2.0]]
    simulation = Simulation(scenario(rectangle(12, 10), position, velocity))
    assert simulation.state.potential < -0.5
    for time in (0.1, 0.2, 0.3):
        simulation.advance(until=time)
        check(simulation)
    assert (simulation.state.position > 5.0).all()


@pytest.mark.small
@pytest.mark.parametrize("way", [(1.0, 0.0), (0.0, 1.0), (0.6, 0.8)])
def test_two_that_fly_at_each_other(way):
    """Just too far to be listed at first, they are within reach before either has gone farther than the skin."""
    way = np.array(way)
    position = [10.0 - 1.46 * way, 10.0 + 1.46 * way]
    simulation = Simulation(scenario(rectangle(20, 20), position, [8.0 * way, -8.0 * way]))
    seen = 0
    for step in range(1, 21):
        simulation.advance(until=0.005 * step)
        check(simulation)
        seen += simulation.state.potential != 0.0
    assert seen > 12


def test_a_thousand_steps_keep_the_energy_of_the_twin():
    container, position, velocity = dense()
    smooth = {"truncation": "force-shifted"}
    simulation = Simulation(scenario(container, position, 0.5 * velocity, time_step=0.001, forces=smooth))
    start = energy(simulation)
    for step in range(100, 1001, 100):
        simulation.advance(until=0.001 * step)
        twin = Twin(simulation.scenario, simulation.state)
        found = simulation.energy() + twin.push(simulation.state.position)[1]
        assert found == pytest.approx(start, abs=1e-4 * simulation.state.count)
        assert found == pytest.approx(energy(simulation), rel=1e-11)


class Grown:
    """Counts how often room grows."""

    def __init__(self, monkeypatch) -> None:
        self.times = 0
        grow = forced_room.Tables.grow

        def counted(tables):
            self.times += 1
            grow(tables)

        monkeypatch.setattr(forced_room.Tables, "grow", counted)


def imploding(**more):
    """Discs of a dilute gas that all fly to one point."""
    position, _ = scattered(7, 90, 90, 800, gap=1.5, periodic=(False, False))
    return scenario(rectangle(90, 90), position, 0.12 * (45.0 - position), time_step=0.002, **more)


def test_a_droplet_that_draws_together(monkeypatch):
    """Room for a dilute gas is too little for a droplet; it grows in the middle of a step, and changes nothing."""
    grown, found = Grown(monkeypatch), []
    for fewest, slots, threads in ((0.1, 0.5, 1), (0.1, 0.1, 3), (400.0, 8.0, 1)):
        monkeypatch.setattr(forced_room, "_FEWEST", fewest)
        monkeypatch.setattr(forced_room, "_EXPECTED", slots)
        baths = {
            "thermostat": {"kind": "langevin", "temperature": 1.0, "time": 20.0},
            "heating": {"power": 0.01},
        }
        simulation = Simulation(imploding(**baths), threads=threads)
        begun = grown.times
        simulation.advance(until=7.0)
        found.append((simulation.state.position.tobytes(), simulation.state.potential))
        grew = grown.times - begun
        assert (grew > 0) == (threads == 1 and fewest < 1.0)
    check(simulation, 1e-10)
    assert len(set(found)) == 1
    assert grown.times > 1


@pytest.mark.parametrize("threads", [1, 3])
def test_a_barostat_that_squeezes_the_box_to_half(threads):
    position, velocity = scattered(8, 24, 20, 150, gap=1.0)
    baths = {
        "thermostat": {"kind": "velocity-rescaling", "temperature": 1.0, "time": 0.2},
        "barostat": {"pressure": 6.0, "time": 20.0},
    }
    simulation = Simulation(scenario(rectangle(24, 20), position, velocity, **baths), threads=threads)
    for time in (2.0, 10.0, 40.0):
        simulation.advance(until=time)
        check(simulation)
    box = simulation.geometry.at(simulation.state.wall_displacement)
    assert box.width * box.height < 0.5 * 24 * 20
    assert box.width / box.height == pytest.approx(24 / 20, rel=1e-12)


def test_a_box_that_grows_far_beyond_its_start():
    """Strips are laid anew when the box is no longer what they were made for."""
    container, position = lattice(10, 10, 1.12)
    baths = {
        "thermostat": {"kind": "velocity-rescaling", "temperature": 2.0, "time": 0.2},
        "barostat": {"pressure": 0.02, "time": 2.0},
    }
    velocity = np.random.default_rng(9).normal(size=position.shape)
    velocity -= velocity.mean(axis=0)
    simulation = Simulation(scenario(container, position, velocity, **baths), threads=2)
    for time in (2.0, 30.0):
        simulation.advance(until=time)
        check(simulation)
    assert simulation.geometry.at(simulation.state.wall_displacement).width > 3 * simulation.geometry.width
