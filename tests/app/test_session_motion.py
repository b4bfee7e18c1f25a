"""Simulated time follows real time, within a budget, and says so when it cannot."""

from __future__ import annotations

import pytest
from free_flight import FakeClock, FreeFlight, gas

from gasbox.app.motion import BUDGET, Motion

pytestmark = pytest.mark.small


def play(motion: Motion, clock: FakeClock, seconds: float) -> None:
    end = clock.now + seconds
    while clock.now < end - 1e-9:
        clock.now += max(motion.beat(), 1e-6)


@pytest.mark.parametrize("speed", [0.1, 0.5, 1.0, 3.0, 100.0])
def test_sixty_frames_of_simulated_time_per_second(speed: float) -> None:
    clock = FakeClock()
    motion = Motion(FreeFlight(gas()), speed, clock)
    play(motion, clock, 2.0)
    wanted = 2.0 * 60 * speed * 0.5
    assert motion.simulation.time == pytest.approx(wanted, abs=60 * speed * 0.5 / 60 * 2)
    assert motion.keeping_up
    assert motion.speed_reached == pytest.approx(speed, rel=0.05)


def test_event_driven_moves_by_fractions_of_a_frame() -> None:
    clock = FakeClock()
    motion = Motion(FreeFlight(gas()), 0.1, clock)
    clock.now += 1 / 60
    motion.beat()
    assert motion.simulation.time == pytest.approx(0.05)


def test_stepped_moves_by_whole_steps_spread_over_the_ticks() -> None:
    clock = FakeClock()
    scenario = gas(dynamics={"kind": "stepped", "time_step": 0.5})
    motion = Motion(FreeFlight(scenario), 0.25, clock)
    moved = []
    for _ in range(40):
        clock.now += 1 / 60
        motion.beat()
        moved.append(motion.moved)
    assert motion.simulation.time == pytest.approx(10 * 0.5, abs=0.5)
    assert all(call == pytest.approx(0.5) for call in motion.simulation.calls)
    first = moved.index(True)
    assert [k for k, now in enumerate(moved) if now] == list(range(first, 40, 4))


def test_a_slow_engine_is_cut_to_the_budget_and_told() -> None:
    clock = FakeClock()
    # 60 frames of 0.5 would cost 3 s of each second
    motion = Motion(FreeFlight(gas(), clock, cost=0.1), 1.0, clock)
    for _ in range(200):
        begun = clock.now
        pause = motion.beat()
        assert clock.now - begun < 2 * BUDGET
        clock.now += pause
    assert not motion.keeping_up
    assert motion.speed_reached is not None
    assert 0.1 < motion.speed_reached < 0.4


def test_overhead_is_not_most_of_the_work() -> None:
    clock = FakeClock()
    # A call costs more than the budget whatever it is asked for, as with a million discs.
    motion = Motion(FreeFlight(gas(), clock, cost=0.1, overhead=0.015), 1.0, clock)
    motion.begin(1.0)
    started = clock.now
    for _ in range(200):
        begun = clock.now
        pause = motion.beat()
        assert clock.now - begun < 4 * BUDGET
        clock.now += pause
    useful = 0.1 * motion.simulation.time
    assert useful > 0.35 * (clock.now - started)
    assert not motion.keeping_up


def test_it_keeps_up_again_when_less_is_asked() -> None:
    clock = FakeClock()
    motion = Motion(FreeFlight(gas(), clock, cost=0.1), 1.0, clock)
    play(motion, clock, 2.0)
    motion.begin(0.1)
    play(motion, clock, 2.0)
    assert motion.keeping_up
    assert motion.speed_reached == pytest.approx(0.1, rel=0.1)


def test_a_pause_is_not_caught_up() -> None:
    clock = FakeClock()
    motion = Motion(FreeFlight(gas()), 1.0, clock)
    play(motion, clock, 0.5)
    before = motion.simulation.time
    clock.now += 100.0
    motion.begin(1.0)
    clock.now += 1 / 60
    motion.beat()
    assert motion.simulation.time - before == pytest.approx(0.5)


def test_a_stall_of_the_machine_counts_as_not_keeping_up() -> None:
    clock = FakeClock()
    motion = Motion(FreeFlight(gas()), 1.0, clock)
    play(motion, clock, 1.0)
    clock.now += 0.5
    motion.beat()
    assert not motion.keeping_up


def test_a_step_goes_to_the_next_whole_frame() -> None:
    clock = FakeClock()
    motion = Motion(FreeFlight(gas()), 0.5, clock)
    clock.now += 1 / 60
    motion.beat()
    motion.step()
    assert (motion.frame, motion.simulation.time) == (1, 0.5)
    motion.step()
    assert (motion.frame, motion.simulation.time) == (2, 1.0)
