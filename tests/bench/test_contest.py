from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

from gasbox.bench import contest, measure, print_table, save
from gasbox.bench.gases import SteppedGas, stepped_gas
from gasbox.bench.peers import stepped_peers
from gasbox.errors import FileError


class Clockwork:
    """Does one unit in each `pace` seconds."""

    def __init__(self, name: str, pace: float) -> None:
        self.name, self._pace = name, pace
        self.turns: list[str] = []

    def work(self, portions: int) -> float:
        self.turns.append(self.name)
        time.sleep(portions * self._pace)
        return portions


def test_rates_are_amounts_over_time_and_ratios_are_to_the_first() -> None:
    fast, slow = Clockwork("fast", 0.001), Clockwork("slow", 0.004)
    results = contest("task", "units", 2, [fast, slow], rounds=3, seconds=0.02)
    assert [result.program for result in results] == ["fast", "slow"]
    assert all(len(result.rates) == 3 for result in results)
    # A sleep is never shorter than asked for; how much longer depends on the machine.
    assert max(results[0].rates) <= 1000
    assert max(results[1].rates) <= 250
    assert results[0].ratio == 1
    assert results[1].ratio > 1


def test_they_take_turns() -> None:
    shared: list[str] = []
    contenders = [Clockwork("a", 0.001), Clockwork("b", 0.001)]
    for contender in contenders:
        contender.turns = shared
    contest("task", "units", 2, contenders, rounds=2, seconds=0.0005)
    assert shared == ["a", "b"] * 3


def test_all_stepped_gases_start_alike_and_do_what_is_asked() -> None:
    scenario = stepped_gas(200)
    gases = [SteppedGas(scenario), *stepped_peers(scenario)]
    assert [gas.name for gas in gases] == ["gasbox", "pymunk", "NumPy + k-d tree"]
    assert {gas.work(3) for gas in gases} == {600}


@pytest.mark.parametrize("folder", [True, False])
def test_everything_is_measured_shown_and_kept(
    tmp_path: Path, folder: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    results = measure(quick=True, sizes=(100,))
    print_table(results)
    shown = capsys.readouterr().out
    assert all(result.program in shown and result.task in shown for result in results)
    path = save(results, tmp_path if folder else tmp_path / "mine.json")
    kept = json.loads(path.read_text())
    assert len(kept["rates"]) == len(results) == 6
    assert kept["machine"]["cores"] >= 1
    assert {"gasbox", "python", "numpy", "numba"} <= kept["versions"].keys()
    assert all(row["median"] > 0 for row in kept["rates"])
    with pytest.raises(FileError, match="cannot write"):
        save(results, tmp_path / "none" / "x.json")
