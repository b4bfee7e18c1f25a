"""One point of a phase diagram: discs at one temperature and density, from a crystal on, and what becomes of them."""

from __future__ import annotations

import math
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final

import numpy as np

from gasbox import observe
from gasbox.scenario import Scenario, parse
from gasbox.simulation import Simulation
from gasbox.sweep.crew import Stopped, done_together
from gasbox.sweep.grid import Recipe
from gasbox.sweep.verdict import Matter, unevenness, verdict

__all__ = ["Point", "measure", "measured", "scenario_at"]

_TIME_STEP: Final = 0.01
_FRAME: Final = 2.5
"""Time between two looks at the discs [time]."""
_NEAR: Final = 1.5
_LOOSE: Final = 1.12
"""Distance of neighbours in the crystal of the start [length], where there is room for it."""
_ROOM: Final = 0.94
"""Share of the box that such a crystal fills at most: one without a surface overheats."""
_THIN: Final = 0.3
"""Density [1/length²] below which a drop gets more time to evaporate, as much as the box is larger."""
_CLOSER: Final = 0.995
"""Factor by which the distance is made smaller until all discs have room."""


@dataclass(frozen=True)
class Point:
    """What was found at one temperature and density.

    Attributes
    ----------
    temperature, density : of the point [energy], [1/length²]
    gas, liquid, solid : shares of discs, means over time
    uneven : the unevenness, mean over time
    pressure : mean over time [mass/time²]
    potential : of each disc [energy]
    matter : what it is
    """

    temperature: float
    density: float
    gas: float
    liquid: float
    solid: float
    uneven: float
    pressure: float
    potential: float
    matter: Matter


def scenario_at(temperature: float, density: float, recipe: Recipe) -> Scenario:
    """A crystal of all discs in a periodic square of this density, held at this temperature [energy]."""
    side = math.sqrt(recipe.particles / density)
    disc = {
        "name": "atoms",
        "radius": 0.5,
        "count": recipe.particles,
        "temperature": temperature,
        "lattice": _spacing(side, recipe.particles),
    }
    return parse(
        {
            "seed": recipe.seed,
            "container": {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"]},
            "species": [disc],
            "dynamics": {"kind": "forced", "time_step": _TIME_STEP},
            "forces": {"law": "lennard-jones", "cutoff": recipe.cutoff, "truncation": "shifted"},
            "thermostat": {"kind": "velocity-rescaling", "temperature": temperature},
            "frame_interval": _FRAME,
        }
    )


def measured(
    points: Sequence[tuple[float, float]], recipe: Recipe, workers: int = 1
) -> Generator[Point, None, None]:
    """Each point as it gets done, in any order. Closing the iterator stops all work.

    Parameters
    ----------
    points : (temperature [energy], density [1/length²])
    workers : processes; with one, everything happens in this one
    """
    for found in done_together(partial(_measure, recipe), points, min(workers, len(points))):
        assert found is not None
        yield found


def _measure(recipe: Recipe, place: tuple[float, float], stopped: Stopped) -> Point | None:
    return measure(*place, recipe, stopped)


def measure(
    temperature: float, density: float, recipe: Recipe, stopped: Stopped = lambda: False
) -> Point | None:
    """Run one point on one thread.

    Parameters
    ----------
    stopped : asked often; once it says so, the run is given up and None returned
    """
    simulation = Simulation(scenario_at(temperature, density, recipe), threads=1)
    # Until a drop has evaporated into a large box takes long.
    patience = max(1.0, _THIN / density)
    for _ in range(max(round(recipe.settle * patience / _FRAME), 1)):
        if stopped():
            return None
        simulation.advance(frames=1)
    begin, since = simulation.dynamics.tallies.copy(), simulation.time
    rows = []
    for _ in range(max(round(recipe.measure / _FRAME), 1)):
        if stopped():
            return None
        simulation.advance(frames=1)
        state = simulation.frame_view().state
        shares = observe.phase_shares(observe.phases(state, simulation.geometry, _NEAR))
        rows.append((*shares, unevenness(state.position, simulation.geometry.size)))
    end, duration = simulation.dynamics.tallies, simulation.time - since
    kinetic = float(np.sum(end.kinetic_time - begin.kinetic_time))
    virial = float(np.sum(end.pair_virial - begin.pair_virial))
    potential = float(np.sum(end.potential_time - begin.potential_time))
    gas, liquid, solid, uneven = (float(value) for value in np.mean(rows, axis=0))
    return Point(
        temperature=temperature,
        density=density,
        gas=gas,
        liquid=liquid,
        solid=solid,
        uneven=uneven,
        pressure=(kinetic + 0.5 * virial) / (simulation.geometry.area * duration),
        potential=potential / (recipe.particles * duration),
        matter=verdict(gas, solid, uneven, recipe.particles),
    )


def _spacing(side: float, count: int) -> float:
    """Distance of neighbours [length] at which so many discs have room in a periodic square, and a little is left."""
    spacing = min(_LOOSE, side * math.sqrt(_ROOM * 2.0 / (math.sqrt(3.0) * count)))
    while _places(side, spacing) < count:
        spacing *= _CLOSER
    return spacing


def _places(side: float, spacing: float) -> int:
    """Sites of whole columns and whole pairs of rows."""
    columns, rows = int(side / spacing), int(side / (spacing * math.sqrt(3.0)))
    return columns * 2 * rows
