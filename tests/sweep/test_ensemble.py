"""One scenario with many seeds: the same numbers on any number of workers, and the same as single runs."""

import math

import numpy as np
import pytest

from gasbox.errors import UsageError
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.sweep import Failure, Member, ensemble, gathered, plan_for, spread
from gasbox.sweep.numbers import numbers


def gas(count=20, **more):
    return parse(
        {
            "container": {"width": 12, "height": 9},
            "species": [{"name": "gas", "radius": 0.3, "count": count, "temperature": 1}],
            "frame_interval": 0.5,
            **more,
        }
    )


def plan(until=4.0, **more):
    return plan_for(Simulation(gas(**more)), until=until)


def same(one, other):
    return one.seed == other.seed and np.array_equal(
        list(one.numbers.values()), list(other.numbers.values()), True
    )


def test_workers_change_no_number():
    alone, two = ({each.seed: each for each in ensemble(plan(), range(6), workers)} for workers in (1, 2))
    assert sorted(alone) == sorted(two) == list(range(6))
    assert all(same(alone[seed], two[seed]) for seed in alone)
    assert len({each.numbers["collisions"] for each in alone.values()}) > 2


def test_each_run_is_that_of_its_seed():
    (member,) = ensemble(plan(), [7])
    single = Simulation(gas(seed=7))
    single.advance(until=4.0)
    wanted = numbers(single.summary())
    assert wanted["collisions"] > 0
    np.testing.assert_array_equal(list(member.numbers.values()), list(wanted.values()))


def test_frames_are_those_of_the_first_run():
    first = Simulation(gas())
    assert plan_for(first, frames=6).times[-1] == 3.0
    with pytest.raises(UsageError, match="how far"):
        plan_for(first)
    with pytest.raises(UsageError, match="beyond the start"):
        plan_for(first, until=0.0)
    with pytest.raises(UsageError, match="beyond the start"):
        plan_for(first, until=math.inf)
    with pytest.raises(UsageError, match="a snapshot"):
        plan_for(Simulation(first.snapshot()), until=1.0)


def test_a_run_that_fails_leaves_the_others_alone(monkeypatch):
    class Crowded(Simulation):
        def __init__(self, scenario, **more):
            if scenario.seed == 2:
                raise UsageError("no room")
            super().__init__(scenario, **more)

    how = plan()
    monkeypatch.setattr("gasbox.sweep.members.Simulation", Crowded, raising=True)
    found = list(ensemble(how, range(4)))
    assert [each.seed for each in found] == [0, 1, 2, 3]
    assert [isinstance(each, Failure) for each in found] == [False, False, True, False]
    assert str(found[2].error()) == "the run with seed 2 failed: no room"
    assert isinstance(found[2].error(), UsageError)


class Waiting:
    """Counts turns, and has enough of it at some time, another one for each seed."""

    interval, reads_contacts = 0.5, False

    def __init__(self, end):
        self.end, self.times = end, [0.0]

    def start(self, state, geometry):
        return []

    def act(self, state, geometry):
        self.times.append(state.time)
        return []

    @property
    def done(self):
        return self.times[-1] >= self.end

    def summary(self):
        return {"turns": len(self.times) - 1, "over": self.done, "name": "waiting"}

    def series(self):
        return {"time": np.array(self.times), "turns": np.arange(len(self.times), dtype=np.float64)}


def test_a_world_that_is_done_ends_its_run_and_its_last_values_stay(monkeypatch):
    def with_world(scenario, threads):
        return Simulation(scenario, threads=threads, world=Waiting(1.0 + scenario.seed))

    how = plan()
    monkeypatch.setattr("gasbox.sweep.members.Simulation", with_world)
    members = list(ensemble(how, range(3)))
    assert [each.numbers["world.turns"] for each in members] == [2, 4, 6]
    assert [each.numbers["world.over"] for each in members] == [1, 1, 1]
    assert "world.name" not in members[0].numbers
    for each in members:
        assert 1.0 + each.seed <= each.numbers["time"] < 1.03 + each.seed
        expected = np.minimum(2.0 * how.times, each.numbers["world.turns"])
        np.testing.assert_allclose(each.series["turns"], expected)


def test_runs_stand_in_the_order_of_their_seeds():
    times = np.array([0.0, 1.0])
    members = [
        Member(5, {"a": 1.0, "b": math.nan}, {"n": np.array([0.0, 2.0])}),
        Member(3, {"a": 2.0}, {}),
    ]
    found = gathered(members, times)
    assert found.seeds.tolist() == [3, 5]
    assert found.values["a"].tolist() == [2.0, 1.0]
    np.testing.assert_array_equal(found.values["b"], [np.nan, np.nan])
    np.testing.assert_array_equal(found.series["n"], [[np.nan, np.nan], [0.0, 2.0]])
    assert not found.is_always_the_same
    assert gathered(members[:1], times).is_always_the_same


def test_spread_is_that_of_the_values_that_there_are():
    told = spread(np.array([1.0, 2.0, 3.0, 4.0, np.nan]))
    assert (told.runs, told.mean, told.least, told.greatest, told.median) == (4, 2.5, 1.0, 4.0, 2.5)
    assert told.standard_deviation == pytest.approx(math.sqrt(5 / 3))
    assert told.standard_error == pytest.approx(math.sqrt(5 / 3) / 2)
    assert (told.low, told.high) == pytest.approx((1.15, 3.85))
    assert math.isnan(spread(np.array([7.0])).standard_deviation)
    assert spread(np.array([np.nan])).runs == 0


def test_numbers_have_paths():
    summary = {
        "time": 2,
        "frames": 9,
        "momentum": [1.0, -1.0],
        "pressure": None,
        "species": [{"name": "light", "count": 3}],
        "world": {"over": True, "score": {"left": 1}},
        "version": "1",
    }
    found = numbers(summary)
    assert math.isnan(found.pop("pressure"))
    assert found == {
        "time": 2.0,
        "momentum.0": 1.0,
        "momentum.1": -1.0,
        "species.light.count": 3.0,
        "world.over": 1.0,
        "world.score.left": 1.0,
    }
