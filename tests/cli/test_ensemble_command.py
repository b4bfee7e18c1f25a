"""`gasbox ensemble`: table, JSON, CSV and figure; refusals; interruption."""

from __future__ import annotations

import csv
import json
import math
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from command import environment

SMALL = ("ensemble", "one-gas", "--set", "species.0.count=30", "--seeds", 6)


def test_runs_are_told_drawn_and_kept(command: Any, tmp_path: Path) -> None:
    done = command(*SMALL, "--until", 40, "--workers", 1, "-o", "a.png", "--data", "a.csv")
    assert done.status == 0, done.err
    assert "6 runs up to time 40" in done.out
    assert "pressure on the walls" in done.out
    assert "particles 30" in done.out
    assert (tmp_path / "a.png").stat().st_size > 10_000
    rows = list(csv.DictReader((tmp_path / "a.csv").read_text().splitlines()))
    assert [row["seed"] for row in rows] == ["1", "2", "3", "4", "5", "6"]
    assert {row["particles"] for row in rows} == {"30.0"}
    assert len({row["wall_collisions"] for row in rows}) > 1


def test_json_says_the_same_for_any_number_of_workers(command: Any, tmp_path: Path) -> None:
    told = []
    for workers in (1, 2):
        done = command(
            *SMALL, "--frames", 40, "--first-seed", 3, "--workers", workers, "--json", "--data", "a.json"
        )
        assert done.status == 0, done.err
        told.append(json.loads(done.out))
        assert json.loads((tmp_path / "a.json").read_text()) == told[-1]
        assert told[-1].pop("wall_seconds") > 0
    one, two = told
    assert one == two
    assert (one["runs"], one["seeds"], one["interrupted"], one["failures"]) == (6, [*range(3, 9)], False, [])
    pressure, spread = one["values"]["pressure"], one["statistics"]["pressure"]
    assert spread["mean"] == pytest.approx(sum(pressure) / 6)
    assert spread["standard_error"] == pytest.approx(spread["standard_deviation"] / math.sqrt(6))
    assert "series" not in one


def test_runs_that_cannot_differ_are_noted(command: Any) -> None:
    done = command("ensemble", "two-discs", "--seeds", 2, "--frames", 2, "--workers", 1)
    assert done.status == 0
    assert "nothing in this scenario depends on the seed" in done.err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "say how far to run"),
        (("--until", 5, "--frames", 5), "say how far to run"),
        (("--until", 0), "beyond the start"),
        (("--until", 5, "--seeds", 0), "--seeds"),
        (("--until", 5, "--first-seed", 2**63 - 3), "below 2^63"),
        (("--until", 5, "--workers", 0), "--workers"),
        (("--until", 5, "-o", "a.txt"), "a figure ends in"),
        (("--until", 5, "--data", "a.txt"), ".csv or .json"),
        (("--until", 5, "--data", "nowhere/a.csv"), "no folder"),
        (("--until", 5, "--set", "seed=4"), "--first-seed"),
        (("--until", 5, "--set", "species.0.radius=900"), "problem"),
    ],
)
def test_nonsense_is_refused(command: Any, arguments: tuple[Any, ...], said: str) -> None:
    done = command(*SMALL, *arguments)
    assert done.status == 2
    assert said in done.err
    assert done.out == ""


@pytest.mark.skipif(os.name != "posix", reason="sends a signal")
def test_an_interrupted_ensemble_writes_what_there_is(tmp_path: Path) -> None:
    data = tmp_path / "a.csv"
    wanted = [
        "two-discs",
        "--seeds",
        "1000000",
        "--until",
        "1",
        "--workers",
        "2",
        "--data",
        str(data),
        "--json",
    ]
    code = (
        "import os, signal\n"
        "from gasbox.cli import main, progress\n"
        "class Noticed(progress.Progress):\n"
        "    def show(self, now):\n"
        "        if now == 3: os.kill(os.getpid(), signal.SIGINT)\n"
        "progress.Progress = Noticed\n"
        f"main({['ensemble', *wanted]!r})"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=environment(), timeout=300
    )
    assert done.returncode == 130, done.stderr
    assert "Interrupted: 3 of 1000000 runs are done." in done.stderr
    assert "Traceback" not in done.stderr
    told = json.loads(done.stdout)
    assert told["interrupted"]
    assert told["runs"] == 3
    assert len(data.read_text().splitlines()) == 4
