from __future__ import annotations

import json
import sys
import types
from pathlib import Path
from typing import Any

import h5py
import pytest

import gasbox
from gasbox import jit
from gasbox.cli import timetable
from gasbox.scenario import Scenario, load, parse, schema, shipped

SUMMARY = {
    *("time", "frames", "particles", "collisions", "wall_collisions", "energy", "momentum", "temperature"),
    *("pressure", "pressure_virial", "species", "wall_seconds", "collisions_per_second"),
    *("particle_steps_per_second", "warnings", "version", "scenario_hash"),
}
TEMPERATURES = {"temperature_translational", "temperature_rotational", "temperature_vibrational"}
SPECIES = {"name", "count", "temperature", "mean_speed", "rms_speed", "center_of_mass"}


def summary(command: Any, *arguments: object) -> dict[str, Any]:
    """The JSON that a command prints, which must be all that it prints."""
    done = command(*arguments, "--json")
    assert done.status == 0, done.err
    printed: dict[str, Any] = json.loads(done.out)
    return printed


@pytest.mark.parametrize("name", shipped())
def test_every_shipped_scenario_runs(command: Any, name: str) -> None:
    printed = summary(command, "run", name, "--frames", 2)
    scenario = load(name)
    assert printed["frames"] == 2
    assert printed.keys() >= SUMMARY
    more = TEMPERATURES if scenario.molecules else set()
    assert all(entry.keys() == SPECIES | more for entry in printed["species"])
    assert [entry["name"] for entry in printed["species"]] == [kind.name for kind in scenario.kinds]
    assert printed["scenario_hash"] == scenario.hash()
    assert printed["version"] == gasbox.__version__
    assert printed["warnings"] == []


def test_the_worked_example(command: Any) -> None:
    printed = summary(command, "run", "two-discs", "--frames", 2)
    assert printed["time"] == 2
    assert printed["collisions"] == 1
    assert printed["species"][0]["center_of_mass"] == [20, 19.9]
    assert printed["species"][1]["center_of_mass"] == [21.4, 21.5]


def test_until_is_absolute_and_frame_sets_the_interval(command: Any) -> None:
    printed = summary(command, "run", "one-gas", "--until", 3, "--frame", 0.5)
    assert (printed["time"], printed["frames"]) == (3, 6)


def test_the_summary_for_people(command: Any) -> None:
    done = command("run", "three-gases", "--frames", 1)
    assert done.status == 0
    for text in ("temperature", "pressure on the walls", "light", "medium", "heavy", "Three gases in a box"):
        assert text in done.out
    assert done.err == ""


def test_settings_and_seed(command: Any) -> None:
    arguments = ("--set", "species.0.count=50", "--set", "species.0.name=[odd]", "--frames", 1)
    printed = summary(command, "run", "three-gases", *arguments)
    assert printed["species"][0]["count"] == 50
    assert printed["species"][0]["name"] == "[odd]"
    assert "[odd]" in command("run", "three-gases", *arguments).out
    seeds = [
        summary(command, "run", "one-gas", "--frames", 1, "--seed", seed)["momentum"] for seed in (1, 1, 2)
    ]
    assert seeds[0] == seeds[1] != seeds[2]


def test_warnings_are_in_the_summary_and_on_standard_error(command: Any) -> None:
    arguments = ("run", "two-discs", "--frames", 1, "--set", "particles.0.velocity.0=3")
    done = command(*arguments, "--json")
    assert "pass through each other" in json.loads(done.out)["warnings"][0]
    assert "Warning: discs can pass through each other" in done.err


def test_a_gas_without_walls_or_temperature_has_null_for_them(command: Any) -> None:
    lone = {
        "container": {"shape": "rectangle", "width": 9, "height": 9, "periodic": ["x", "y"]},
        "species": [{"name": "a"}],
        "particles": [{"species": "a", "position": [1, 1], "velocity": [1, 0]}],
    }
    Path("lone.json").write_text(json.dumps(lone))
    printed = summary(command, "run", "lone.json", "--frames", 1)
    assert printed["pressure"] is None
    assert printed["temperature"] is None


@pytest.mark.parametrize("dynamics", ["stepped", "event-driven"])
def test_a_frame_walked_in_pieces_ends_in_the_same_bits(
    command: Any, dynamics: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    arguments = ("run", "one-gas", "--set", f"dynamics.kind={dynamics}", "--until", 40, "--frame", 10)
    ends = []
    for moment in (0.0, 1e9):
        # The shortest pieces, and the longest.
        monkeypatch.setattr(timetable, "_LONGEST", moment)
        assert command(*arguments, "--snapshot", "end.json").status == 0
        ends.append(Path("end.json").read_bytes())
    assert ends[0] == ends[1]


@pytest.mark.parametrize("every", [None, 0.5, 0.7, 2.5])
def test_recording_at_times_of_its_own(command: Any, every: float | None) -> None:
    arguments = () if every is None else ("--record-every", every)
    plain = summary(command, "run", "one-gas", "--frames", 6, "--frame", 1, "--snapshot", "plain.json")
    printed = summary(
        command,
        "run",
        "one-gas",
        "--frames",
        6,
        "--frame",
        1,
        "--snapshot",
        "end.json",
        "--record",
        "a.h5",
        *arguments,
    )
    count = int(6 / (every or 1) + 1e-9) + 1
    assert printed["recorded_frames"] == count
    assert printed["recording"] == "a.h5"
    with h5py.File("a.h5") as file:
        times = file["particles/all/position/time"][:].tolist()
        assert times == pytest.approx([number * (every or 1) for number in range(count)], rel=1e-12)
        assert file["particles/all/position/step"][:].tolist() == list(range(count))
    # Recording did not disturb.
    assert Path("end.json").read_bytes() == Path("plain.json").read_bytes()
    assert printed["frames"] == plain["frames"] == 6


@pytest.mark.parametrize("dynamics", ["stepped", "event-driven"])
@pytest.mark.parametrize("form", ["json", "json.gz", "h5", "h5 in between"])
def test_a_resumed_run_ends_in_the_same_bits(command: Any, dynamics: str, form: str) -> None:
    gas = ("--set", f"dynamics.kind={dynamics}", "--set", "species.0.count=200")
    command("run", "one-gas", *gas, "--until", 10, "--snapshot", "whole.json")
    if form.startswith("h5"):
        command("run", "one-gas", *gas, "--until", 6, "--record", "half.h5", "--record-every", 2)
        at = ("half.h5", "--at", 1) if form == "h5 in between" else ("half.h5",)
    else:
        command("run", "one-gas", *gas, "--until", 6, "--snapshot", f"half.{form}")
        at = (f"half.{form}",)
    done = command("resume", *at, "--until", 10, "--snapshot", "resumed.json")
    assert done.status == 0, done.err
    assert (
        parse(Path("resumed.json").read_bytes()).to_dict() == parse(Path("whole.json").read_bytes()).to_dict()
    )


def test_a_resumed_run_may_record_and_replace_its_snapshot(command: Any) -> None:
    command("run", "one-gas", "--frames", 1, "--snapshot", "s.json")
    first = load("s.json")
    assert command("resume", "s.json", "--frames", 2, "--snapshot", "s.json", "--record", "a.h5").status == 0
    second = load("s.json")
    assert first.snapshot is not None
    assert second.snapshot is not None
    assert second.snapshot.time == pytest.approx(3 * first.snapshot.time)


def test_another_version_is_noted(command: Any) -> None:
    command("run", "one-gas", "--frames", 1, "--snapshot", "s.json")
    text = Path("s.json").read_text()
    Path("s.json").write_text(text.replace(f'"{gasbox.__version__}"', '"0.0.9"'))
    done = command("resume", "s.json", "--frames", 1)
    assert done.status == 0
    assert "was written by gasbox 0.0.9" in done.err


def test_check_schema_scenarios_and_version(command: Any) -> None:
    for name in shipped():
        assert command("check", name).out.startswith(f"{name}: a good scenario")
        assert name in command("scenarios").out
    assert json.loads(command("schema").out) == schema()
    assert command("--version").out == f"gasbox {gasbox.__version__}\n"
    command("run", "one-gas", "--frames", 1, "--snapshot", "s.json")
    assert "a good snapshot at time" in command("check", "s.json").out


@pytest.mark.parametrize("ending", ["png", "svg", "pdf"])
def test_plot(command: Any, ending: str) -> None:
    command("run", "three-gases", "--frames", 4, "--record", "a.h5")
    done = command("plot", "a.h5", "-o", f"a.{ending}")
    assert done.status == 0, done.err
    start = {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}[ending]
    assert Path(f"a.{ending}").read_bytes().startswith(start)


def test_plot_of_a_single_frame_at_rest(command: Any) -> None:
    still = ("--set", "species.0.count=3", "--set", "species.0.temperature=0")
    command("run", "one-gas", *still, "--frames", 0, "--record", "a.h5")
    assert command("plot", "a.h5", "-o", "a.png", "--last", 5).status == 0


def test_the_first_start_says_that_it_compiles(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jit, "was_compiled", lambda: False)
    done = command("run", "two-discs", "--frames", 1, "--json")
    assert "Compiling kernels for this machine: at the first start only" in done.err
    json.loads(done.out)


def test_lab_serves_the_scenario(command: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    served: list[tuple[Any, ...]] = []
    server = types.SimpleNamespace(serve=lambda *arguments: served.append(arguments))
    monkeypatch.setitem(sys.modules, "gasbox.app.server", server)
    assert command().status == 0
    assert command("lab").status == 0
    options = ("--host", "::1", "--port", 0, "--no-browser", "--max-sessions", 3)
    assert command("lab", "one-gas", *options).status == 0
    default, named = load("three-gases"), load("one-gas")
    assert isinstance(default, Scenario)
    assert served == [(default, "127.0.0.1", None, True, 16)] * 2 + [(named, "::1", 0, False, 3)]
    assert command("lab", "no-such-gas").status == 2
    assert len(served) == 3
