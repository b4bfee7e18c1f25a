"""What `gasbox bench` measures."""

from __future__ import annotations

from collections.abc import Callable

from gasbox.bench.contest import Result, contest
from gasbox.bench.gases import EventDrivenGas, SteppedGas, exact_gas, stepped_gas
from gasbox.bench.peers import stepped_peers

__all__ = ["AREA_FRACTIONS", "SIZES", "measure"]

SIZES = (1_000, 10_000, 100_000)
AREA_FRACTIONS = (0.05, 0.3, 0.6)
_QUICK_SIZES = SIZES[:2]
_ROUNDS, _SECONDS = 5, 0.5
_QUICK_ROUNDS, _QUICK_SECONDS = 3, 0.1


def measure(
    quick: bool = False, tell: Callable[[str], None] = lambda line: None, sizes: tuple[int, ...] | None = None
) -> list[Result]:
    """All rates: the exact dynamics dilute and dense, and the stepped one beside its peers.

    Parameters
    ----------
    quick : small sizes and short rounds
    tell : called with the name of each task as it begins
    sizes : numbers of particles; None takes `SIZES`
    """
    rounds, seconds = (_QUICK_ROUNDS, _QUICK_SECONDS) if quick else (_ROUNDS, _SECONDS)
    results: list[Result] = []
    for particles in sizes or (_QUICK_SIZES if quick else SIZES):
        for fraction in AREA_FRACTIONS:
            task = f"event-driven, {fraction:g}"
            tell(f"{task} of the area filled, {particles} particles")
            ours = EventDrivenGas(exact_gas(particles, fraction))
            results += contest(task, "collisions", particles, [ours], rounds, seconds)
        scenario = stepped_gas(particles)
        task = "stepped, 0.2"
        tell(f"{task} of the area filled, {particles} particles")
        gases = [SteppedGas(scenario), *stepped_peers(scenario)]
        results += contest(task, "particle steps", particles, gases, rounds, seconds)
    return sorted(results, key=lambda result: result.task)
