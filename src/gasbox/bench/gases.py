"""Our engines as contenders, fast and plain."""

from __future__ import annotations

from gasbox.bench.contest import OURS, PLAIN
from gasbox.bench.plain.event_driven import PlainEventDriven
from gasbox.bench.plain.stepped import PlainStepped
from gasbox.initial import populate
from gasbox.scenario import Scenario, Stepped
from gasbox.simulation import Simulation

__all__ = ["EventDrivenGas", "PlainEventDrivenGas", "PlainSteppedGas", "SteppedGas", "collisions", "let_mix"]

_PORTION = 10
"""Collisions in a portion of the event-driven gases, more or less."""


def collisions(simulation: Simulation) -> int:
    """Collisions of pairs so far."""
    return int(simulation.dynamics.tallies.pair_collisions.sum())


def let_mix(simulation: Simulation) -> None:
    """Let an event-driven gas forget its start: 20 collisions a disc, fewer beyond 5 * 10^4 discs, but at least 5."""
    discs = simulation.state.count
    wanted = max(5 * discs // 2, min(10 * discs, 500_000))
    while collisions(simulation) < wanted:
        simulation.advance(until=simulation.time + 0.25)


class EventDrivenGas:
    """Our exact dynamics; a portion is some ten collisions, the unit is a collision."""

    def __init__(self, scenario: Scenario, name: str = OURS) -> None:
        self.name = name
        self.simulation = Simulation(scenario)
        let_mix(self.simulation)
        self.portion = self.simulation.time / collisions(self.simulation) * _PORTION
        """Simulated time of a portion [time]."""

    def work(self, portions: int) -> float:
        """Collisions of pairs executed."""
        before = collisions(self.simulation)
        self.simulation.advance(until=self.simulation.time + portions * self.portion)
        return collisions(self.simulation) - before


class PlainEventDrivenGas:
    """The plain engine, which goes on from where a gas of ours is now."""

    name = PLAIN

    def __init__(self, ours: EventDrivenGas) -> None:
        simulation = ours.simulation
        state, width = simulation.state, simulation.geometry.width
        self._engine = PlainEventDriven(state.position, state.velocity, width, 2.0 * float(state.radius[0]))
        self._portion = ours.portion

    def work(self, portions: int) -> float:
        """Collisions of pairs executed."""
        before = self._engine.collisions
        self._engine.advance(self._engine.time + portions * self._portion)
        return self._engine.collisions - before


class SteppedGas:
    """Our classroom rule; a portion is a step, the unit is a step of one particle."""

    def __init__(self, scenario: Scenario, threads: int = 1, name: str | None = None) -> None:
        self.name = name or (OURS if threads == 1 else f"{OURS}, {threads} threads")
        self._simulation = Simulation(scenario, threads=threads)

    def work(self, portions: int) -> float:
        """Steps times particles."""
        self._simulation.advance(until=self._simulation.time + portions)
        return portions * self._simulation.state.count


class PlainSteppedGas:
    """The plain engine with the same rule, from the same start."""

    name = PLAIN

    def __init__(self, scenario: Scenario) -> None:
        assert isinstance(scenario.dynamics, Stepped)
        state, size = populate(scenario), scenario.geometry().size
        radius, time_step = float(state.radius[0]), scenario.dynamics.time_step
        self._engine = PlainStepped(state.position, state.velocity, size, radius, time_step)

    def work(self, portions: int) -> float:
        """Steps times particles."""
        self._engine.step(portions)
        return float(portions * self._engine.position.shape[0])
