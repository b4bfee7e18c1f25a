"""`gasbox bench` from end to end, with few discs and short rounds."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import typer

from gasbox import bench
from gasbox.bench import Result, cases, fluids, measure
from gasbox.cli.bench import bench as command
from gasbox.dynamics.team import processors


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cases, "_QUICK_ROUNDS", 2)
    monkeypatch.setattr(cases, "_QUICK_SECONDS", 0.004)
    monkeypatch.setattr(cases, "_QUICK_SIZES", (100, 300))
    # On a busy machine ranks of MPI mostly wait for each other; their own tests start them.
    monkeypatch.setattr(fluids, "ranks_start", lambda: False)
    whole = measure
    monkeypatch.setattr(bench, "measure", lambda *arguments: whole(*arguments, sample=200))


def test_everything_is_measured(short: None) -> None:
    told: list[str] = []
    parts = list(bench.measure(True, told.append))
    forced = min(2, processors())
    assert len(told) == len(parts) == 2 * (4 + forced) + 8
    # Small ones first, so that who interrupts it has seen as much as possible.
    assert [part[0].particles for part in parts] == [100] * (4 + forced) + [200] * 8 + [300] * (4 + forced)
    programs = {part[0].task: [result.program for result in part] for part in parts}
    assert programs["event-driven, 0.3"] == ["gasbox", "plain loops"]
    assert programs["event-driven, mixture"] == ["gasbox", "gasbox, sizes 1:10", "gasbox, sizes 1:50"]
    assert programs["stepped, 0.2"][:2] == ["gasbox", "plain loops"]
    assert len(programs["stepped, observed"]) == 3
    assert programs["forced"][0] == "gasbox"
    assert programs["stepped, enclosed"][1] == "gasbox, 100-sided polygon"
    assert all(rate > 0 for part in parts for result in part for rate in result.rates)


def test_results_and_chart_are_kept_and_the_next_run_compares(
    short: None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command(quick=True, output=tmp_path)
    first = capsys.readouterr()
    assert "moved" not in first.out
    assert "event-driven, 0.05: 100 discs" in first.err
    (path,) = tmp_path.glob("*.json")
    assert path.with_suffix(".png").is_file()
    command(quick=True, output=tmp_path / "one.json")
    assert "moved" not in capsys.readouterr().out
    assert not (tmp_path / "one.png").exists()
    (tmp_path / "one.json").unlink()
    command(quick=True, output=tmp_path)
    # The path may be broken by the width of the terminal, its name is not.
    assert path.name in capsys.readouterr().out


def test_an_interrupted_bench_shows_what_it_has(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: Any) -> Iterator[list[Result]]:
        yield [Result("stepped, 0.2", "particle steps", 1000, "gasbox", (2e7,), 1.0)]
        raise KeyboardInterrupt

    monkeypatch.setattr(bench, "measure", interrupted)
    with pytest.raises(typer.Exit) as end:
        command(output=tmp_path)
    assert end.value.exit_code == 130
    shown = capsys.readouterr().out
    assert "stepped, 0.2" in shown
    assert "Interrupted" in shown
    assert list(tmp_path.iterdir()) == []


def test_interrupted_at_once_there_is_nothing_to_show(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: Any) -> Iterator[list[Result]]:
        raise KeyboardInterrupt
        yield []

    monkeypatch.setattr(bench, "measure", interrupted)
    with pytest.raises(typer.Exit):
        command()
    assert "million" not in capsys.readouterr().out
