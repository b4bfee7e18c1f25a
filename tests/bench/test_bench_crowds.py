"""The peer that people are measured against plays the same game."""

import numpy as np
import pytest

from gasbox.bench.crowds import MesaCrowd, crowd_peers, missing_crowd_peers
from gasbox.bench.gases import SteppedGas
from gasbox.bench.scenarios import crowd
from gasbox.scenario import parse


def test_both_do_what_is_asked():
    pytest.importorskip("mesa")
    scenario = crowd(200)
    assert {gas.work(3) for gas in (SteppedGas(scenario), *crowd_peers(scenario))} == {600}


def test_mesa_infects_as_many():
    pytest.importorskip("mesa")
    said = crowd(1000).to_dict()
    said["world"]["transmission"]["probability_per_day"] = 0.2
    infected = []
    for seed in range(8):
        scenario = parse({**said, "seed": seed})
        ours, theirs = SteppedGas(scenario), MesaCrowd(scenario)
        for gas in (ours, theirs):
            gas.work(60)
        ill = sum(agent.is_ill for agent in theirs._model.agents)
        infected.append([ours._simulation.world.summary()["final_size"], ill])
    mean, error = np.mean(infected, axis=0), np.std(infected, axis=0, ddof=1) / 8**0.5
    assert mean[0] > 250
    # Of k infectious people nearby one escapes Mesa with 0.99^k in a step, us with exp(-0.01 k), half a percent more
    # often, and in Mesa one may infect in the very step in which one falls ill: all that is less than these errors.
    assert abs(mean[0] - mean[1]) < 4 * np.hypot(*error)


def test_without_mesa_it_is_named(monkeypatch):
    monkeypatch.setattr("gasbox.bench.crowds.find_spec", lambda name: None)
    assert missing_crowd_peers() == ["mesa"]
    assert crowd_peers(crowd(20)) == []
