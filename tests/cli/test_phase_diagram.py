"""`gasbox phase-diagram`: draws, keeps, goes on, is interrupted."""

from __future__ import annotations

import json
import os
import signal
import time
from pathlib import Path
from typing import Any

import pytest
from command import start

from gasbox import sweep
from gasbox.sweep import Recipe

TINY = Recipe(particles=30, settle=2.5, measure=2.5)


@pytest.fixture
def tiny(monkeypatch: pytest.MonkeyPatch) -> None:
    """The quick one is over in a moment."""
    monkeypatch.setattr(sweep, "QUICK", TINY)


@pytest.mark.usefixtures("tiny")
def test_a_diagram_is_drawn_and_kept(command: Any, tmp_path: Path) -> None:
    done = command("phase-diagram", "--quick", "--points", "2x3", "--workers", 1, "-o", "found.png")
    assert done.status == 0, done.err
    assert "30 discs at each point" in done.out
    assert "points in phase-diagram.json" in done.out
    assert (tmp_path / "found.png").stat().st_size > 10_000
    assert len(json.loads((tmp_path / "phase-diagram.json").read_text())["points"]) == 6


@pytest.mark.usefixtures("tiny")
def test_what_is_done_is_not_done_again(
    command: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    options = ("phase-diagram", "--quick", "--points", "2x2", "--workers", 1, "--data", "kept.json")
    first = command(*options, "--json")
    assert first.status == 0, first.err
    kept = (tmp_path / "kept.json").read_bytes()
    monkeypatch.setattr(sweep, "measured", None)
    again = command(*options, "--json")
    assert again.out == first.out
    assert (tmp_path / "kept.json").read_bytes() == kept
    assert len(json.loads(again.out)["points"]) == 4


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--points", "3"), "rows x columns"),
        (("--points", "1x5"), "each 2 to 500"),
        (("-o", "found.txt"), "a figure ends in"),
        (("--data", "nowhere/kept.json"), "no folder"),
        (("--cutoff", "0.5"), "--cutoff"),
    ],
)
def test_nonsense_is_refused(command: Any, arguments: tuple[str, ...], said: str) -> None:
    done = command("phase-diagram", "--quick", *arguments)
    assert done.status == 2
    assert said in done.err


@pytest.mark.skipif(os.name != "posix", reason="sends a signal")
def test_an_interrupted_sweep_keeps_its_points(tmp_path: Path) -> None:
    data = tmp_path / "kept.json"
    process = start(
        "phase-diagram", "--quick", "--particles", 60, "--workers", 2, "--points", "40x40", "--data", data
    )
    try:
        deadline = time.monotonic() + 200
        while not data.exists() and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    finally:
        process.kill()
    assert process.returncode == 130
    assert "the same command goes on from there" in said
    assert "Traceback" not in said
    assert len(json.loads(data.read_text())["points"]) >= 1
