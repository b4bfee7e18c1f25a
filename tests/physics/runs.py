"""Runs for the tests of the physics: gases by area fraction, in units of mass 1, diameter 1, temperature 1."""

import math
from dataclasses import dataclass

import numpy as np

from gasbox import observe
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.state import Tallies
from gasbox.theory import Mixture, kinetic

RADIUS = 0.5


def gas(species, eta, *, periodic=True, seed=1, dynamics=None):
    """A square box filled to `eta` with species given as dictionaries (radius 1/2 and temperature 1 if not given)."""
    whole = [{"radius": RADIUS, **({} if "speed" in one else {"temperature": 1.0}), **one} for one in species]
    side = math.sqrt(sum(one["count"] * math.pi * one["radius"] ** 2 for one in whole) / eta)
    return Simulation(
        parse(
            {
                "format": "gasbox-scenario/1",
                "seed": seed,
                "container": {
                    "shape": "rectangle",
                    "width": side,
                    "height": side,
                    "periodic": ["x", "y"] if periodic else [],
                },
                "species": [{"name": f"species {i}", **one} for i, one in enumerate(whole)],
                "dynamics": dynamics or {"kind": "event-driven"},
                "frame_interval": 1.0,
            }
        )
    )


def one_gas(count, eta, **options):
    """Equal discs."""
    return gas([{"count": count}], eta, **options)


def theory_of(simulation):
    """The same gas, as theory sees it."""
    species = simulation.scenario.species
    count = np.bincount(simulation.state.species, minlength=len(species))
    return Mixture.of(count, [s.mass for s in species], [s.radius for s in species], simulation.geometry.area)


def time_for(simulation, collisions):
    """Time in which the gas has about this many pair collisions."""
    return collisions / kinetic.pair_rates(theory_of(simulation), simulation.temperature(), "henderson").sum()


def settle(simulation, per_particle=15):
    """Let each particle collide that often."""
    simulation.advance(
        until=simulation.time + time_for(simulation, 0.5 * per_particle * simulation.state.count)
    )


@dataclass
class Measured:
    """What a stretch of a run gave."""

    simulation: Simulation
    change: Tallies
    duration: float

    @property
    def counts(self):
        return theory_of(self.simulation).count.astype(int)

    @property
    def radii(self):
        return theory_of(self.simulation).radius

    @property
    def collisions(self):
        return int(self.change.pair_collisions.sum())

    @property
    def virial_pressure(self):
        return observe.virial_pressure(
            self.change,
            self.simulation.geometry,
            self.radii,
            self.counts,
            temperature=self.simulation.temperature(),
            duration=self.duration,
        )

    @property
    def wall_pressure(self):
        return observe.wall_pressure(self.change, self.simulation.geometry, self.radii, self.duration)

    @property
    def compressibility(self):
        """Z by the virial, at the area that centres can reach."""
        area = observe.common_accessible_area(self.simulation.geometry, self.radii, self.counts)
        return self.virial_pressure * area / (self.simulation.state.count * self.simulation.temperature())


def measure(simulation, collisions):
    """Run for about this many pair collisions and return what was added to the tallies."""
    before, begin = simulation.dynamics.tallies.copy(), simulation.time
    simulation.advance(until=begin + time_for(simulation, collisions))
    return Measured(simulation, simulation.dynamics.tallies - before, simulation.time - begin)


def distance(values, law):
    """Kolmogorov's distance between a sample and a distribution function."""
    ordered = np.sort(values)
    below = law(ordered)
    steps = np.arange(ordered.size + 1) / ordered.size
    return float(max(np.max(steps[1:] - below), np.max(below - steps[:-1])))


def critical(number):
    """Distance that a sample of independent values exceeds once in a thousand times."""
    return 1.95 / math.sqrt(number)
