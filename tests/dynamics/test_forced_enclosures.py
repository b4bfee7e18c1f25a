"""Walls under forces: nobody gets out, energy is kept, and the pressure is that of the virial."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import rectangle, scenario

from gasbox import Simulation, UsageError, observe
from gasbox.dynamics import Forced
from gasbox.scenario import parse
from gasbox.state import Contacts, SetBarostat, SetGravity, SetWall, Tallies

ATOM = {"name": "atom", "radius": 0.5, "count": 120, "temperature": 1.0}
WALLED = rectangle(24, 24, [])
POST = {"shape": "disc", "center": [12, 12], "radius": 2.5}
CORNERS = [
    {"shape": "segment", "start": [0, 5], "end": [8, 5]},
    {"shape": "polygon", "vertices": [[16, 16], [20, 16], [20, 20], [16, 20]]},
]
PLACES = {
    "rectangle": {"container": WALLED},
    "circle": {"container": {"shape": "circle", "radius": 13}},
    "hexagon": {"container": {"shape": "regular-polygon", "sides": 6, "radius": 14}},
    "triangle": {"container": {"shape": "polygon", "vertices": [[0, 0], [34, 0], [10, 30]]}},
    "channel": {"container": rectangle(24, 24, ["x"])},
    "post": {"container": WALLED, "obstacles": [POST]},
    "channel with a post": {"container": rectangle(24, 24, ["y"]), "obstacles": [POST]},
    "gravity": {"container": WALLED, "gravity": [0.02, -0.1]},
}
ANGULAR = {
    "segment and square": {"container": WALLED, "obstacles": CORNERS},
    "angular channel": {"container": rectangle(24, 24, ["x"]), "obstacles": [POST, *CORNERS]},
}
every_place = pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
angular_place = pytest.mark.parametrize("place", ANGULAR.values(), ids=ANGULAR.keys())
every_wall = pytest.mark.parametrize("walls", ["reflecting", "repulsive"])


def make(place, walls="reflecting", species=(ATOM,), time_step=0.005, **more):
    forces = {"walls": walls, "truncation": "force-shifted"}
    return Simulation(scenario(**place, species=species, forces=forces, time_step=time_step, **more))


def energy(simulation):
    return observe.internal_energy(simulation.state, simulation.geometry)


def stays_inside(simulation, clear):
    """Twenty thousand steps; `clear` is how far from walls the centres stay, in radii."""
    before, state = energy(simulation), simulation.state
    for turn in range(40):
        simulation.advance(until=2.5 * (turn + 1))
        assert simulation.geometry.holds(state.position, clear * state.radius).all()
    # The integrator's error at the start is that of discs that stood too near to each other.
    assert energy(simulation) == pytest.approx(before, abs=4e-3 * state.count)


@every_place
@every_wall
def test_nobody_gets_out(place, walls):
    stays_inside(make(place, walls), 1.0 - 1e-9 if walls == "reflecting" else 0.4)


@angular_place
def test_nobody_gets_past_corners(place):
    stays_inside(make(place), 1.0 - 1e-9)


def error(place, walls, time_step):
    """Root mean square of what the energy is off by, at 50 moments of 500 long steps."""
    simulation = make(place, walls, time_step=time_step)
    before, found = energy(simulation), []
    for turn in range(50):
        simulation.advance(until=0.08 * (turn + 1))
        found.append(energy(simulation) - before)
    return np.sqrt(np.mean(np.square(found)))


@every_place
@every_wall
def test_energy_error_falls_as_the_square_of_the_step(place, walls):
    # Where two smooth sides are equally near, the direction of the push changes at once: an error of first order.
    kinks = walls == "repulsive" and place["container"]["shape"] == "regular-polygon"
    assert error(place, walls, 0.008) / error(place, walls, 0.002) > (2.0 if kinks else 8.0)


@angular_place
@every_wall
def test_energy_error_at_corners_falls_as_the_square_of_the_step(place, walls):
    assert error(place, walls, 0.008) / error(place, walls, 0.002) > 8.0


def test_smooth_walls_that_meet_at_blunt_angles():
    """Where one side ends and the next begins, the potential has no jump; the push changes its direction."""
    place = {"container": {"shape": "regular-polygon", "sides": 24, "radius": 9}}
    coarse, fine = error(place, "repulsive", 0.008), error(place, "repulsive", 0.002)
    assert coarse < 0.2
    assert fine < 0.5 * coarse


@every_wall
@pytest.mark.parametrize("name", ["rectangle", "circle", "hexagon", "channel"])
def test_pressure_on_the_walls_is_that_of_the_virial(name, walls):
    simulation = make(PLACES[name], walls)
    simulation.advance(until=10.0)
    before = simulation.dynamics.tallies.copy()
    simulation.advance(until=310.0)
    change = simulation.dynamics.tallies - before
    radii, counts = np.array([0.5]), np.array([120])
    on_walls = observe.wall_pressure(change, simulation.geometry, radii, 300.0)
    virial = observe.virial_pressure(
        change, simulation.geometry, radii, counts, temperature=simulation.temperature(), duration=300.0
    )
    # Soft walls stand where their push is about as large as T: not exactly one radius away from their lines.
    assert on_walls == pytest.approx(virial, rel=0.015 if walls == "reflecting" else 0.03)


@every_wall
def test_weight_on_the_floor(walls):
    """The impulses on floor and ceiling differ by the weight of the gas, times the time; to what it holds itself."""
    simulation = make({"container": WALLED, "gravity": [0.0, -0.2]}, walls)
    simulation.advance(until=200.0)
    state, impulse = simulation.state, simulation.dynamics.tallies.wall_impulse[:, 0]
    by_side = dict(zip(simulation.geometry.wall_names, impulse, strict=True))
    momentum = float(state.mass @ state.velocity[:, 1])
    start = Simulation(simulation.scenario).state
    gained = momentum - float(start.mass @ start.velocity[:, 1])
    weight = by_side["bottom"] - by_side["top"]
    assert weight == pytest.approx(120 * 0.2 * simulation.time + gained, rel=1e-3)


def test_thermal_walls_warm_the_gas():
    walls = {side: {"temperature": 2.5} for side in ("left", "right")}
    simulation, found = Simulation(scenario(WALLED, species=[ATOM], walls=walls)), []
    for turn in range(100):
        simulation.advance(until=100.0 + 5.0 * turn)
        found.append(simulation.temperature())
    # One part in sqrt(120) each, and some ten of them independent.
    assert np.mean(found) == pytest.approx(2.5, rel=4 / np.sqrt(120 * 10))


def test_large_discs_turn_round_at_their_own_distance():
    species = [
        {"name": "small", "radius": 0.3, "count": 60, "temperature": 1.0},
        {"name": "large", "radius": 1.5, "mass": 9.0, "count": 12, "temperature": 1.0},
    ]
    for walls, clear in (("reflecting", 1.0 - 1e-9), ("repulsive", 0.4)):
        simulation = make({"container": WALLED}, walls, species, time_step=0.003)
        for turn in range(20):
            simulation.advance(until=2.0 * (turn + 1))
            state = simulation.state
            assert simulation.geometry.holds(state.position, clear * state.radius).all()


@pytest.mark.small
@every_wall
def test_one_disc_to_and_fro(walls):
    """Between two walls: it comes back at its own speed, and books what it gives the walls."""
    forces = {"walls": walls}
    simulation = Simulation(
        scenario(rectangle(4.0, 4.0, []), [[2.0, 2.0]], [[8.0, 0.0]], forces=forces, time_step=0.01)
    )
    simulation.advance(until=0.4)
    assert simulation.state.velocity[0] == pytest.approx([-8.0, 0.0], abs=0.02)
    if walls == "reflecting":  # 3.2 in all, 1.5 of them to the wall
        assert simulation.state.position[0] == pytest.approx([1.8, 2.0], abs=1e-12)
    tallies = simulation.dynamics.tallies
    side = simulation.geometry.wall_names.index("right")
    assert tallies.wall_impulse[side, 0] == pytest.approx(16.0, rel=0.005)


@pytest.mark.small
def test_at_the_right_moment_of_a_step():
    """Under gravity too, a bounce inside a step ends where the parabola does."""
    gravity, time_step = 3.0, 0.01
    simulation = Simulation(
        scenario(
            rectangle(10, 10, []),
            [[5.0, 1.0]],
            gravity=[0, -gravity],
            time_step=time_step,
        )
    )
    fall, top = np.sqrt(2 * 0.5 / gravity), 0.5
    for time in (0.3, 0.5, 0.77, 1.0, 1.6):
        simulation.advance(until=time)
        phase = (time + fall) % (2 * fall) - fall
        height = 0.5 + top - 0.5 * gravity * phase**2
        assert simulation.state.position[0, 1] == pytest.approx(height, abs=3e-4)


def test_many_discs_at_walls_at_once():
    """Twice as many as there is room for at first stand near walls; room grows in the middle of a step."""
    count = 900
    y = np.repeat(np.arange(3), 300) * 1.0 + 3.0
    position = np.stack([np.tile(np.arange(300), 3) * 1.1 + 1.0, y], axis=1)
    velocity = np.zeros((count, 2))
    velocity[:, 1] = -2.0
    forces = {"law": "none"}
    obstacles = [
        {"shape": "segment", "start": [0.5 * k + 1, 1.6], "end": [0.5 * k + 1.4, 1.6]} for k in range(150)
    ]
    simulation = Simulation(
        scenario(rectangle(332, 9, []), position, velocity, forces=forces, obstacles=obstacles)
    )
    simulation.advance(until=6.0)
    assert simulation.geometry.holds(simulation.state.position, 0.5 - 1e-9).all()
    assert simulation.energy() == pytest.approx(0.5 * 4.0 * count, rel=1e-9)


def test_gravity_and_thermal_walls_change_in_a_run():
    simulation = make({"container": WALLED})
    simulation.advance(until=1.0)
    simulation.apply(SetGravity((0.0, -1.0)))
    simulation.apply(SetWall("bottom", temperature=0.2))
    simulation.advance(until=60.0)
    assert simulation.state.position[:, 1].mean() < 8.0
    assert simulation.geometry.holds(simulation.state.position, 0.5 - 1e-9).all()
    with pytest.raises(UsageError, match="periodic in both directions"):
        simulation.apply(SetBarostat(1.0))


def test_walls_that_forces_do_not_know():
    data = {
        "format": "gasbox-scenario/1",
        "container": WALLED,
        "species": [ATOM],
        "walls": {"left": {"motion": {"kind": "piston", "mass": 50}}},
        "dynamics": {"kind": "event-driven"},
    }
    other, settings = Simulation(parse(data)), make({"container": WALLED}).dynamics.settings
    with pytest.raises(UsageError, match="no wall moves freely"):
        Forced(other.state, other.geometry, settings, Tallies.zero(1, 4), Contacts.empty(0))
