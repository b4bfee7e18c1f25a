"""Whether the section of a snapshot fits its gas."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

import numpy as np

from gasbox.errors import Problem
from gasbox.scenario.particles import Particles
from gasbox.scenario.problems import short
from gasbox.scenario.snapshot import Snapshot
from gasbox.state import Tallies

__all__ = ["snapshot_problems"]

_MOST: Final = 2**62
"""Counts stay below, so that they can go on counting in 64 bits."""
_OF_WALL: Final = 8
"""Numbers by which the motion of a wall is remembered."""
_COUNTS: Final = frozenset({"epoch", "step", "forced_step", "walk_step"})
"""Whole numbers."""
_OF_BATHS: Final = 13
"""Numbers by which thermostat, barostat and heating are remembered."""
_SUMS: Final = frozenset({"wall_impulse", "wall_carried"})
"""What never falls; work and heat go both ways."""
_LATER: Final = frozenset(
    {
        *("wall_work", "wall_heat", "wall_passed", "wall_carried", "rest_energy"),
        *("kinetic_time", "potential_time", "area_time", "measured_time"),
        *("thermostat_heat", "heater_heat", "barostat_work", "rotational_time", "vibrational_time"),
    }
)
"""Sums that older snapshots do not have yet; they start from zero."""


def snapshot_problems(
    snapshot: Snapshot, particles: Particles | None, discs: Mapping[str, int], walls: int
) -> Iterator[Problem]:
    """What does not fit, for a scenario with so many discs in each kind of particle, and so many walls."""
    if particles is None:
        yield Problem("particles", "nothing", "a snapshot needs its particles")
        return
    yield from _tallies(snapshot.tallies, len(discs), walls)
    sizes = np.array([discs.get(name, 1) for name in particles.names], np.int64)
    yield from _memory(snapshot.memory, particles.count, int(sizes[particles.index].sum()), walls)


def _tallies(tallies: dict[str, Any], species: int, walls: int) -> Iterator[Problem]:
    expected = vars(Tallies.zero(species, walls))
    for name in tallies.keys() - expected.keys():
        path = f"snapshot.tallies.{short(name, bare=True)}"
        yield Problem(path, "an unknown key", f"known: {', '.join(expected)}")
    for name, array in expected.items():
        path = f"snapshot.tallies.{name}"
        if name not in tallies and name in _LATER:
            continue
        if name not in tallies:
            yield Problem(path, "nothing", "is required")
            continue
        found = np.asarray(tallies[name])
        counts = array.dtype.kind == "i"
        if found.shape != array.shape:
            yield Problem(path, f"the shape {list(found.shape)}", f"must have the shape {list(array.shape)}")
        elif counts and (found.dtype.kind != "i" or (found < 0).any() or (found > _MOST).any()):
            yield Problem(path, short(found.ravel().tolist()), "must be counts of at least 0")
        elif name in _SUMS and (found < 0).any():
            yield Problem(path, short(found.ravel().tolist()), "must be sums of at least 0")


def _memory(memory: dict[str, Any], particles: int, discs: int, walls: int) -> Iterator[Problem]:
    """What each dynamics remembers; which one it was, one name tells."""
    for name, shape in _shapes(memory, particles, discs, walls).items():
        path = f"snapshot.memory.{name}"
        if name not in memory:
            yield Problem(path, "nothing", "is required")
            continue
        found = np.asarray(memory[name])
        # Without particles there are no rows to tell the shape from.
        if found.shape != shape and found.size + particles > 0:
            yield Problem(path, f"the shape {list(found.shape)}", f"must have the shape {list(shape)}")
        elif name in _COUNTS and (found.dtype.kind != "i" or abs(int(found)) > _MOST):
            yield Problem(path, short(memory[name]), "must be a whole number")
        elif name == "epoch_length" and not found > 0:
            yield Problem(path, short(memory[name]), "must be greater than 0")


def _shapes(memory: dict[str, Any], particles: int, discs: int, walls: int) -> dict[str, tuple[int, ...]]:
    """The shape of everything that is to be there."""
    shapes: dict[str, tuple[int, ...]] = {}
    vectors, row = (particles, 2), (particles,)
    if "epoch" in memory:
        shapes |= {"epoch": (), "epoch_length": (), "position": vectors, "velocity": vectors, "time": row}
        if "angle" in memory or "angular_velocity" in memory:
            shapes |= {"angle": row, "angular_velocity": row}
    if "step" in memory:
        shapes["step"] = ()
    if "forced_step" in memory:
        shapes |= {"forced_step": (), "position": vectors, "built": (discs, 2), "box": (2,)}
        if discs > particles:
            shapes |= dict.fromkeys(("site_position", "site_velocity", "site_shift"), (discs, 2))
        shapes |= {"drive": (_OF_BATHS,), "drive_said": (_OF_BATHS,)}
        if "walls" in memory:
            shapes["walls_built"] = (walls,)
    if "walk_step" in memory:
        shapes |= {"walk_step": (), "walk_heading": vectors, "walk_target": vectors}
        shapes |= dict.fromkeys(("walk_place", "walk_going", "walk_distancing", "walk_pace"), row)
    if "walls" in memory:
        shapes["walls"] = (walls, _OF_WALL)
    return shapes
