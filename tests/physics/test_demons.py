"""What a demon does to a gas: rates at its gate, sorted speeds and species, a valve, and the second law with memory."""

import math

import numpy as np
import pytest

from gasbox.scenario import load, parse
from gasbox.simulation import Simulation
from gasbox.theory import walls
from gasbox.theory.demon import BIT, entropy_of_parts

COUNT, RADIUS, SIDE, SLIT = 2000, 0.05, 40.0, 4.0


def halves(rule, seed, **world):
    """Two square halves of a dilute gas, and a gate that is shorter than the way between two collisions."""
    low, high = (SIDE - SLIT) / 2, (SIDE + SLIT) / 2
    ends = {"divider below": (0, low), "gate": (low, high), "divider above": (high, SIDE)}
    return Simulation(
        parse(
            {
                "container": {"width": 2 * SIDE, "height": SIDE},
                "obstacles": [
                    {"shape": "segment", "name": name, "start": [SIDE, begin], "end": [SIDE, end]}
                    for name, (begin, end) in ends.items()
                ],
                "species": [{"name": "gas", "radius": RADIUS, "count": COUNT, "temperature": 1}],
                "frame_interval": 1.0,
                "seed": seed,
                "world": {"kind": "demon", "gate": "gate", "rule": rule, "interval": 1.0, **world},
            }
        )
    )


AREA = (SIDE - 2 * RADIUS) ** 2


def test_how_many_come_and_how_many_are_fast():
    threshold, duration = 1.2, 80.0
    passed, refused, expected = np.zeros(2), np.zeros(2), np.zeros(2)
    for seed in range(5):
        simulation = halves("speed", seed, threshold=threshold)
        count = simulation.world._census.total
        simulation.advance(until=duration)
        record = simulation.world.record
        passed, refused = passed + record.passed, refused + record.refused
        expected += [walls.effusion_rate(n, 1.0, 1.0, AREA, SLIT) * duration for n in count]
    came = passed + refused
    # Discs that touch the line of the gate; near its ends some of them touch the divider first.
    assert np.all(np.abs(came - expected) < 4 * np.sqrt(expected) + 0.03 * expected)
    fast = 1.0 - walls.effusing_speed_cdf(threshold, 1.0, 1.0)
    for let, share in ((passed[0] / came[0], fast), (passed[1] / came[1], 1.0 - fast)):
        # Both sides have drifted apart by some per cent in the end.
        assert abs(let - share) < 4 * math.sqrt(fast * (1.0 - fast) / came.min()) + 0.015


def test_a_valve_pumps_as_a_slit_leaks():
    # What is left behind leaks as into vacuum, and cools: nobody comes back.
    left, expected, warm = 0, 0.0, []
    for seed in range(3):
        simulation = halves("direction", 10 + seed)
        count, temperature = simulation.world._census.total[0], simulation.world._census.temperature[0]
        decay = walls.decay_time(1.0, temperature, AREA, SLIT, RADIUS)
        simulation.advance(until=300.0)
        side = simulation.world.view()["left"]
        remaining = walls.cooling_count(300.0, count, decay)
        left, expected = left + side["discs"], expected + remaining
        warm.append(side["temperature"] / walls.cooling_temperature(side["discs"], temperature, count))
    gone = 3 * COUNT / 2 - expected
    assert abs(left - expected) < 4 * math.sqrt(gone) + 0.03 * gone
    assert np.mean(warm) == pytest.approx(1.0, abs=4 / math.sqrt(left))


def test_an_open_gate_wins_nothing():
    # In balance counts and temperatures of two sides scatter, which costs half a k_B each in the mean.
    data = load("maxwells-demon")
    open_gate = data.world.model_copy(update={"rule": "none"})
    simulation = Simulation(data.model_copy(update={"seed": 5, "world": open_gate}))
    simulation.advance(until=2000.0)
    series, now = simulation.world.series(), simulation.world._census
    total = np.full((1, 2), now.total.sum() // 2)
    most = entropy_of_parts(total, now.area, np.full(2, now.mean_temperature))
    lost = series["entropy"] + simulation.world._start_entropy - most
    blocks = lost[: len(lost) // 20 * 20].reshape(20, -1).mean(axis=1)
    assert abs(blocks.mean() + 1.0) < 4 * blocks.std(ddof=1) / math.sqrt(20)
    assert lost.max() < 1e-9
    assert lost.min() > -14.0  # exp(-14) of the time it is less
    difference = series["temperature_right"] - series["temperature_left"]
    blocks = difference[: len(difference) // 20 * 20].reshape(20, -1).mean(axis=1)
    assert abs(blocks.mean()) < 4 * blocks.std(ddof=1) / math.sqrt(20)
    assert series["decisions"][-1] == 0
    assert simulation.world.record.passed.min() > 500


@pytest.mark.parametrize("name", ["maxwells-demon", "demon-sorting", "one-way-valve"])
def test_the_second_law_holds_with_the_memory(name):
    simulation = Simulation(load(name))
    energy = simulation.energy()
    simulation.advance(until=600.0)
    series, now = simulation.world.series(), simulation.world.view()
    assert abs(simulation.energy() - energy) <= 1e-12 * energy
    # A chance fluctuation may win a little before anything is written.
    assert series["balance"].min() > -2.0
    assert (series["entropy"] + series["information"]).min() > -2.0
    assert now["entropy_of_gas"] < -60.0
    assert now["heat_of_forgetting"] > now["work_stored"] > 60.0
    if name == "maxwells-demon":
        assert now["right"]["temperature"] > 3.0 * now["left"]["temperature"]
    if name == "one-way-valve":
        assert now["right"]["pressure"] > 10.0 * now["left"]["pressure"]


def test_a_mixture_that_is_sorted_gives_its_entropy_of_mixing():
    data = load("demon-sorting")
    few = [kind.model_copy(update={"count": 40}) for kind in data.species]
    simulation = Simulation(data.model_copy(update={"species": tuple(few), "seed": 4}))
    start = simulation.world._census
    simulation.advance(until=3000.0)
    now = simulation.world._census
    assert now.count.tolist() == [[40, 0], [0, 40]]
    # Temperatures scatter a little, as at the start: a few k_B at most.
    mixed = entropy_of_parts(np.full((2, 2), 20), start.area, np.full(2, start.mean_temperature))
    assert mixed - now.entropy == pytest.approx(80 * math.log(2), abs=5.0)
    view = simulation.world.view()
    assert view["information_written"] == BIT * view["decisions"]
    assert view["information"] > -view["entropy_of_gas"] > 70 * math.log(2)
