"""Our gases with somebody who measures: what looking costs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.bench.contest import OURS
from gasbox.bench.gases import collisions, let_mix
from gasbox.geometry import Geometry
from gasbox.observe import ContactLog, collision_rates, temperature, virial_pressure, wall_pressure
from gasbox.protocols import Observer
from gasbox.scenario import EventDriven, Scenario
from gasbox.simulation import Simulation
from gasbox.state import Contacts, State, Tallies

__all__ = ["Gauges", "ObservedGas", "observed_gases"]


def observed_gases(scenario: Scenario) -> list[ObservedGas]:
    """The same gas three times: nobody looks, gauges are read at each frame, every contact is logged."""
    geometry = scenario.geometry()
    radii = np.array([species.radius for species in scenario.species])
    return [
        ObservedGas(scenario, OURS),
        ObservedGas(scenario, f"{OURS}, pressure and rate", Gauges(geometry, radii)),
        ObservedGas(scenario, f"{OURS}, contact log", ContactLog(limit=1 << 40)),
    ]


class ObservedGas:
    """A gas that goes on frame by frame; a portion is a frame, the unit that of its dynamics."""

    def __init__(self, scenario: Scenario, name: str, observer: Observer | None = None) -> None:
        self.name = name
        self._simulation = Simulation(scenario, threads=1)
        self._exact = isinstance(scenario.dynamics, EventDriven)
        if self._exact:
            let_mix(self._simulation)
        self._observer = observer
        if observer is not None:
            self._simulation.attach(observer)

    def work(self, portions: int) -> float:
        """Collisions of pairs executed, or steps times particles."""
        simulation = self._simulation
        if self._observer is not None:
            # Afresh, lest a log outgrow the memory.
            self._observer.start(simulation.state, simulation.dynamics.tallies)
        before, begin = collisions(simulation), simulation.time
        simulation.advance(frames=portions)
        if self._exact:
            return collisions(simulation) - before
        return (simulation.time - begin) * simulation.state.count


class Gauges:
    """Reads pressure (at the walls; without walls, from the virial) and collision rate of each frame.

    Parameters
    ----------
    geometry : what the gas is in
    radii : (species,) float64 [length]

    Attributes
    ----------
    pressures : of each frame [mass/time²], None where there is none
    rates : collisions of pairs in each frame [1/time]
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, radii: NDArray[np.float64]) -> None:
        self._geometry, self._radii = geometry, radii

    def start(self, state: State, tallies: Tallies) -> None:
        """Note where the first frame begins."""
        self._time, self._tallies = state.time, tallies.copy()
        self._counts = np.bincount(state.species, minlength=self._radii.size)
        self.pressures: list[float | None] = []
        self.rates: list[float] = []

    def read(self, contacts: Contacts) -> None:
        """Not needed: the tallies say it all."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Measure the frame that ends now."""
        change, duration = tallies - self._tallies, state.time - self._time
        self._time, self._tallies = state.time, tallies.copy()
        self.pressures.append(self._pressure(state, change, duration))
        rates = collision_rates(change, duration)
        self.rates.append(rates.pairs if rates is not None else 0.0)

    def _pressure(self, state: State, change: Tallies, duration: float) -> float | None:
        if self._geometry.is_walled:
            return wall_pressure(change, self._geometry, self._radii, duration)
        heat = temperature(state, self._geometry)
        return virial_pressure(
            change, self._geometry, self._radii, self._counts, temperature=heat, duration=duration
        )
