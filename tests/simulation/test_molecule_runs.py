"""Gases of molecules are saved, recorded and resumed to the bit, and change from one dynamics to another."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from molecule_runs import BENT, DYNAMICS, SPRING, molecular

from gasbox import Simulation
from gasbox.errors import ScenarioError
from gasbox.initial import worst_overlap
from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import Scenario, parse, with_settings

every_dynamics = pytest.mark.parametrize("kind", DYNAMICS)
RUNS: list[tuple[str, list[dict[str, Any]]]] = [
    *((kind, [BENT]) for kind in DYNAMICS),
    ("forced", [BENT, SPRING]),
]
every_run = pytest.mark.parametrize(("kind", "molecules"), RUNS, ids=[*DYNAMICS, "flexible"])


def bits(simulation: Simulation) -> dict[str, bytes]:
    """All that tells one state from another."""
    state = simulation.state
    assert state.sites is not None
    fields = {name: np.asarray(value) for name, value in vars(state).items() if name != "sites"}
    fields |= {f"sites.{name}": value for name, value in vars(state.sites).items()}
    fields |= {f"tallies.{name}": value for name, value in vars(simulation.dynamics.tallies).items()}
    return {name: value.tobytes() for name, value in fields.items()}


@every_run
def test_a_snapshot_goes_on_with_the_same_bits(kind: str, molecules: list[dict[str, Any]]) -> None:
    whole = Simulation(molecular(kind, *molecules))
    whole.advance(frames=3)
    again = Simulation(parse(whole.snapshot().to_json()))
    assert again.time == whole.time
    for simulation in (whole, again):
        simulation.advance(until=0.7)
    assert bits(again) == bits(whole)
    assert whole.dynamics.tallies.pair_collisions.sum() > 0 or kind == "forced"


@every_run
def test_every_frame_of_a_recording_goes_on(
    kind: str, molecules: list[dict[str, Any]], tmp_path: Path
) -> None:
    whole = Simulation(molecular(kind, *molecules))
    measurements = Measurements(whole.scenario)
    with Recorder(tmp_path / "a.h5", whole.scenario_in_use) as recorder:
        for _ in range(4):
            frame = whole.frame_view()
            recorder.write(frame, measurements.of(frame))
            whole.advance(frames=1)
    with open_recording(tmp_path / "a.h5") as recording:
        numbers = recording.observables()
        resumed = [Simulation(recording.scenario_at(index)) for index in range(4)]
    for again in resumed:
        again.advance(until=whole.time)
        assert bits(again) == bits(whole)
    assert numbers["temperature_rotational"][0] == pytest.approx(1, rel=0.5)
    assert np.isnan(numbers["temperature_vibrational"]).all() == (len(molecules) == 1)
    assert numbers["species_temperature_rotational"].shape == (4, 1 + len(molecules))


@every_run
def test_a_summary_has_the_temperatures_of_all_motions(kind: str, molecules: list[dict[str, Any]]) -> None:
    simulation = Simulation(molecular(kind, *molecules))
    simulation.advance(frames=1)
    found = simulation.summary()
    assert [entry["name"] for entry in found["species"]] == ["disc", *(one["name"] for one in molecules)]
    disc, bent, *rest = found["species"]
    assert (disc["temperature_rotational"], bent["temperature_vibrational"]) == (None, None)
    assert bent["temperature_rotational"] > 0
    assert all(entry["temperature_vibrational"] > 0 for entry in rest)
    # Two of flight for each, less two of the whole; one of rotation; three of vibration of three atoms.
    flight = 2 * simulation.state.count - 2
    turning, swinging = 20 + 6 * len(rest), 18 * len(rest)
    parts = flight * found["temperature_translational"] + turning * found["temperature_rotational"]
    parts += swinging * (found["temperature_vibrational"] or 0.0)
    assert found["temperature"] == pytest.approx(parts / (flight + turning + swinging), rel=1e-10)


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
