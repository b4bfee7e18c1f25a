"""Figures of molecules from a recording of free rotors, which is made by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gasbox.cli.molecules import FIGURES_OF_MOLECULES, molecule_panels
from gasbox.initial import populate
from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import Scenario, parse
from gasbox.state import Frame, Tallies

SCENARIO: Scenario = parse(
    {
        "container": {"shape": "rectangle", "width": 40, "height": 40, "periodic": ["x", "y"]},
        "species": [{"name": "discs", "radius": 0.5, "count": 5, "temperature": 1}],
        "molecules": [
            {
                "name": "sticks",
                "atoms": [{"position": [0, 0], "radius": 0.5}, {"position": [1, 0], "radius": 0.5}],
                "count": 60,
                "temperature": 1,
            }
        ],
    }
)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Molecules that turn where they are."""
    path = tmp_path_factory.mktemp("molecules") / "a.h5"
    measurements, state = Measurements(SCENARIO), populate(SCENARIO)
    with Recorder(path, SCENARIO) as recorder:
        for number in range(12):
            frame = Frame(number, state, Tallies.zero(2, 4), {"step": number})
            recorder.write(frame, measurements.of(frame))
            state.time += 0.25
            state.angle += 0.25 * state.angular_velocity
            state.turn_sites()
    return path


@pytest.mark.parametrize("name", [*FIGURES_OF_MOLECULES, "overview"])
def test_figures_of_molecules(command: Any, recorded: Path, name: str) -> None:
    done = command("plot", recorded, "-o", "a.png", "--figure", name)
    assert done.status == 0, done.err
    assert Path("a.png").read_bytes().startswith(b"\x89PNG")


def test_what_the_panels_show(recorded: Path) -> None:
    with open_recording(recorded) as recording:
        (modes,) = molecule_panels("modes", recording, 0, 1.0)
        assert np.ptp(modes.keywords["modes"].rotation) == 0.0  # type: ignore[attr-defined]
        rates, energies = molecule_panels("rotation", recording, 0, 1.0)
        for panel in (rates, energies):
            shown, expected = (panel.keywords[name] for name in ("shown", "expected"))  # type: ignore[attr-defined]
            # The discs are left out, and nearly all of the law lies within the axis.
            assert shown.total == 60
            assert float(np.sum(expected)) == pytest.approx(60, rel=5e-3)
        assert len(molecule_panels("orientation", recording, 0, 1.0)) == 3
        assert not molecule_panels("rotation", recording, 0)[0].keywords["expected"]  # type: ignore[attr-defined]
