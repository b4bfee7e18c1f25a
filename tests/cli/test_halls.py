"""A gas with gravity, a piston, a membrane and a door, from the command line: run, recorded, resumed, drawn."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from gasbox.cli.panels import FIGURES
from gasbox.cli.plot import Picture
from gasbox.cli.survey import survey
from gasbox.recording import open_recording
from gasbox.scenario import parse

HALL: dict[str, Any] = {
    "seed": 3,
    "container": {"shape": "rectangle", "width": 30, "height": 20},
    "walls": {
        "top": {"name": "lid", "motion": {"kind": "constant", "speed": -0.5, "stop": 4}},
        "left": {"name": "stove", "temperature": 2},
        "right": {"name": "door", "open": True},
    },
    "obstacles": [
        {"shape": "segment", "start": [15, 0], "end": [15, 20], "passes": ["light"], "name": "membrane"},
        {"shape": "disc", "center": [8, 8], "radius": 2},
    ],
    "gravity": [-0.1, 0],
    "schedule": [{"at": 3, "gravity": [0.1, 0]}],
    "species": [
        {
            "name": "light",
            "radius": 0.3,
            "count": 80,
            "temperature": 1,
            "region": {"x": [1, 14], "y": [11, 15]},
        },
        {
            "name": "heavy",
            "mass": 4,
            "radius": 0.5,
            "count": 20,
            "temperature": 16,
            "region": {"x": [16, 29]},
        },
    ],
    "dynamics": {"kind": "event-driven"},
    "frame_interval": 0.25,
}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any], str]:
    """A recording of 24 frames, the summary of its run, and the snapshot at its end."""
    from gasbox.recording import Measurements, Recorder
    from gasbox.simulation import Simulation

    simulation = Simulation(parse(HALL))
    path = tmp_path_factory.mktemp("hall") / "a.h5"
    measurements = Measurements(simulation.scenario)
    with Recorder(path, simulation.scenario_in_use) as recorder:
        for number in range(25):
            if number:
                simulation.advance(frames=1)
            frame = simulation.frame_view()
            recorder.write(frame, measurements.of(frame, simulation.geometry), simulation.changes)
    return path, simulation.summary(), json.dumps(simulation.snapshot().to_dict()["particles"])


def test_what_a_recording_has_to_tell(recorded: tuple[Path, dict[str, Any], str]) -> None:
    path, summary, _ = recorded
    with open_recording(path) as recording:
        found = survey(recording, 12)
    walls = {entry["name"]: entry for entry in summary["walls"]}
    assert found.times.tolist() == [0.25 * number for number in range(25)]
    assert abs(found.book.residual[-1]) < 1e-9 * found.book.internal[0]
    assert found.book.changes[11] == 0.0
    assert found.book.changes[12] != 0.0
    assert (found.start.gravity[0], found.end.gravity[0]) == (-0.1, 0.1)
    names = found.walls.names
    assert found.book.wall_work[-1, names.index("lid")] == pytest.approx(walls["lid"]["work"])
    assert found.book.wall_heat[-1, names.index("stove")] == pytest.approx(walls["stove"]["heat"])
    passed = found.passed[-1, names.index("membrane"), 0]
    assert passed.tolist() == list(walls["membrane"]["passed"]["light"].values())
    # Of the light gas, those that are behind the membrane now went through it, whoever left afterwards.
    counts = found.sides["membrane"].counts
    assert counts[0].tolist() == [[80, 0], [0, 20]]
    assert counts[-1, 0, 0] == 80 - (passed[0] - passed[1])
    assert summary["left"]["heavy"] == 20 - counts[-1, 1].sum() > 0
    assert found.diagram is not None
    assert found.diagram.area[-1] == pytest.approx(summary_area(2.0))
    assert found.profiles is not None
    assert found.profiles.frames == 13
    assert found.centers is not None


def summary_area(way: float) -> float:
    """Area with the lid that far down, less the disc that stands there."""
    return 30 * (20 - way) - 3.141592653589793 * 4


@pytest.mark.parametrize("name", ["overview", "profiles", "pv", "flow", "gas"])
def test_figures(command: Any, recorded: tuple[Path, dict[str, Any], str], name: str) -> None:
    done = command("plot", recorded[0], "-o", "a.png", "--figure", name)
    assert done.status == 0, done.err
    assert Path("a.png").read_bytes().startswith(b"\x89PNG")


def test_each_figure_has_a_name() -> None:
    assert {one.value for one in Picture} == {"overview", "histograms", "series", *FIGURES}


def test_a_figure_of_what_is_not_there_is_refused(command: Any) -> None:
    command("run", "two-discs", "--frames", 2, "--record", "a.h5")
    done = command("plot", "a.h5", "-o", "a.png", "--figure", "pv")
    assert done.status == 2
    assert "pressure and area behind a moving wall" in done.err
    assert not Path("a.png").exists()
    assert command("plot", "a.h5", "-o", "a.png", "--figure", "gas").status == 0


def test_a_frame_that_discs_have_left_is_resumed_to_the_same_bits(
    command: Any, recorded: tuple[Path, dict[str, Any], str]
) -> None:
    path, summary, particles = recorded
    done = command("resume", path, "--at", 16, "--until", 6, "--snapshot", "end.json", "--json")
    assert done.status == 0, done.err
    assert json.loads(done.out)["time"] == summary["time"] == 6
    assert parse(Path("end.json").read_bytes()).to_dict()["particles"] == json.loads(particles)


def test_the_table_of_walls_for_people(command: Any) -> None:
    Path("hall.json").write_text(json.dumps(HALL))
    done = command("run", "hall.json", "--frames", 12)
    assert done.status == 0, done.err
    for text in ("lid", "stove", "door", "membrane", "work", "heat", "carried", "passed", "potential energy"):
        assert text in done.out, text
    assert "disc_1" not in command("run", "two-discs", "--frames", 1).out


def test_check_says_what_the_gas_is_in(command: Any) -> None:
    Path("hall.json").write_text(json.dumps(HALL))
    expected = "30 x 20, 2 obstacles, 1 moving wall, 1 scheduled change, gravity -0.1 0, event-driven"
    assert expected in " ".join(command("check", "hall.json").out.split())
    circle = {"container": {"shape": "circle", "radius": 10}, "species": [{"name": "a", "radius": 0.3}]}
    Path("circle.json").write_text(json.dumps(circle))
    assert "in a circle of radius 10" in command("check", "circle.json").out
