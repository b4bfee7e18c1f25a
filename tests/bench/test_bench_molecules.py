"""The dumbbells of the bench."""

from __future__ import annotations

import pytest

from gasbox.bench.molecules import PymunkDumbbells, dumbbells, hard_dumbbells, soft_dumbbells
from gasbox.observe import kinetic_energy
from gasbox.simulation import Simulation

FEW = 100


def test_all_do_what_is_asked() -> None:
    pytest.importorskip("pymunk")
    assert [gas.work(3) for gas in hard_dumbbells(FEW)] == [3 * FEW, 3 * FEW]
    assert [gas.work(3) for gas in soft_dumbbells(FEW)] == [3 * FEW]


def test_pymunk_plays_the_same_game() -> None:
    """The same energy, of rotation too, at the start; and later, but for what its solver loses."""
    pytest.importorskip("pymunk")
    scenario = dumbbells(FEW, "stepped")
    theirs = PymunkDumbbells(scenario)
    start = kinetic_energy(Simulation(scenario).state)
    assert theirs.energy() == pytest.approx(start, rel=1e-12)
    theirs.work(200)
    assert theirs.energy() == pytest.approx(start, rel=0.1)
