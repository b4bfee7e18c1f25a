"""The gases that rates are measured on, as scenarios, and ours as contenders."""

from __future__ import annotations

import math

from gasbox.bench.contest import OURS
from gasbox.scenario import Scenario, parse
from gasbox.simulation import Simulation

__all__ = ["EventDrivenGas", "SteppedGas", "exact_gas", "stepped_gas"]

_SEED = 12


def exact_gas(particles: int, area_fraction: float) -> Scenario:
    """Equal discs of diameter, mass and temperature 1 in a periodic square, event-driven."""
    side = math.sqrt(particles * math.pi / 4 / area_fraction)
    return parse(
        {
            "seed": _SEED,
            "container": {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"]},
            "species": [{"name": "discs", "radius": 0.5, "count": particles, "temperature": 1}],
            "dynamics": {"kind": "event-driven"},
        }
    )


def stepped_gas(particles: int, area_fraction: float = 0.2, speed: float = 0.1) -> Scenario:
    """Equal discs of radius and mass 1 between walls; each moves `speed` [length] in a step on average."""
    side = math.sqrt(particles * math.pi / area_fraction)
    return parse(
        {
            "seed": _SEED,
            "container": {"shape": "rectangle", "width": side, "height": side},
            # The rms speed is sqrt(2 T/m).
            "species": [{"name": "discs", "radius": 1, "count": particles, "temperature": speed**2 / 2}],
            "dynamics": {"kind": "stepped", "time_step": 1},
        }
    )


class EventDrivenGas:
    """Our exact dynamics; a portion is some ten collisions, the unit is a collision."""

    name = OURS

    def __init__(self, scenario: Scenario) -> None:
        self._simulation = Simulation(scenario)
        self._portion = self._time_of(10)

    def work(self, portions: int) -> float:
        """Collisions of pairs executed."""
        before = self._collisions()
        self._simulation.advance(until=self._simulation.time + portions * self._portion)
        return self._collisions() - before

    def _collisions(self) -> int:
        return int(self._simulation.dynamics.tallies.pair_collisions.sum())

    def _time_of(self, collisions: int) -> float:
        """Simulated time that a number of collisions take; the gas leaves its lattice on the way."""
        wanted = max(collisions, 5 * self._simulation.state.count)
        while self._collisions() < wanted:
            self._simulation.advance(until=self._simulation.time + 0.25)
        return self._simulation.time * collisions / self._collisions()


class SteppedGas:
    """Our classroom rule; a portion is a step, the unit is a step of one particle."""

    name = OURS

    def __init__(self, scenario: Scenario) -> None:
        self._simulation = Simulation(scenario)

    def work(self, portions: int) -> float:
        """Steps times particles."""
        self._simulation.advance(until=self._simulation.time + portions)
        return portions * self._simulation.state.count
