"""What a run came to, as plain numbers: the summary that the command line prints."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gasbox import observe
from gasbox.geometry import Geometry
from gasbox.protocols import Dynamics, Warns, World
from gasbox.scenario import Forced, Scenario, Stepped, Walk
from gasbox.state import State, Tallies
from gasbox.version import __version__

__all__ = ["mean_geometry", "radii", "summary", "walls"]


class Run(Protocol):
    """What a summary needs to know of a `Simulation`."""

    scenario: Scenario
    state: State
    geometry: Geometry
    dynamics: Dynamics
    frame: int
    start_time: float
    start_tallies: Tallies
    mean_displacement: observe.MeanDisplacement
    wall_seconds: float
    warnings: tuple[str, ...]

    @property
    def world(self) -> World | None:
        """As `Simulation.world`."""
        ...

    def temperature(self) -> float | None:
        """As `Simulation.temperature`."""
        ...

    def pressure(self) -> float | None:
        """As `Simulation.pressure`."""
        ...

    def energy(self) -> float:
        """As `Simulation.energy`."""
        ...

    def momentum(self) -> tuple[float, float]:
        """As `Simulation.momentum`."""
        ...


def radii(scenario: Scenario) -> NDArray[np.float64]:
    """(kinds,) float64 [length]: how far each kind of particle keeps its centre from a wall, on average."""
    return np.array([kind.half_width for kind in scenario.kinds], np.float64)


def summary(simulation: Run) -> dict[str, Any]:
    """Numbers of a run so far; those measured in time belong to this run alone. None where there is no value."""
    state, geometry = simulation.state, simulation.geometry
    change = simulation.dynamics.tallies - simulation.start_tallies
    duration = simulation.state.time - simulation.start_time
    here = mean_geometry(simulation)
    collisions = int(change.pair_collisions.sum())
    seconds = simulation.wall_seconds
    size = radii(simulation.scenario)
    counts = np.bincount(state.species, minlength=size.size)
    flight = observe.translational_temperature(state, geometry)
    means = np.array([observe.mean_speed(state, k) or 0.0 for k in range(size.size)])
    return {
        "time": simulation.state.time,
        "frames": simulation.frame,
        "particles": state.count,
        "collisions": collisions,
        "wall_collisions": int(change.wall_collisions.sum()),
        "energy": simulation.energy(),
        "potential_energy": observe.potential_energy(state, geometry),
        "internal_energy": observe.internal_energy(state, geometry),
        "rest_energy": float(change.rest_energy[0]),
        "momentum": list(simulation.momentum()),
        "temperature": simulation.temperature(),
        **_temperatures(simulation),
        "pressure": simulation.pressure(),
        "pressure_virial": observe.virial_pressure(
            change, here, size, counts, temperature=flight, duration=duration
        ),
        "collision_rates": _rates(change, duration),
        "mean_free_path": observe.mean_free_path(change, counts, means, duration),
        "walls": walls(simulation, change, here, duration),
        "left": _left(simulation, change),
        "species": [_species(simulation, k, int(counts[k])) for k in range(size.size)],
        **({} if simulation.world is None else {"world": simulation.world.summary()}),
        "wall_seconds": seconds,
        "collisions_per_second": collisions / seconds if seconds > 0 else None,
        "particle_steps_per_second": _particle_steps(simulation, duration) if seconds > 0 else None,
        "warnings": _warnings(simulation),
        "version": __version__,
        "scenario_hash": simulation.scenario.hash(),
    }


def _warnings(simulation: Run) -> list[str]:
    """What was to be said at the start, and what its dynamics has noticed since."""
    dynamics = simulation.dynamics
    return [*simulation.warnings, *(dynamics.warnings() if isinstance(dynamics, Warns) else ())]


def mean_geometry(simulation: Run) -> Geometry:
    """The geometry with its walls where they were on average over this run."""
    place, last = simulation.mean_displacement.value(), simulation.state.wall_displacement
    return simulation.geometry.at(place if place.shape == last.shape else last)


def walls(simulation: Run, change: Tallies, here: Geometry, duration: float) -> list[dict[str, Any]]:
    """What each wall felt and did during this run; sides that are periodic are left out."""
    size = radii(simulation.scenario)
    pressure = observe.wall_pressures(change, here, size, duration)
    error = observe.wall_pressure_errors(change, here, size, duration)
    return [
        {
            "name": name,
            "pressure": _number(pressure[k]),
            "pressure_error": _number(error[k]),
            "collisions": int(change.wall_collisions[k].sum()),
            "work": float(change.wall_work[k].sum()),
            "heat": float(change.wall_heat[k].sum()),
            "passed": {
                species.name: {"forward": int(ways[0]), "backward": int(ways[1])}
                for species, ways in zip(simulation.scenario.kinds, change.wall_passed[k], strict=True)
            },
            "carried": float(change.wall_carried[k].sum()),
        }
        for k, name in enumerate(here.wall_names)
        if not _is_periodic(here, k)
    ]


def _left(simulation: Run, change: Tallies) -> dict[str, int]:
    """Species -> how many discs left the gas during this run."""
    geometry = simulation.geometry
    open_walls = [k for k, wall in enumerate(getattr(geometry, "walls", ())) if wall.open]
    gone = change.wall_passed[open_walls].sum(axis=(0, 2))
    names = (species.name for species in simulation.scenario.kinds)
    return {name: int(count) for name, count in zip(names, gone, strict=True)}


def _is_periodic(geometry: Geometry, wall: int) -> bool:
    """Whether a wall is a side that does not exist; only rectangles have such."""
    return wall < 4 and bool(geometry.periodic[wall // 2])


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _rates(change: Tallies, duration: float) -> dict[str, Any] | None:
    rates = observe.collision_rates(change, duration)
    if rates is None:
        return None
    return {"pairs": rates.pairs, "walls": rates.walls, "per_pair": rates.per_pair.tolist()}


def _temperatures(simulation: Run, species: int | None = None) -> dict[str, float | None]:
    """Where there are molecules, the temperatures of their motions, of all or of one kind."""
    state, geometry = simulation.state, simulation.geometry
    if not simulation.scenario.molecules:
        return {}
    flight = (
        observe.translational_temperature(state, geometry)
        if species is None
        else observe.species_temperature(state, geometry, species)
    )
    return {
        "temperature_translational": flight,
        "temperature_rotational": observe.rotational_temperature(state, geometry, species),
        "temperature_vibrational": observe.vibrational_temperature(state, species),
    }


def _species(simulation: Run, k: int, count: int) -> dict[str, Any]:
    state, geometry = simulation.state, simulation.geometry
    center = observe.center_of_mass(state, geometry, k)
    return {
        "name": simulation.scenario.kinds[k].name,
        "count": count,
        "temperature": observe.species_temperature(state, geometry, k),
        **_temperatures(simulation, k),
        "mean_speed": observe.mean_speed(state, k),
        "rms_speed": observe.rms_speed(state, k),
        "center_of_mass": None if center is None else center.tolist(),
    }


def _particle_steps(simulation: Run, duration: float) -> float | None:
    dynamics = simulation.scenario.dynamics
    if not isinstance(dynamics, Stepped | Forced | Walk):
        return None
    return round(duration / dynamics.time_step) * simulation.state.count / simulation.wall_seconds
