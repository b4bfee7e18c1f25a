"""Figures of matter from recordings: of hard discs that were run, and of discs with forces made by hand."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gasbox.cli.matter import FIGURES_OF_MATTER, matter_panels, neighbour_distance, outer_pressure
from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import Scenario, parse
from gasbox.state import Frame, SetBarostat, State, Tallies

COUNT, SPACING = 64, 1.13
SCENARIO: Scenario = parse(
    {
        "container": {
            "shape": "rectangle",
            "width": 8 * SPACING,
            "height": 8 * SPACING * math.sqrt(0.75),
            "periodic": ["x", "y"],
        },
        "species": [{"name": "a", "radius": 0.5, "count": COUNT, "temperature": 0.3}],
        "dynamics": {"kind": "forced"},
        "barostat": {"pressure": 0.02},
        "schedule": [{"at": 6, "barostat": {"pressure": 0.04, "over": 2}}],
    }
)


def made(number: int) -> Frame:
    """A crystal that is stretched more and more, ever warmer."""
    stretch = 1.0 + 0.1 * number
    place = [[i + 0.5 * (j % 2), j * math.sqrt(0.75)] for j in range(8) for i in range(8)]
    position = (np.array(place) + 0.25) * SPACING * stretch
    size = SCENARIO.geometry().size * (stretch - 1.0)
    velocity = np.sqrt(0.3 + 0.05 * number) * np.where(np.arange(COUNT) % 2, 1.0, -1.0)
    state = State(
        time=float(number),
        id=np.arange(COUNT),
        species=np.zeros(COUNT, np.int32),
        mass=np.ones(COUNT),
        radius=np.full(COUNT, 0.5),
        position=position,
        velocity=np.stack([velocity, -velocity], axis=1),
        wall_displacement=np.array([0.0, size[0], 0.0, size[1]]),
        wall_velocity=np.zeros(4),
        potential=-3.0 * COUNT / stretch**6,
    )
    return Frame(number, state, Tallies.zero(1, 4), {"step": number})


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of ten such frames."""
    path = tmp_path_factory.mktemp("matter") / "a.h5"
    measurements = Measurements(SCENARIO)
    with Recorder(path, SCENARIO) as recorder:
        for number in range(10):
            recorder.write(made(number), measurements.of(made(number)))
    return path


@pytest.mark.parametrize("name", [*FIGURES_OF_MATTER, "energy", "overview"])
def test_figures_of_a_gas_with_forces(command: Any, recorded: Path, name: str) -> None:
    done = command("plot", recorded, "-o", "a.png", "--figure", name)
    assert done.status == 0, done.err
    assert Path("a.png").read_bytes().startswith(b"\x89PNG")


def test_a_heating_curve_has_heat_and_work(recorded: Path) -> None:
    with open_recording(recorded) as recording:
        (panel,) = matter_panels("heating-curve", recording, 5)
    curve = panel.keywords["curve"]
    assert curve.shares[0].tolist() == [0.0, 0.0, 1.0]
    assert curve.shares[-1].tolist() == [1.0, 0.0, 0.0]
    # Until the sixth frame P = 0.02: d(K + U) + P dA.
    area = SCENARIO.geometry().area / COUNT * (1.0 + 0.1 * np.arange(7)) ** 2
    energy = 0.3 + 0.05 * np.arange(7) - 3.0 / (1.0 + 0.1 * np.arange(7)) ** 6
    enthalpy = energy + 0.02 * area
    assert curve.heat[:7] == pytest.approx(enthalpy - enthalpy[0])


def test_the_pressure_follows_the_schedule_and_the_hand(tmp_path: Path) -> None:
    with Recorder(tmp_path / "b.h5", SCENARIO) as recorder:
        recorder.write(made(0))
        recorder.write(
            made(9), {}, [(6.0, SetBarostat(0.04, 2.0)), (7.0, SetBarostat(0.01)), (8.5, SetBarostat(None))]
        )
    with open_recording(tmp_path / "b.h5") as recording:
        pressure = outer_pressure(recording)
    times = (0.0, 6.0, 6.5, 7.5, 9.0)
    # Half-way up at seven it is set to 0.01 at once.
    assert [pressure(time) for time in times] == pytest.approx([0.02, 0.02, 0.025, 0.01, 0.01])


def test_hard_discs_are_matter_too_but_take_no_heat(command: Any) -> None:
    command("run", "two-discs", "--frames", 5, "--record", "a.h5")
    for name in ("rdf", "msd", "hexatic", "phases"):
        assert command("plot", "a.h5", "-o", "a.png", "--figure", name).status == 0
    done = command("plot", "a.h5", "-o", "b.png", "--figure", "heating-curve")
    assert done.status == 2
    assert "temperature against heat added" in done.err


def test_neighbours_are_told_by_the_mean_size() -> None:
    assert neighbour_distance(SCENARIO) == 1.5
    small = {"name": "a", "radius": 0.5, "count": 30, "temperature": 1}
    large = {"name": "b", "radius": 9, "sigma": 3.0, "count": 10, "temperature": 1}
    box = {"shape": "rectangle", "width": 400, "height": 400}
    mixed = parse({"container": box, "species": [small, large], "dynamics": {"kind": "forced"}})
    assert neighbour_distance(mixed) == pytest.approx(1.5 * 1.5)
