"""What is kept of a bench, what is shown of it, and what has moved since the last one."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from gasbox.bench import Result, draw_rates, newest, print_table, results, save, save_chart
from gasbox.errors import FileError

DENSE = Result("event-driven, 0.6", "collisions", 1000, "gasbox", (0.9e6, 1e6, 1.1e6), 1.0)
PLAIN = Result("event-driven, 0.6", "collisions", 1000, "plain loops", (4e5, 5e5, 6e5), 2.0)
STEPPED = Result("stepped, 0.2", "particle steps", 10_000, "gasbox", (2e7,), 1.0)
FORCED = Result("forced", "particle steps", 1000, "gasbox", (9e6,), 1.0)
LAMMPS = Result("forced", "particle steps", 1000, "LAMMPS", (6e6,), 1.5)
ALL = [STEPPED, DENSE, PLAIN]


def faster(result: Result, factor: float) -> Result:
    rates = tuple(factor * rate for rate in result.rates)
    return Result(result.task, result.unit, result.particles, result.program, rates, result.ratio)


@pytest.mark.parametrize("folder", [True, False])
def test_kept_with_machine_versions_and_date(tmp_path: Path, folder: bool) -> None:
    path = save(ALL, tmp_path if folder else tmp_path / "mine.json")
    kept = json.loads(path.read_text())
    assert [row["median"] for row in kept["rates"]] == [2e7, 1e6, 5e5]
    assert kept["mode"] == "full"
    assert kept["machine"]["cores"] >= 1
    assert {"gasbox", "python", "numpy", "numba"} <= kept["versions"].keys()
    assert kept["date"].endswith("+00:00")
    with pytest.raises(FileError, match="cannot write"):
        save(ALL, tmp_path / "none" / "x.json")


def test_the_table_shows_rates_and_ratios(capsys: pytest.CaptureFixture[str]) -> None:
    print_table(ALL, missing=["rebound"])
    shown = capsys.readouterr().out
    lines = [line.split() for line in shown.splitlines() if "1,000" in line]
    assert lines == [
        ["event-driven,", "0.6", "1,000", "gasbox", "1", "0.9-1.1", "1.00"],
        ["event-driven,", "0.6", "1,000", "plain", "loops", "0.5", "0.4-0.6", "2.00"],
    ]
    assert shown.index("event-driven, 0.6") < shown.index("stepped, 0.2")
    assert "moved" not in shown
    assert "event-driven: collisions; stepped: particle steps" in shown
    assert "do not start: rebound" in shown


def keep(folder: Path, name: str, kept: list[Result], date: str, quick: bool = False, **other: Any) -> Path:
    path = save(kept, folder / name, quick)
    content = json.loads(path.read_text())
    content["date"] = date
    content["machine"] |= other
    path.write_text(json.dumps(content))
    return path


def test_what_moved_since_the_last_run_of_its_kind(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert newest(tmp_path) is None
    keep(tmp_path, "a.json", [faster(DENSE, 2.0)], "2026-01-01T00:00:00+00:00")
    last = keep(tmp_path, "b.json", [faster(DENSE, 1 / 1.03)], "2026-02-01T00:00:00+00:00")
    keep(tmp_path, "c.json", [faster(DENSE, 3.0)], "2026-03-01T00:00:00+00:00", quick=True)
    keep(tmp_path, "d.json", [faster(DENSE, 4.0)], "2026-03-02T00:00:00+00:00", processor="another")
    keep(tmp_path, "e.json", [faster(DENSE, 5.0)], "2026-03-03T00:00:00+00:00", cores=1000)
    for name, text in {"f": "{", "g": "[]", "h": "{}", "i": '{"mode": "full"}'}.items():
        (tmp_path / f"{name}.json").write_text(text)
    earlier = newest(tmp_path)
    assert earlier is not None
    assert earlier.path == last
    assert earlier.moved(DENSE) == pytest.approx(0.03)
    assert earlier.moved(PLAIN) is None
    print_table(ALL, earlier)
    shown = capsys.readouterr().out
    assert "moved" in shown
    assert "+3 %" in shown
    assert "new" in shown
    assert "b.json" in shown


def test_a_folder_that_is_not_there_has_no_earlier_run(tmp_path: Path) -> None:
    assert newest(tmp_path / "none") is None


def test_a_slower_machine_is_another_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    save(ALL, tmp_path)
    assert newest(tmp_path) is not None
    monkeypatch.setattr(results, "_processor", lambda: "abacus")
    assert newest(tmp_path) is None


def test_the_chart_has_a_line_for_each_program(tmp_path: Path) -> None:
    more = [faster(one, 0.5) for one in ALL]
    observed = Result("stepped, observed", "particle steps", 10_000, "gasbox", (1e7,), 1.0)
    figure = draw_rates([*ALL, *more, observed, FORCED, LAMMPS], "small print")
    exact, stepped, forced = figure.axes
    assert {line.get_label() for line in exact.lines} == {"gasbox, 0.6 filled", "plain loops, 0.6 filled"}
    styles = {str(line.get_label()).partition(",")[0]: line.get_linestyle() for line in exact.lines}
    assert styles == {"gasbox": "-", "plain loops": "--"}
    (line,) = stepped.lines
    assert list(line.get_ydata()) == [20.0, 10.0]
    assert {line.get_label() for line in forced.lines} == {"gasbox", "LAMMPS"}
    assert {axes.get_xscale() for axes in figure.axes} | {axes.get_yscale() for axes in figure.axes} == {
        "log"
    }
    assert "collisions" in exact.get_ylabel()
    assert "steps" in stepped.get_ylabel()
    path = save_chart(ALL, tmp_path / "rates.png")
    assert path.read_bytes().startswith(b"\x89PNG")
    with pytest.raises(FileError, match="cannot write"):
        save_chart(ALL, tmp_path / "none" / "rates.png")


def test_a_chart_of_nothing_is_empty() -> None:
    assert [len(axes.lines) for axes in draw_rates([]).axes] == [0, 0, 0]
