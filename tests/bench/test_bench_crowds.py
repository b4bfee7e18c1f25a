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
    for seed in range(3):
        scenario = parse({**said, "seed": seed})
        ours, theirs = SteppedGas(scenario), MesaCrowd(scenario)
        for gas in (ours, theirs):
            gas.work(60)
        ill = sum(agent.is_ill for agent in theirs._model.agents)
        infected.append([ours._simulation.world.summary()["final_size"], ill])
    mean, spread = np.mean(infected, axis=0), np.std(infected, axis=0)
    assert mean[0] > 250
    assert abs(mean[0] - mean[1]) < 4 * np.hypot(*spread) / 3**0.5 + 0.1 * mean[0]


def test_without_mesa_it_is_named(monkeypatch):
    monkeypatch.setattr("gasbox.bench.crowds.find_spec", lambda name: None)
    assert missing_crowd_peers() == ["mesa"]
    assert crowd_peers(crowd(20)) == []
