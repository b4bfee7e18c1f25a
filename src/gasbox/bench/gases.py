"""Our engines as contenders, fast and plain."""

from __future__ import annotations

from functools import lru_cache

from gasbox.bench.contest import OURS, PLAIN
from gasbox.bench.plain.event_driven import PlainEventDriven
from gasbox.bench.plain.stepped import PlainStepped
from gasbox.bench.scenarios import fluid
from gasbox.initial import populate
from gasbox.scenario import Forced, Particles, Scenario, Stepped
from gasbox.simulation import Simulation
from gasbox.state import State

__all__ = [
    "EventDrivenGas",
    "ForcedGas",
    "PlainEventDrivenGas",
    "PlainSteppedGas",
    "SteppedGas",
    "collisions",
    "let_mix",
    "melted",
    "standing",
]

_PORTION = 10
"""Collisions in a portion of the event-driven gases, more or less."""
_MELTING = 5.0
"""Time [time] after which a fluid has forgotten its start: the energy of a disc is steady after 2."""


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


@lru_cache(1)
def melted(particles: int) -> Scenario:
    """The fluid as it is after a while at its temperature, to go on from without a thermostat, by whoever it is."""
    simulation = Simulation(fluid(particles, thermostat=True))
    simulation.advance(until=_MELTING)
    return standing(fluid(particles), simulation.state)


def standing(scenario: Scenario, state: State) -> Scenario:
    """A scenario of one species with its discs where those of `state` are."""
    (species,) = scenario.species
    listed = Particles.of([species.name] * state.count, state.position, state.velocity)
    emptied = species.model_copy(update={"count": 0})
    return scenario.model_copy(update={"species": (emptied,), "particles": listed})


class ForcedGas:
    """Our dynamics with forces; a portion is a time step, the unit is a step of one particle."""

    def __init__(self, scenario: Scenario, threads: int = 1) -> None:
        assert isinstance(scenario.dynamics, Forced)
        self.name = OURS if threads == 1 else f"{OURS}, {threads} threads"
        self._simulation = Simulation(scenario, threads=threads)
        self._time_step = scenario.dynamics.time_step
        self._steps = 0

    def work(self, portions: int) -> float:
        """Steps times particles."""
        self._steps += portions
        self._simulation.advance(until=self._steps * self._time_step)
        return float(portions * self._simulation.state.count)
