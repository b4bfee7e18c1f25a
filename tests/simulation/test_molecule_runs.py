"""Gases of molecules are saved, recorded and resumed to the bit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from molecule_runs import BENT, DYNAMICS, SPRING, molecular

from gasbox import Simulation
from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import parse

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
