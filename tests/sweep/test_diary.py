"""Points are kept, found again, and the same however many workers there are."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import pytest

from gasbox.errors import FileError, UsageError
from gasbox.sweep import Diary, Point, Recipe, grid_points, measured

TINY = Recipe(particles=40, settle=5.0, measure=5.0)
POINTS = [(0.4, 0.1), (0.4, 0.8), (0.9, 0.1)]


def point(temperature: float = 0.4, density: float = 0.1) -> Point:
    return Point(temperature, density, 0.2, 0.7, 0.1, 0.5, 0.01, -1.5, "gas and liquid")


def test_points_are_found_again(tmp_path: Path) -> None:
    path = tmp_path / "kept.json"
    diary = Diary(path, TINY)
    diary.add(point(0.5))
    diary.add(point(0.4))
    again = Diary(path, TINY)
    assert again.points == [point(0.4), point(0.5)]
    assert again.missing([(0.4, 0.1), (0.4, 0.2)]) == [(0.4, 0.2)]
    assert [each.name for each in tmp_path.iterdir()] == ["kept.json"]


def test_points_of_another_kind_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "kept.json"
    Diary(path, TINY).add(point())
    with pytest.raises(UsageError, match="particles 40, not 50"):
        Diary(path, dataclasses.replace(TINY, particles=50))


@pytest.mark.parametrize(
    "text",
    ["no JSON", "[]", "{}", '{"format": "gasbox-phase-diagram/1"}', '{"format": "gasbox-scenario/1"}'],
)
def test_other_files_are_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    with pytest.raises(FileError, match=r"other\.json"):
        Diary(path, TINY)
    assert path.read_text() == text


@pytest.mark.parametrize(("key", "value"), [("matter", "porridge"), ("gas", float("nan")), ("colour", 3)])
def test_damaged_points_are_refused(tmp_path: Path, key: str, value: object) -> None:
    path = tmp_path / "kept.json"
    Diary(path, TINY).add(point())
    kept = json.loads(path.read_text())
    kept["points"][0][key] = value
    path.write_text(json.dumps(kept))
    with pytest.raises(FileError, match="damaged"):
        Diary(path, TINY)


def test_a_file_needs_a_folder(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no folder"):
        Diary(tmp_path / "nowhere" / "kept.json", TINY)


def test_grid() -> None:
    found = grid_points(3, 4)
    assert len(found) == len(set(found)) == 12
    assert found == sorted(found)
    assert [found[0], found[-1]] == [(0.32, 0.03), (0.6, 0.93)]


def test_workers_change_no_number() -> None:
    alone = sorted(measured(POINTS, TINY, 1), key=lambda one: (one.temperature, one.density))
    together = sorted(measured(POINTS, TINY, 3), key=lambda one: (one.temperature, one.density))
    assert alone == together
    assert [(one.temperature, one.density) for one in alone] == POINTS
