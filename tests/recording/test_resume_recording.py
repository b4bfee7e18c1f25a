from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_up import same_bits

from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import Scenario, parse
from gasbox.simulation import Simulation, run

FRAMES = 12


def gas(kind: str, periodic: list[str]) -> Scenario:
    return parse(
        {
            "seed": 5,
            "container": {"shape": "rectangle", "width": 24, "height": 18, "periodic": periodic},
            "species": [
                {"name": "small", "mass": 1, "radius": 0.4, "count": 60, "temperature": 0.1},
                {"name": "large", "mass": 7, "radius": 1.3, "count": 6, "temperature": 0.1},
            ],
            "dynamics": {"kind": kind},
            "frame_interval": 3 if kind == "stepped" else 1.7,
        }
    )


@pytest.mark.parametrize("kind", ["stepped", "event-driven"])
@pytest.mark.parametrize("periodic", [[], ["x", "y"]])
def test_every_frame_goes_on_to_the_same_end(tmp_path: Path, kind: str, periodic: list[str]) -> None:
    simulation = Simulation(gas(kind, periodic))
    with Recorder(tmp_path / "a.h5", simulation.scenario_in_use) as recorder:
        for frame in run(simulation, frames=FRAMES):
            recorder.write(frame)
    end = simulation.frame_view()
    assert end.tallies.pair_collisions.sum() > 50
    with open_recording(tmp_path / "a.h5") as recording:
        for index in range(FRAMES + 1):
            resumed = Simulation(recording.scenario_at(index))
            resumed.advance(until=simulation.time)
            last = resumed.frame_view()
            for part in ("state", "tallies", "memory"):
                assert same_bits(getattr(last, part), getattr(end, part)), f"{part} after frame {index}"


@pytest.mark.parametrize("kind", ["stepped", "event-driven"])
def test_a_frame_and_a_snapshot_are_the_same(tmp_path: Path, kind: str) -> None:
    simulation = Simulation(gas(kind, ["x"]))
    with Recorder(tmp_path / "a.h5", simulation.scenario_in_use) as recorder:
        for frame in run(simulation, frames=3):
            recorder.write(frame)
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.scenario_at(-1).to_dict() == simulation.snapshot().to_dict()


def test_what_is_measured_is_what_the_simulation_says(tmp_path: Path) -> None:
    simulation = Simulation(gas("event-driven", []))
    measurements = Measurements(simulation.scenario)
    with Recorder(tmp_path / "a.h5", simulation.scenario) as recorder:
        frames = run(simulation, frames=1)
        for frame in frames:
            recorder.write(frame, measurements.of(frame))
    with open_recording(tmp_path / "a.h5") as recording:
        numbers = recording.observables()
    summary = simulation.summary()
    for name in ("energy", "temperature", "pressure", "pressure_virial", "collisions", "wall_collisions"):
        assert numbers[name][-1] == summary[name], name
    assert numbers["momentum"][-1].tolist() == summary["momentum"]
    for name in ("temperature", "mean_speed"):
        assert numbers[f"species_{name}"][-1].tolist() == [entry[name] for entry in summary["species"]]
    assert np.isnan(numbers["pressure"][0])
