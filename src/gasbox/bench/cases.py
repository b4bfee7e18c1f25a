"""What `gasbox bench` measures."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from gasbox.bench.contest import OURS, Contender, Result, contest
from gasbox.bench.crowds import crowd_peers
from gasbox.bench.fluids import fluid_peers
from gasbox.bench.gases import (
    EventDrivenGas,
    ForcedGas,
    PlainEventDrivenGas,
    PlainSteppedGas,
    SteppedGas,
    melted,
)
from gasbox.bench.observed import observed_gases
from gasbox.bench.peers import pymunk_gas, stepped_peers
from gasbox.bench.scenarios import ENCLOSURES, crowd, dumbbells, enclosed, exact_gas, mixture, stepped_gas
from gasbox.dynamics.team import processors
from gasbox.scenario import EventDriven, Scenario

__all__ = ["AREA_FRACTIONS", "SIZES", "SIZE_RATIOS", "measure"]

SIZES = (1_000, 10_000, 100_000, 1_000_000)
AREA_FRACTIONS = (0.05, 0.3, 0.6)
SIZE_RATIOS = (10, 50)
_STEPPED_FRACTION = 0.2
_SAMPLE = 10_000
"""Discs where it is not their number that matters."""
_PEERS_UP_TO = 100_000
"""Beyond it, setting up the peers alone would take longer than all the rest."""
_THREADS_FROM = 10_000
"""Below it, two threads would mostly wait for each other."""
_FORCED = {1: "forced", 2: "forced, two threads"}
"""Tasks by the number of threads of ours, or of ranks of LAMMPS."""
_QUICK_SIZES = SIZES[:2]
_ROUNDS, _SECONDS = 5, 0.5
_QUICK_ROUNDS, _QUICK_SECONDS = 3, 0.15


class _Task(NamedTuple):
    """A contest before it begins: what is done and counted, and a call that sets up who takes part."""

    name: str
    unit: str
    particles: int
    contenders: Callable[[], list[Contender]]


def measure(
    quick: bool = False,
    tell: Callable[[str], None] = lambda line: None,
    sizes: tuple[int, ...] | None = None,
    sample: int = _SAMPLE,
) -> Iterator[list[Result]]:
    """All rates, task by task: engines over density and number beside plain loops and peers, mixtures, observers.

    Parameters
    ----------
    quick : small sizes and short rounds
    tell : called with the name of each task as it begins
    sizes : numbers of particles; None takes `SIZES`
    sample : number of particles of mixtures and of observed gases
    """
    rounds, seconds = (_QUICK_ROUNDS, _QUICK_SECONDS) if quick else (_ROUNDS, _SECONDS)
    tasks = _scans(sizes or (_QUICK_SIZES if quick else SIZES)) + _samples(sample)
    for task in sorted(tasks, key=lambda task: task.particles):
        tell(f"{task.name}: {task.particles:,} discs")
        yield contest(task.name, task.unit, task.particles, task.contenders(), rounds, seconds)


def _scans(sizes: tuple[int, ...]) -> list[_Task]:
    """All engines, over number and density."""
    exact = [
        _Task(f"event-driven, {fraction:g}", "collisions", particles, partial(_exact, particles, fraction))
        for fraction in AREA_FRACTIONS
        for particles in sizes
    ]
    name, unit = f"stepped, {_STEPPED_FRACTION:g}", "particle steps"
    stepped = [_Task(name, unit, particles, partial(_stepped, particles)) for particles in sizes]
    forced = [
        _Task(_FORCED[threads], unit, particles, partial(_forced, particles, threads))
        for particles in sizes
        if particles <= _PEERS_UP_TO
        for threads in (1, 2)[: processors()]
    ]
    return exact + stepped + forced


def _samples(sample: int) -> list[_Task]:
    """What mixtures and walls cost, molecules, and what looking does."""
    exact, stepped = exact_gas(sample, 0.3), stepped_gas(sample)
    return [
        _Task("event-driven, mixture", "collisions", sample, partial(_mixtures, sample)),
        _Task("event-driven, enclosed", "collisions", sample, partial(_enclosed, exact)),
        _Task("stepped, enclosed", "particle steps", sample, partial(_enclosed, stepped)),
        _Task("dumbbells, stepped", "particle steps", sample, partial(_hard_dumbbells, sample)),
        _Task("dumbbells, forced", "particle steps", sample, partial(_soft_dumbbells, sample)),
        _Task("epidemic", "person steps", sample, partial(_epidemic, sample)),
        _Task("event-driven, observed", "collisions", sample, partial(_observed, exact)),
        _Task("stepped, observed", "particle steps", sample, partial(_observed, stepped)),
    ]


def _exact(particles: int, fraction: float) -> list[Contender]:
    ours = EventDrivenGas(exact_gas(particles, fraction))
    return [ours, PlainEventDrivenGas(ours)]


def _stepped(particles: int) -> list[Contender]:
    scenario = stepped_gas(particles, _STEPPED_FRACTION)
    gases: list[Contender] = [SteppedGas(scenario)]
    if particles >= _THREADS_FROM and processors() > 1:
        gases.append(SteppedGas(scenario, threads=2))
    gases.append(PlainSteppedGas(scenario))
    return gases + (stepped_peers(scenario) if particles <= _PEERS_UP_TO else [])


def _forced(particles: int, threads: int) -> list[Contender]:
    scenario = melted(particles)
    return [ForcedGas(scenario, threads), *fluid_peers(scenario, threads)]


def _hard_dumbbells(molecules: int) -> list[Contender]:
    scenario = dumbbells(molecules, "stepped")
    return [SteppedGas(scenario), *pymunk_gas(scenario)]


def _soft_dumbbells(molecules: int) -> list[Contender]:
    return [ForcedGas(dumbbells(molecules, "forced"))]


def _epidemic(people: int) -> list[Contender]:
    scenario = crowd(people)
    return [SteppedGas(scenario), *crowd_peers(scenario)]


def _mixtures(small: int) -> list[Contender]:
    """One size, then mixtures with half of the area each, all at an area fraction of 0.3."""
    mixed = [EventDrivenGas(mixture(small, ratio, 0.3), f"gasbox, sizes 1:{ratio}") for ratio in SIZE_RATIOS]
    return [EventDrivenGas(exact_gas(small, 0.3)), *mixed]


def _enclosed(scenario: Scenario) -> list[Contender]:
    """Between the walls of a rectangle, then of other shapes, under gravity, and with a piston."""
    gases: list[Contender] = []
    for what in ENCLOSURES:
        inside = enclosed(scenario, what)
        name = OURS if what == ENCLOSURES[0] else f"{OURS}, {what}"
        exact = isinstance(scenario.dynamics, EventDriven)
        gases.append(EventDrivenGas(inside, name) if exact else SteppedGas(inside, name=name))
    return gases


def _observed(scenario: Scenario) -> list[Contender]:
    return [*observed_gases(scenario)]
