"""From what was observed in a recording to panels: which there are, and what theory is drawn over them."""

from __future__ import annotations

from functools import partial
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from gasbox import observe
from gasbox.cli.matter import FIGURES_OF_MATTER
from gasbox.cli.molecules import FIGURES_OF_MOLECULES
from gasbox.cli.sticks import bonds_between
from gasbox.cli.survey import Survey
from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.geometry.conserved import is_solid
from gasbox.plots import (
    Panel,
    draw_centers,
    draw_density,
    draw_energies,
    draw_gas,
    draw_indicator,
    draw_mixing,
    draw_passed,
    draw_sides,
    draw_temperature_profile,
    draw_transfers,
    draw_wall_pressures,
)
from gasbox.scenario import Scenario
from gasbox.theory import adiabat, gravity, sediment

__all__ = ["FIGURES", "panels_of"]

FIGURES: Final = {
    "gas": "the last frame",
    "profiles": "density and temperature along gravity",
    "energy": "energy, work and heat",
    "walls": "pressure on each wall",
    "pv": "pressure and area behind a moving wall",
    "sides": "who is on which side of a divider",
    "centers": "centres of mass",
    "flow": "who passed openings, membranes and lines",
    **FIGURES_OF_MATTER,
    **FIGURES_OF_MOLECULES,
}
"""Figures of panels, and what they show."""

Curve = tuple[NDArray[np.float64], NDArray[np.float64]]


def panels_of(name: str, scenario: Scenario, found: Survey, temperature: float | None) -> list[Panel]:
    """The panels of one figure (or "transfers" alone); none if this recording has nothing to show there.

    Parameters
    ----------
    temperature : mean over the frames that are averaged [energy]
    """
    kinds = [(entry.name, entry.color) for entry in scenario.kinds]
    match name:
        case "gas":
            last = found.last.state
            discs = [(entry.name, entry.color) for entry in scenario.site_kinds]
            sticks = bonds_between(scenario, last)
            return [partial(draw_gas, state=last, geometry=found.end, species=discs, sticks=sticks)]
        case "profiles" if found.profiles is not None:
            points, hard = _laws(scenario, found, temperature)
            density = partial(
                draw_density, profiles=found.profiles, species=kinds, barometric=points, hard_discs=hard
            )
            heat = partial(
                draw_temperature_profile, profiles=found.profiles, species=kinds, temperature=temperature
            )
            return [density, heat]
        case "energy" if _has_story(found.book):
            return [
                partial(draw_energies, book=found.book),
                *panels_of("transfers", scenario, found, temperature),
            ]
        case "transfers" if _is_given(found.book):
            return [partial(draw_transfers, book=found.book)]
        case "walls" if np.any(np.isfinite(found.walls.mean)):
            walls = found.walls
            return [partial(draw_wall_pressures, names=walls.names, mean=walls.mean, error=walls.error)]
        case "pv" if found.diagram is not None:
            curves = _adiabats(scenario, found, temperature)
            return [partial(draw_indicator, diagram=found.diagram, curves=curves)]
        case "sides":
            each = [partial(draw_sides, sides=one, species=kinds) for one in found.sides.values()]
            mixed = [one for one in found.sides.values() if np.any(np.isfinite(one.mixing))]
            return [*each, *(partial(draw_mixing, sides=one) for one in mixed)]
        case "centers" if found.centers is not None:
            return [partial(draw_centers, centers=found.centers, species=kinds, axis=_side_axis(found))]
        case "flow":
            return _flow(found, kinds)
        case _:
            return []


def _flow(found: Survey, kinds: list[tuple[str, str]]) -> list[Panel]:
    through = [k for k in range(found.passed.shape[1]) if np.any(found.passed[-1, k])][:4]
    if not through:
        return []
    names = [found.walls.names[k] for k in through]
    return [
        partial(draw_passed, time=found.times, passed=found.passed[:, through], names=names, species=kinds)
    ]


def _has_story(book: observe.EnergyBalance) -> bool:
    """Whether energy is more than a constant kinetic one."""
    return bool(np.any(book.potential) or _is_given(book))


def _is_given(book: observe.EnergyBalance) -> bool:
    walls = (book.work, book.heat, book.carried, book.rest, book.changes)
    return any(np.any(row) for row in (*walls, book.thermostat, book.heater, book.barostat))


def _side_axis(found: Survey) -> Literal["x", "y"]:
    """Along gravity; without it, across the first divider."""
    if found.profiles is not None or not found.sides:
        return found.axis
    normal = next(iter(found.sides.values())).line.normal
    return "x" if abs(normal[0]) >= abs(normal[1]) else "y"


def _laws(scenario: Scenario, found: Survey, temperature: float | None) -> tuple[list[Curve], list[Curve]]:
    """What theory says of the density: points of each species, and hard discs where there is only one."""
    geometry, profiles = found.end.at(found.last.state.wall_displacement), found.profiles
    if temperature is None or profiles is None or not any(geometry.gravity):
        return [], []
    counts = np.bincount(found.last.state.species, minlength=len(scenario.kinds))
    points = [
        _barometric(geometry, entry.half_width, entry.mass, int(count), temperature, profiles)
        for entry, count in zip(scenario.kinds, counts, strict=True)
    ]
    if not _is_of_one_disc(scenario) or not _is_bare_box(geometry):
        return points, []
    entry = scenario.kinds[0]
    return points, [_sediment(geometry, entry.radius, entry.mass, int(counts[0]), temperature, found.axis)]


def _barometric(
    geometry: Geometry,
    radius: float,
    mass: float,
    count: int,
    temperature: float,
    profiles: observe.Profiles,
) -> Curve:
    """n ~ exp(m g.x/T), over whatever shape the discs can reach."""
    along = 0 if profiles.axis == "x" else 1
    fine = np.linspace(profiles.edges[0], profiles.edges[-1], 4 * (profiles.edges.size - 1) + 1)
    middles = 0.5 * (fine[1:] + fine[:-1])
    areas = observe.strip_areas(geometry, radius, profiles.axis, fine)
    fall = -geometry.gravity[along]
    ell = gravity.scale_height(mass, temperature, abs(fall))
    height = (middles if fall > 0 else -middles) - np.min(middles if fall > 0 else -middles)
    share = np.exp(-height / ell)
    density = count * share / max(float(np.sum(areas * share)), 1e-300)
    # From the lowest to the highest strip of which more than a sliver can be reached.
    reached = np.flatnonzero(areas > 0.5 * np.max(areas, initial=0.0) / 50)
    rows = slice(reached[0], reached[-1] + 1) if reached.size else slice(0)
    return middles[rows], density[rows]


def _sediment(
    geometry: Geometry, radius: float, mass: float, count: int, temperature: float, axis: str
) -> Curve:
    """Hard discs in a rectangle, by local density."""
    along = 0 if axis == "x" else 1
    size = geometry.accessible_size(radius)
    fall = -geometry.gravity[along]
    moved = (
        geometry.displacement[2 * along] if isinstance(geometry, Enclosure) and geometry.displacement else 0.0
    )
    height = np.linspace(0.0, size[along], 200)
    ell = gravity.scale_height(mass, temperature, abs(fall))
    density = sediment.hard_disc_density(height, count, size[1 - along], radius, ell, size[along])
    low = radius + moved
    return (low + height if fall > 0 else low + size[along] - height), density


def _is_bare_box(geometry: Geometry) -> bool:
    """Whether there is nothing but the four sides, and gravity along one of them."""
    if not isinstance(geometry, Enclosure) or not isinstance(geometry.container, Rectangle):
        return False
    return not any(is_solid(wall) for wall in geometry.walls[4:]) and 0.0 in geometry.gravity


def _is_of_one_disc(scenario: Scenario) -> bool:
    """Whether there is one kind of particle, and it is a disc."""
    return len(scenario.kinds) == 1 and scenario.kinds[0].inertia == 0.0


def _adiabats(
    scenario: Scenario, found: Survey, temperature: float | None
) -> list[tuple[str, NDArray[np.float64], NDArray[np.float64]]]:
    """Slow changes of area from the first point on: without heat, and at one temperature. One species, no gravity."""
    diagram, state = found.diagram, found.last.state
    if diagram is None or not _is_of_one_disc(scenario) or any(found.start.gravity) or not state.count:
        return []
    entry = scenario.kinds[0]
    warmth = found.book.kinetic[0] / state.count
    areas = np.linspace(float(np.min(diagram.area)), float(np.max(diagram.area)), 100)
    start = float(diagram.area[0])
    given = (warmth, state.count, entry.radius, start)
    slow = adiabat.adiabatic_pressure(areas, *given)
    # Freedom without end: a bath so large that its temperature stays.
    kept = adiabat.adiabatic_pressure(areas, *given, freedom=1e12)
    if np.any(found.book.heat):
        return [("at one temperature (theory)", areas, kept)]
    return [("slow, without heat (theory)", areas, slow), ("at one temperature (theory)", areas, kept)]
