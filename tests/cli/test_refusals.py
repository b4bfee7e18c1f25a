from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from gasbox.errors import DynamicsError
from gasbox.simulation import Simulation

RUN = ("run", "one-gas", "--frames", "1")
REFUSED = [
    (("run", "three-gasses", "--frames", "1"), ["three-gases"]),
    (("run", "none.json", "--frames", "1"), ["none.json"]),
    (("run", ".", "--frames", "1"), ["cannot read"]),
    (("run", "text.json", "--frames", "1"), ["text.json", "JSON"]),
    (("run", "bad.json", "--frames", "1"), ["bad.json", "species[0].radius", "species[1].mass", "container"]),
    (("check", "bad.json"), ["bad.json", "species[0].radius", "species[1].mass", "container"]),
    (("check", "overlap.json"), ["overlap"]),
    (("run", "one-gas"), ["--until", "--frames"]),
    (("run", "one-gas", "--until", "5", "--frames", "3"), ["not both"]),
    (("run", "one-gas", "--until", "-1"), ["until", "time 0"]),
    (("run", "one-gas", "--until", "nan"), ["until"]),
    (("run", "one-gas", "--frames", "-1"), ["negative"]),
    (("run", "one-gas", "--frames", "many"), ["--frames"]),
    (("run", "one-gas", "--bogus"), ["--bogus"]),
    (("run",), ["SCENARIO"]),
    (("bogus",), ["bogus"]),
    ((*RUN, "--frame", "0"), ["frame_interval"]),
    ((*RUN, "--record-every", "1"), ["--record FILE"]),
    ((*RUN, "--record", "a.h5", "--record-every", "0"), ["--record-every", "above zero"]),
    (("run", "two-discs", "--frames", "1", "--record", "a.h5", "--record-every", "0.5"), ["time step"]),
    ((*RUN, "--record", "none/a.h5"), ["no folder none"]),
    ((*RUN, "--record", "good.json"), ["good.json", "not a recording"]),
    ((*RUN, "--snapshot", "a.h5"), [".json.gz"]),
    ((*RUN, "--snapshot", "none/a.json"), ["no folder none"]),
    (("run", "good.json", "--frames", "1", "--snapshot", "good.json"), ["would replace"]),
    ((*RUN, "--set", "seed"), ["PATH=VALUE"]),
    ((*RUN, "--set", "species.7.count=1"), ["species.7.count"]),
    ((*RUN, "--set", "species.0.count=-1"), ["species[0].count"]),
    ((*RUN, "--seed", "-1"), ["seed"]),
    (("resume", "good.json", "--frames", "1"), ["not a snapshot", "gasbox run good.json"]),
    (("resume", "none.h5", "--frames", "1"), ["none.h5"]),
    (("resume", "cut.h5", "--frames", "1"), ["cut.h5", "damaged"]),
    (("resume", "run.h5", "--at", "9", "--frames", "1"), ["no frame 9", "0 to 2"]),
    (("resume", "run.h5", "--frames", "1", "--record", "run.h5"), ["would replace"]),
    (("resume", "end.json", "--at", "1", "--frames", "1"), ["--at"]),
    (("resume", "end.json", "--until", "0.1"), ["already"]),
    (("plot", "good.json", "-o", "a.png"), ["good.json", "not an HDF5 file"]),
    (("plot", "none.h5", "-o", "a.png"), ["none.h5"]),
    (("plot", "run.h5", "-o", "a.txt"), [".png"]),
    (("plot", "run.h5", "-o", "none/a.png"), ["no folder none"]),
    (("plot", "run.h5"), ["--output"]),
    (("lab", "bad.json"), ["species[0].radius"]),
    (("lab", "--port", "70000"), ["--port"]),
]


@pytest.fixture
def files(command: Any) -> None:
    """Good and bad files in the folder where the commands run."""
    box = {"shape": "rectangle", "width": 20, "height": 20}
    species = [{"name": "a", "radius": 1}]
    Path("good.json").write_text(json.dumps({"container": box, "species": species}))
    lying = [{"species": "a", "position": [5, 5]}, {"species": "a", "position": [6, 5]}]
    Path("overlap.json").write_text(json.dumps({"container": box, "species": species, "particles": lying}))
    wrong = [{"name": "a", "radius": -1}, {"name": "b", "mass": "heavy"}]
    Path("bad.json").write_text(json.dumps({"container": {"shape": "star"}, "species": wrong}))
    Path("text.json").write_text("{")
    end = command("run", "one-gas", "--frames", 2, "--record", "run.h5", "--snapshot", "end.json")
    assert end.status == 0
    whole = Path("run.h5").read_bytes()
    Path("cut.h5").write_bytes(whole[: len(whole) // 2])


def test_what_makes_no_sense_is_refused_in_a_sentence(command: Any, files: None) -> None:
    before = {path: path.read_bytes() for path in Path().iterdir()}
    for arguments, expected in REFUSED:
        done = command(*arguments)
        assert done.status == 2, arguments
        assert done.out == "", arguments
        assert "Traceback" not in done.err
        assert [text for text in expected if text not in done.err] == [], f"{arguments}: {done.err}"
    assert {path: path.read_bytes() for path in Path().iterdir()} == before


def test_an_engine_that_cannot_go_on_ends_with_status_1(
    command: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(self: Simulation, until: float) -> None:
        raise DynamicsError("no progress at time 3")

    monkeypatch.setattr(Simulation, "_advance_to", fail)
    done = command("run", "one-gas", "--frames", 1, "--record", "a.h5")
    assert (done.status, done.out) == (1, "")
    assert done.err == "Error: no progress at time 3\n"
    assert command("resume", "a.h5", "--frames", 0).status == 0
