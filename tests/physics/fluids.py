"""Runs for the tests of forces: fluids in units of epsilon = sigma = mass = 1, and what a stretch of a run gave."""

import math
from dataclasses import dataclass

import numpy as np

from gasbox import observe
from gasbox.scenario import parse
from gasbox.simulation import Simulation

TIME_STEP = 0.005
WRITTEN = 10
"""Steps between two entries in the time integrals of energy and virial."""


def fluid(count, density, temperature, *, forces=None, time_step=TIME_STEP, seed=1, box=None, **more):
    """Discs of one species, in a square periodic box of this density unless `box` (width, height) is given."""
    width, height = box or (math.sqrt(count / density),) * 2
    atom = {"name": "atom", "radius": 0.5, "count": count, "temperature": temperature}
    if more.get("lattice"):
        atom["lattice"] = more["lattice"]
    return run_of([atom], (width, height), forces, time_step, seed, **{**more, "lattice": None})


def run_of(species, box, forces=None, time_step=TIME_STEP, seed=1, periodic=("x", "y"), **more):
    """A simulation of these species in a rectangle."""
    width, height = box
    sections = {name: value for name, value in more.items() if value is not None}
    return Simulation(
        parse(
            {
                "format": "gasbox-scenario/1",
                "seed": seed,
                "container": {
                    "shape": "rectangle",
                    "width": width,
                    "height": height,
                    "periodic": list(periodic),
                },
                "species": species,
                "dynamics": {"kind": "forced", "time_step": time_step},
                **({"forces": forces} if forces else {}),
                **sections,
            }
        ),
        threads=1,
    )


def crystal(count, density, temperature, **more):
    """A whole triangular lattice of count = rows² discs, rows even, in a periodic box that it fills."""
    rows = math.isqrt(count)
    assert rows * rows == count
    assert rows % 2 == 0
    spacing = math.sqrt(2.0 / (math.sqrt(3.0) * density))
    box = (rows * spacing, rows * spacing * math.sqrt(0.75))
    return fluid(count, None, temperature, box=box, lattice=spacing, **more)


def rescaling(temperature, time=1.0):
    """Section of a scenario."""
    return {"kind": "velocity-rescaling", "temperature": temperature, "time": time}


def langevin(temperature, time=1.0):
    """Section of a scenario."""
    return {"kind": "langevin", "temperature": temperature, "time": time}


@dataclass
class Mean:
    """A mean and its standard error, from blocks."""

    value: float
    error: float

    @classmethod
    def of(cls, samples):
        samples = np.asarray(samples, float)
        return cls(float(samples.mean()), float(observe.block_error(samples)))

    def agrees(self, expected, uncertain=0.0, allowance=0.0, sigmas=4.0):
        """Whether it is `expected` (itself uncertain by a standard error), but for statistics and an allowance.

        Both are printed, for those who run the tests with -s.
        """
        print(f"{self.value:.5f} +- {self.error:.5f}, expected {expected:.5f} +- {uncertain:.5f}")
        return abs(self.value - expected) <= allowance + sigmas * math.hypot(self.error, uncertain)


@dataclass
class Course:
    """Means over equal stretches of a run; arrays over the stretches.

    Attributes
    ----------
    potential, virial : of each disc [energy]
    temperature : 2K/f
    pressure : N T/A and the virial [energy/length²]
    area : [length²]
    """

    potential: np.ndarray
    virial: np.ndarray
    temperature: np.ndarray
    pressure: np.ndarray
    area: np.ndarray


def course(simulation, duration, stretches=128):
    """Go on for about this time, in so many stretches of a whole number of entries each."""
    step = simulation.scenario.dynamics.time_step
    each = max(1, round(duration / stretches / (WRITTEN * step))) * WRITTEN * step
    count = simulation.state.count
    freedom = observe.degrees_of_freedom(count, simulation.geometry)
    begin, rows = simulation.time, []
    for turn in range(stretches):
        before = simulation.dynamics.tallies.copy()
        simulation.advance(until=begin + (turn + 1) * each)
        change = simulation.dynamics.tallies - before
        kinetic, potential, virial, area = (
            float(entry[0]) / each
            for entry in (change.kinetic_time, change.potential_time, change.pair_virial, change.area_time)
        )
        temperature = 2.0 * kinetic / freedom
        rows.append(
            (
                potential / count,
                virial / count,
                temperature,
                (count * temperature + 0.5 * virial) / area,
                area,
            )
        )
    return Course(*np.array(rows).T)
