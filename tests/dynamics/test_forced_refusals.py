"""What the forced rule refuses, warns of, or mends before the start."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import energy, rectangle, scattered, scenario

from gasbox import DynamicsError, ScenarioError, Simulation
from gasbox.scenario import parse

ATOM = {"name": "atom", "radius": 0.5, "count": 80, "temperature": 1.0}
MOVED = "discs that overlapped were moved apart before the start"


@pytest.mark.parametrize(("temperature", "time_step"), [(1.0, 0.05), (4.0, 0.03), (1e6, 0.005)])
@pytest.mark.parametrize("threads", [1, 3])
def test_a_step_that_is_too_long(temperature, time_step, threads):
    """It is said beforehand; then the run stops in a sentence, and what is seen is a gas of numbers."""
    atom = {**ATOM, "temperature": temperature}
    simulation = Simulation(scenario(rectangle(12, 12), species=[atom], time_step=time_step), threads=threads)
    (warning,) = simulation.warnings
    assert warning.startswith(f"dynamics.time_step {time_step:g} is long for these forces and speeds")
    safe = float(warning.split("up to ")[1].split()[0])
    assert safe < time_step
    for _ in range(2):
        with pytest.raises(DynamicsError, match=r"flew further than 0\.25 in one step .* shorten dynamics"):
            simulation.advance(until=50.0)
        state = simulation.state
        assert np.isfinite(state.position).all()
        assert np.isfinite(state.velocity).all()
        assert np.isfinite([state.potential, state.virial]).all()
        assert simulation.geometry.holds(state.position, 0.0).all()


@pytest.mark.small
def test_no_warning_without_need():
    position, velocity = scattered(1, 8.0, 8.0, 12, gap=1.0)
    assert Simulation(scenario(rectangle(8, 8), position, velocity)).warnings == ()
    free = scenario(rectangle(8, 8), position, velocity, forces={"law": "none"}, time_step=0.005)
    assert Simulation(free).warnings == ()
    stiff = scenario(
        rectangle(8, 8), position, velocity, species=[{"name": "atom", "radius": 0.5, "epsilon": 100.0}]
    )
    assert "up to 0.0019 is safe" in Simulation(stiff).warnings[0]
    cold = scenario(rectangle(8, 8), position, time_step=0.018)
    assert Simulation(cold).warnings == ()
    fast = scenario(rectangle(8, 8), position, 20.0 * velocity)
    assert "is long for these forces and speeds" in Simulation(fast).warnings[0]


def heaps():
    rng = np.random.default_rng(1)
    spot = rng.uniform(-0.5, 0.5, (200, 2))
    yield "two at one place", rectangle(10, 10), [[5.0, 5.0]] * 2, {}
    yield "five at one place", rectangle(10, 10), [[9.99, 0.0]] * 5, {}
    yield "two at a border", rectangle(10, 10), [[0.0, 0.0], [10 - 1e-13, 0.0]], {}
    yield "many in a spot", rectangle(40, 40), 20.0 + spot, {}
    yield "many at a point", rectangle(40, 40), np.full((200, 2), 20.0), {}
    yield "many in a corner", rectangle(40, 40, []), 1.1 + spot, {}
    yield "many in a circle", {"shape": "circle", "radius": 12}, 12.0 + spot, {}
    yield "steep cores", rectangle(40, 40), 20.0 + spot, {"law": "square-well"}
    yield "screened", rectangle(40, 40), 20.0 + spot, {"law": "yukawa"}


@pytest.mark.parametrize(
    ("container", "position", "forces"), [pytest.param(*h[1:], id=h[0]) for h in heaps()]
)
def test_heaps_are_moved_apart_and_that_is_said(container, position, forces):
    scene = scenario(container, position, forces=forces, time_step=0.002)
    simulation = Simulation(scene)
    assert simulation.warnings[0].startswith(MOVED)
    state = simulation.state
    assert np.hypot(*simulation.dynamics.forces(state).T).max() <= 500.0
    assert simulation.geometry.holds(state.position, state.radius).all()
    assert not state.velocity.any()
    again = Simulation(scene)
    assert np.array_equal(again.state.position, state.position)
    before = energy(simulation)
    simulation.advance(until=0.5)
    assert energy(simulation) == pytest.approx(before, abs=0.02 * state.count)


def test_heaps_of_tiny_discs_stay_together():
    """Ways are as long as discs are large, whatever the unit of length."""
    tiny = {"name": "atom", "radius": 0.5e-3}
    position = np.full((5, 2), 10e-3)
    simulation = Simulation(
        scenario(
            rectangle(20e-3, 20e-3), position, species=[tiny], time_step=1e-6, forces={"law": "square-well"}
        )
    )
    assert simulation.warnings[0].startswith(MOVED)
    assert np.abs(simulation.state.position - 10e-3).max() < 2e-3


def test_charges_alone_are_no_overlap():
    """Without other forces discs may stand as near as they like, and stay there."""
    charged = {"name": "atom", "radius": 0.5, "charge": 1.0, "epsilon": 0.0}
    position, _ = scattered(1, 10.0, 10.0, 40, gap=0.4)
    simulation = Simulation(
        scenario(rectangle(10, 10), position, species=[charged], forces={"charges": {"strength": 2.0}})
    )
    assert simulation.warnings == ()
    assert np.array_equal(simulation.state.position, position)


@pytest.mark.small
def test_a_start_that_is_near_is_left_alone():
    position = [[2.0, 2.0], [2.86, 2.0], [5.0, 5.0]]
    simulation = Simulation(scenario(rectangle(8, 8), position))
    assert simulation.warnings == ()
    assert simulation.state.position.tolist() == position


def test_velocities_stay_as_they_were_where_discs_are_moved():
    position, velocity = [[2.0, 2.0], [2.1, 2.0], [5.0, 5.0]], [[0.1, 0.2], [0.3, -0.4], [0.5, 0.6]]
    simulation = Simulation(scenario(rectangle(8, 8), position, velocity))
    assert simulation.warnings[0].startswith(MOVED)
    assert simulation.state.velocity.tolist() == velocity
    assert simulation.state.position[2].tolist() == [5.0, 5.0]


def test_a_place_that_is_no_number_stops_the_run():
    simulation = Simulation(scenario(rectangle(12, 12), species=[{**ATOM, "count": 60, "temperature": 1.0}]))
    simulation.state.velocity[3] = np.nan
    simulation.dynamics.resync(simulation.state)
    with pytest.raises(DynamicsError):
        simulation.advance(until=1.0)


def test_weight_is_no_overlap():
    heavy = {"name": "heavy", "radius": 0.5, "mass": 100.0, "count": 40, "temperature": 1.0}
    simulation = Simulation(
        scenario(rectangle(20, 20, []), species=[heavy], gravity=[0, -10], time_step=0.002)
    )
    assert not any("moved apart" in sentence for sentence in simulation.warnings)


def test_a_box_that_has_grown_is_not_forgotten():
    simulation = Simulation(
        scenario(
            rectangle(8, 8),
            species=[{**ATOM, "count": 30, "temperature": 3.0}],
            thermostat={"kind": "langevin", "temperature": 3.0},
            barostat={"pressure": 0.01, "time": 2.0},
        )
    )
    simulation.advance(until=1.0)
    data = simulation.snapshot().to_dict()
    for key in ("barostat", "thermostat"):
        del data[key]
    with pytest.raises(ScenarioError, match="barostat has made it"):
        Simulation(parse({**data, "dynamics": {"kind": "event-driven"}}))
