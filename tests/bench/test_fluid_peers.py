"""LAMMPS, and OpenMM where it is installed, compute the fluid that we compute."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from gasbox.bench import fluids, lammps_ranks, missing_peers
from gasbox.bench.fluids import OpenMMGas, fluid_peers, missing_fluid_peers
from gasbox.bench.gases import ForcedGas, melted
from gasbox.bench.lammps_gas import LammpsGas, lammps_starts
from gasbox.bench.lammps_rank import Lammps, of_mpich
from gasbox.bench.lammps_ranks import LammpsRanks, ranks_start
from gasbox.initial import populate
from gasbox.scenario import Scenario

FEW = 300


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    return melted(FEW)


@pytest.fixture
def lammps() -> None:
    if not lammps_starts():
        pytest.skip("LAMMPS is not installed")


def apart(one: NDArray[np.float64], other: NDArray[np.float64], scenario: Scenario) -> float:
    """Largest distance [length] of the same disc in two gases."""
    size = scenario.geometry().size
    difference = one - other
    difference -= size * np.rint(difference / size)
    return float(np.abs(difference).max())


def test_melted_at_its_temperature(scenario: Scenario) -> None:
    state = populate(scenario)
    # The energy of 2N velocities varies by 1/sqrt(N).
    assert 0.5 * np.mean(state.velocity**2) * 2 == pytest.approx(1.0, abs=4 / np.sqrt(FEW))
    assert np.abs(state.velocity.mean(axis=0)).max() < 1e-12


def test_lammps_chooses_a_list_that_is_never_late(lammps: None, scenario: Scenario) -> None:
    peer = LammpsGas(scenario)
    assert peer.work(500) == 500 * FEW
    assert peer.late_lists() == 0
    assert peer.skin >= 0.2


def test_lammps_goes_the_same_way(lammps: None, scenario: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(LammpsGas, "_fastest_list", lambda self: (0.3, 0))
    peer, ours = LammpsGas(scenario), ForcedGas(scenario)
    peer.work(50)
    ours.work(50)
    assert isinstance(peer.program, Lammps)
    assert apart(peer.program.rows("x"), ours._simulation.state.position, scenario) < 1e-9


def test_two_ranks_do_the_same_work(
    lammps: None, scenario: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not ranks_start():
        pytest.skip("mpiexec does not start")
    # Ranks wait for each other in a busy loop: on a busy machine the trial of lists would take minutes.
    monkeypatch.setattr(LammpsGas, "_fastest_list", lambda self: (0.3, 0))
    peer = LammpsGas(scenario, ranks=2)
    assert peer.name == "LAMMPS, 2 ranks"
    assert peer.work(5) == 5 * FEW
    assert peer.late_lists() == 0
    assert isinstance(peer.program, LammpsRanks)
    assert peer.program.ranks() == 2
    peer.program.close()


def test_ranks_that_do_not_start_are_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(lammps_ranks, "of_mpich", lambda name: None)
    with pytest.raises(OSError, match="no mpiexec"):
        LammpsRanks(2)
    broken = tmp_path / "mpiexec"
    broken.write_text("#!/bin/sh\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(lammps_ranks, "of_mpich", lambda name: broken)
    with pytest.raises(OSError, match="do not start"):
        LammpsRanks(2)
    assert of_mpich("no such file") is None


def test_who_is_missing_is_named(scenario: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fluids, "find_spec", lambda name: None)
    monkeypatch.setattr(fluids, "lammps_starts", lambda: True)
    monkeypatch.setattr(fluids, "ranks_start", lambda: False)
    assert missing_fluid_peers() == ["mpich"]
    assert fluid_peers(scenario, threads=2) == []
    monkeypatch.setattr(fluids, "lammps_starts", lambda: False)
    assert missing_fluid_peers() == ["lammps"]
    assert fluid_peers(scenario, threads=1) == []
    assert "lammps" in missing_peers()


def test_openmm_goes_the_same_way(scenario: Scenario) -> None:
    pytest.importorskip("openmm")
    peer, ours = OpenMMGas(scenario), ForcedGas(scenario)
    assert peer.work(20) == ours.work(20) == 20 * FEW
    where = peer.context.getState(getPositions=True).getPositions(asNumpy=True)
    # Its velocities are half a step older; in 20 steps that moves a disc by less than its own step.
    assert apart(np.asarray(where)[:, :2], ours._simulation.state.position, scenario) < 0.2
    assert np.all(np.asarray(where)[:, 2] == 0)
