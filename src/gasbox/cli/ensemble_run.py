"""The loop over the seeds of an ensemble, with its progress and interruption."""

from __future__ import annotations

import sys
import time as clock
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass

from gasbox.cli.progress import Progress, compile_first
from gasbox.cli.report import warn
from gasbox.cli.source import Changes, from_scenario
from gasbox.dynamics.team import processors
from gasbox.errors import UsageError
from gasbox.simulation import Simulation
from gasbox.sweep import Failure, Gathered, Member, Plan, ensemble, gathered, plan_for

__all__ = ["Outcome", "prepare", "travel_all"]

_SEEDS = 2**63
_PATIENCE = 5
"""So many failures before any success end the whole; and no more than so many are told one by one."""


@dataclass(frozen=True)
class Outcome:
    """How an ensemble ended.

    Attributes
    ----------
    wanted : how many runs were asked for
    found : those that came to their end
    failures : those that did not, by seed
    interrupted : by Ctrl-C
    wall_seconds : that all of it took
    """

    wanted: int
    found: Gathered
    failures: Sequence[Failure]
    interrupted: bool
    wall_seconds: float


def prepare(
    name: str, settings: Sequence[str], seeds: int, first_seed: int, until: float | None, frames: int | None
) -> Plan:
    """How each run goes. The first of them is built here: what is wrong with the scenario shows before any work.

    Raises
    ------
    GasboxError
        Whatever makes the runs impossible.
    """
    if first_seed + seeds > _SEEDS:
        raise UsageError(f"the last seed is {first_seed + seeds - 1}; it must lie below 2^63")
    if any(text.partition("=")[0].strip() == "seed" for text in settings):
        raise UsageError("--set seed: here the seeds are chosen by --first-seed and --seeds")
    if (until is None) == (frames is None):
        raise UsageError("say how far to run: either --until TIME or --frames N")
    source = from_scenario(name, Changes(settings, first_seed))
    compile_first()
    simulation = Simulation(source.scenario, threads=1)
    warn(simulation.warnings)
    return plan_for(simulation, until, frames)


def travel_all(plan: Plan, seeds: Sequence[int], workers: int | None) -> Outcome:
    """Run all seeds; those that fail are named on standard error and left out.

    Raises
    ------
    UsageError, DynamicsError
        The first ones all fail.
    """
    members: list[Member] = []
    failures: list[Failure] = []
    interrupted, begin = False, clock.perf_counter()
    try:
        with (
            Progress(0, len(seeds), "run", per_second=True) as progress,
            closing(ensemble(plan, seeds, workers or processors())) as found,
        ):
            progress.show(0)
            for one in found:
                if isinstance(one, Member):
                    members.append(one)
                else:
                    failures.append(one)
                    if not members and len(failures) >= min(_PATIENCE, len(seeds)):
                        raise min(failures, key=lambda failure: failure.seed).error()
                progress.show(len(members) + len(failures))
    except KeyboardInterrupt:
        interrupted = True
    failures.sort(key=lambda failure: failure.seed)
    seconds = clock.perf_counter() - begin
    outcome = Outcome(len(seeds), gathered(members, plan.times), failures, interrupted, seconds)
    _say(outcome)
    return outcome


def _say(outcome: Outcome) -> None:
    """On standard error: whatever did not go as it should."""
    done = outcome.found.seeds.size
    for failure in outcome.failures[:_PATIENCE]:
        print(f"Error: {failure.error()}", file=sys.stderr)
    if len(outcome.failures) > _PATIENCE:
        print(f"Error: {len(outcome.failures)} runs failed in all.", file=sys.stderr)
    if outcome.interrupted:
        print(f"Interrupted: {done} of {outcome.wanted} runs are done.", file=sys.stderr)
    elif done > 1 and outcome.found.is_always_the_same:
        print("Note: all runs are the same; nothing in this scenario depends on the seed.", file=sys.stderr)
