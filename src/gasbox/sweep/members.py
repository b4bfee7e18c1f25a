"""One scenario with many seeds: the numbers of each run, and what its world counts over time."""

from __future__ import annotations

import time as clock
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import DynamicsError, GasboxError, UsageError
from gasbox.scenario import Scenario
from gasbox.simulation import Simulation
from gasbox.sweep.crew import Stopped, done_together
from gasbox.sweep.numbers import numbers

__all__ = ["Failure", "Member", "Plan", "ensemble", "plan_for"]

_TIMES: Final = 201
"""Moments at which series of different runs are compared."""
_PIECE: Final = 20
"""Of these moments a gas without a world is halted only at every so many, to see whether anybody still waits."""
_TASK: Final = 0.3
"""Seconds that a task for a worker should take: long beside what it costs to hand it over, short for who watches."""
_MOST: Final = 200
"""Seeds in one task."""


@dataclass(frozen=True, eq=False)
class Plan:
    """How each run goes.

    Attributes
    ----------
    scenario : whose seed is replaced
    times : (k,) float64 [time], from the start to the end, at which series are read
    """

    scenario: Scenario
    times: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Member:
    """What became of one seed.

    Attributes
    ----------
    seed : of this run
    numbers : path -> value; nan where there is none
    series : name -> (k,) float64, at the times of the plan; empty without a world that counts
    """

    seed: int
    numbers: dict[str, float]
    series: dict[str, NDArray[np.float64]]


@dataclass(frozen=True)
class Failure:
    """A seed whose run could not be finished, and why; `refused` if it was the scenario's fault."""

    seed: int
    reason: str
    refused: bool

    def error(self) -> GasboxError:
        """As an error to raise."""
        sentence = f"the run with seed {self.seed} failed: {self.reason}"
        return UsageError(sentence) if self.refused else DynamicsError(sentence)


def plan_for(simulation: Simulation, until: float | None = None, frames: int | None = None) -> Plan:
    """How all runs go, if `simulation` is the first of them: so far, or so many of its frames.

    Raises
    ------
    UsageError
        Neither or both was said, or there is nothing to run.
    """
    if (until is None) == (frames is None):
        raise UsageError("say how far to run: either --until TIME or --frames N")
    if simulation.scenario.snapshot is not None:
        raise UsageError(
            "this is a snapshot, in which the gas is set already: a seed would not make another one"
        )
    start = simulation.time
    end = start + (frames or 0) * simulation.frame_interval if until is None else until
    if not start < end < np.inf:
        raise UsageError(f"the end is at time {end:g}; it must lie beyond the start, at {start:g}")
    return Plan(simulation.scenario, np.linspace(start, end, _TIMES))


def ensemble(plan: Plan, seeds: Sequence[int], workers: int = 1) -> Generator[Member | Failure, None, None]:
    """What became of each seed, as it gets done, in any order. Closing the iterator stops all work.

    Parameters
    ----------
    workers : processes; with one, everything happens in this one. They change no number
    """
    pace = _Pace()
    tasks = _tasks(seeds, min(workers, len(seeds)), pace)
    for seconds, done in done_together(partial(_several, plan), tasks, min(workers, len(seeds))):
        pace.seen(len(done), seconds)
        yield from done


class _Pace:
    """How many seeds make a task of the right length: one, until a run was seen."""

    def __init__(self) -> None:
        self.runs, self.seconds = 0, 0.0

    def seen(self, runs: int, seconds: float) -> None:
        self.runs, self.seconds = self.runs + runs, self.seconds + seconds

    def size(self) -> int:
        if not self.runs or self.seconds <= 0.0:
            return 1
        return max(1, min(_MOST, round(_TASK * self.runs / self.seconds)))


def _tasks(seeds: Sequence[int], workers: int, pace: _Pace) -> Iterator[Sequence[int]]:
    """The seeds in order, some at a time; towards the end fewer, so that all workers have something to do."""
    done = 0
    while done < len(seeds):
        size = min(pace.size(), -(-(len(seeds) - done) // (2 * workers)))
        yield seeds[done : done + size]
        done += size


def _several(plan: Plan, seeds: Sequence[int], stopped: Stopped) -> tuple[float, list[Member | Failure]]:
    """Seconds that these runs took, and what became of them."""
    begin = clock.perf_counter()
    done: list[Member | Failure] = []
    for seed in seeds:
        try:
            member = _one(plan, seed, stopped)
        except GasboxError as error:
            done.append(Failure(seed, str(error), not isinstance(error, DynamicsError)))
            continue
        if member is None:
            break
        done.append(member)
    return clock.perf_counter() - begin, done


def _one(plan: Plan, seed: int, stopped: Stopped) -> Member | None:
    """Run one seed on one thread; None if it was given up."""
    simulation = Simulation(plan.scenario.model_copy(update={"seed": seed}), threads=1)
    world = simulation.world
    piece = _PIECE if world is None else 1
    for time in plan.times[piece::piece]:
        if stopped():
            return None
        if getattr(world, "done", False):
            # Nothing more will happen in this world.
            break
        simulation.advance(until=float(time))
    series = {} if world is None else world.series()
    when = series.get("time")
    counted = (
        {}
        if when is None or not when.size
        else {name: np.interp(plan.times, when, values) for name, values in series.items() if name != "time"}
    )
    return Member(seed, numbers(simulation.summary()), counted)
