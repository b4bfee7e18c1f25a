"""Gases of molecules change from one dynamics to another, or are refused with the reason."""

from __future__ import annotations

import pytest
from molecule_runs import BENT, DYNAMICS, SPRING, molecular

from gasbox import Simulation
from gasbox.errors import ScenarioError
from gasbox.initial import worst_overlap
from gasbox.scenario import Scenario, parse, with_settings

every_dynamics = pytest.mark.parametrize("kind", DYNAMICS)


def overlapping(kind: str) -> Scenario:
    """A snapshot in which two molecules stand in one another."""
    simulation = Simulation(molecular(kind))
    simulation.advance(frames=1)
    found = simulation.snapshot()
    assert found.particles is not None
    position = found.particles.position.copy()
    position[11] = position[10] + [0.3, 0.2]
    data = found.to_dict()
    for row, place in zip(data["particles"], position.tolist(), strict=True):
        row["position"] = place
    return parse(data)


@pytest.mark.parametrize("kind", ["stepped", "forced"])
def test_overlaps_are_undone_for_exact_flight(kind: str) -> None:
    other = with_settings(overlapping(kind), {"dynamics": '{"kind": "event-driven"}'})
    simulation = Simulation(other)
    assert any(
        sentence.startswith("molecules that overlapped were moved apart") for sentence in simulation.warnings
    )
    assert worst_overlap(simulation.state, simulation.geometry) is None
    simulation.advance(frames=1)


def test_a_start_with_overlaps_is_refused_for_exact_flight() -> None:
    listed = [{"species": "bent", "position": [5, 5 + 0.1 * k]} for k in range(2)]
    with pytest.raises(ScenarioError, match="particle 0 and particle 1 overlap by"):
        Simulation(molecular("event-driven", {**BENT, "count": 0}, particles=listed))


@pytest.mark.parametrize("kind", ["stepped", "event-driven"])
def test_springs_are_refused_where_bodies_are_hard(kind: str) -> None:
    simulation = Simulation(molecular("forced", BENT, SPRING))
    simulation.advance(frames=1)
    with pytest.raises(ScenarioError, match='elastic bonds need dynamics kind "forced"'):
        with_settings(simulation.snapshot(), {"dynamics.kind": kind})


@every_dynamics
def test_any_dynamics_goes_on_from_any_other(kind: str) -> None:
    first = Simulation(molecular(kind))
    first.advance(frames=1)
    for other in DYNAMICS.keys() - {kind}:
        settings = {"dynamics": str(DYNAMICS[other]).replace("'", '"'), "frame_interval": "0.1"}
        again = Simulation(with_settings(first.snapshot(), settings))
        assert again.time == first.time
        assert again.state.angle == pytest.approx(first.state.angle, abs=0.2)
        again.advance(frames=1)
        assert again.summary()["temperature_rotational"] > 0
