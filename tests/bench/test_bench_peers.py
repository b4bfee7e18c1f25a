from __future__ import annotations

import sys

import numpy as np
import pytest

from gasbox.bench import missing_peers, peers
from gasbox.bench.gases import EventDrivenGas, PlainEventDrivenGas, PlainSteppedGas, SteppedGas
from gasbox.bench.observed import Gauges, observed_gases
from gasbox.bench.peers import ArrayGas, Box2DGas, PymunkGas, ReboundGas, stepped_peers
from gasbox.bench.scenarios import exact_gas, mixture, stepped_gas
from gasbox.simulation import Simulation

FEW = 200


def test_all_stepped_gases_do_what_is_asked() -> None:
    pytest.importorskip("pymunk")
    scenario = stepped_gas(FEW)
    gases = [SteppedGas(scenario), PlainSteppedGas(scenario), *stepped_peers(scenario)]
    assert {gas.work(3) for gas in gases} == {3 * FEW}


def test_peers_that_are_not_installed_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(peers, "missing_fluid_peers", lambda: ["mpich"])
    for package in ("pyb2d3", "rebound"):
        monkeypatch.setitem(sys.modules, package, None)
    assert missing_peers() == ["pyb2d3", "rebound", "mpich"]
    names = [gas.name for gas in stepped_peers(stepped_gas(4))]
    assert names == ["pymunk", "NumPy + k-d tree"]


def kinetic(gas: object) -> float:
    """Energy of a gas of mass 1 in the engine of a peer, in units of the scenario."""
    match gas:
        case PymunkGas():
            velocities = [body.velocity for body in gas._space.bodies]
        case Box2DGas():
            velocities = [body.linear_velocity for body in gas._bodies]
            velocities = [(x * gas._STEP, y * gas._STEP) for x, y in velocities]
        case ReboundGas():
            velocities = gas._rows[:, 3:6]
        case ArrayGas():
            velocities = gas._state.velocity
    return 0.5 * float(np.sum(np.square(velocities)))


@pytest.mark.parametrize(
    ("package", "gas", "lost"),
    [
        ("pymunk", PymunkGas, 0.01),
        ("pyb2d3", Box2DGas, 0.2),
        ("rebound", ReboundGas, 1e-9),
        ("scipy", ArrayGas, 0.2),
    ],
)
def test_peers_play_the_same_game(package: str, gas: type, lost: float) -> None:
    # Elastic discs between walls: energy stays, exactly in REBOUND. The others push overlaps apart, or solve several
    # contacts at once, and lose some; if a wall were missing, or restitution below 1, they would lose half and more.
    pytest.importorskip(package)
    scenario = stepped_gas(FEW)
    peer = gas(scenario)
    begin = kinetic(peer)
    assert begin == pytest.approx(FEW * 0.1**2 / 2, rel=1e-6)
    peer.work(500)
    assert kinetic(peer) == pytest.approx(begin, rel=lost)


def test_rebound_stays_in_the_plane_and_in_the_box() -> None:
    pytest.importorskip("rebound")
    peer = ReboundGas(stepped_gas(FEW))
    peer.work(800)
    x, y, z = peer._rows[:, :3].T
    assert peer._gas.collisions_log_n > FEW
    # Turned round in the step after which it is beyond the wall; the fastest of 200 moves 0.4 in a step.
    assert np.abs([x, y]).max() < peer._reach.max() + 0.5
    assert np.all(z == 0)


def test_the_plain_gas_goes_on_from_ours() -> None:
    ours = EventDrivenGas(exact_gas(FEW, 0.3))
    plain = PlainEventDrivenGas(ours)
    assert ours.work(5) == plain.work(5) > 0


@pytest.mark.parametrize("ratio", [1, 10])
def test_mixtures_have_half_of_the_area_each(ratio: int) -> None:
    scenario = mixture(1000, ratio, 0.3)
    small, large = (species.count * species.radius**2 for species in scenario.species)
    assert small == large
    box = scenario.container.geometry()
    assert np.pi * (small + large) == pytest.approx(0.3 * box.area)
    assert scenario.species[1].mass == pytest.approx(ratio**2)


@pytest.mark.parametrize("scenario", [exact_gas(100, 0.3), stepped_gas(100)], ids=["exact", "stepped"])
def test_observed_gases_do_the_same_work(scenario) -> None:  # type: ignore[no-untyped-def]
    gases = observed_gases(scenario)
    assert [gas.name for gas in gases] == ["gasbox", "gasbox, pressure and rate", "gasbox, contact log"]
    assert len({gas.work(20) for gas in gases}) == 1


def test_gauges_read_each_frame() -> None:
    scenario = stepped_gas(100)
    gauges = Gauges(scenario.container.geometry(), np.ones(1))
    simulation = Simulation(scenario, [gauges])
    simulation.advance(frames=20)
    total = simulation.dynamics.tallies.pair_collisions.sum()
    assert np.sum(gauges.rates) * simulation.frame_interval == pytest.approx(total)
    assert np.mean(np.array(gauges.pressures, float)) == pytest.approx(simulation.pressure())
