"""A panel that shows the gas itself: discs, container, walls and obstacles."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.patches import Circle as Round
from matplotlib.patches import Patch
from matplotlib.patches import Polygon as Filled
from numpy.typing import NDArray

from gasbox.geometry import (
    Block,
    Circle,
    Enclosure,
    Geometry,
    Point,
    Polygon,
    Post,
    Rectangle,
    Segment,
    Wall,
    side_count,
)
from gasbox.plots.panels import Species
from gasbox.plots.style import GRID, INK, QUIET, label
from gasbox.state import Sites, State

__all__ = ["draw_gas"]

_WARM, _MOVING, _BLOCK = "#d9480f", "#0b6bcb", "#c9d0d8"


def draw_gas(
    axes: Axes,
    state: State,
    geometry: Geometry,
    species: Species,
    title: str = "",
    groups: NDArray[np.int8] | None = None,
    sticks: NDArray[np.int64] | None = None,
) -> None:
    """All discs at one moment, in their surroundings.

    Thermal walls are red, moving ones blue, open ones dashed, those that some pass dotted; periodic edges are faint.

    Parameters
    ----------
    geometry : at the time of the state; its walls are displaced here
    species : name and colour of each; where there are molecules, of each kind of site
    groups : (n,) of what else particles are coloured by; then `species` has their names and colours
    sticks : (k, 2) rows of sites that are bonded; None for no bonds
    """
    here = geometry.at(state.wall_displacement)
    _draw_container(axes, here)
    if isinstance(here, Enclosure):
        for number in range(len(here.obstacles)):
            _draw_obstacle(axes, here, number)
    if state.sites is None:
        _draw_discs(axes, state, species, state.species if groups is None else groups)
    else:
        _draw_bonds(axes, state.sites, sticks)
        _draw_discs(
            axes, state.sites, species, state.sites.species if groups is None else groups[state.sites.owner]
        )
    _fit(axes, here, state)
    axes.set_title(title or f"time {state.time:g}", color=INK, fontsize=10, fontweight="bold")
    axes.set_xlabel(label("x", "position"), color=INK, fontsize=9)
    axes.set_ylabel(label("y", "position"), color=INK, fontsize=9)


def _draw_bonds(axes: Axes, sites: Sites, sticks: NDArray[np.int64] | None) -> None:
    if sticks is not None and len(sticks):
        axes.add_collection(
            LineCollection(list(sites.position[sticks]), colors=QUIET, linewidths=1.2, zorder=0.5)
        )


def _draw_discs(axes: Axes, state: State | Sites, kinds: Species, groups: NDArray[Any]) -> None:
    for number, (_, color) in enumerate(kinds):
        mine = groups == number
        if not np.any(mine):
            continue
        across = 2.0 * state.radius[mine]
        discs = EllipseCollection(
            across, across, np.zeros(across.size), units="xy", offsets=state.position[mine],
            offset_transform=axes.transData, facecolor=color, linewidth=0,
        )  # fmt: skip
        axes.add_collection(discs)


def _style(wall: Wall | None) -> dict[str, Any]:
    if wall is None:
        return {"color": INK, "linewidth": 1.6}
    color = _WARM if wall.temperature is not None else _MOVING if wall.motion is not None else INK
    line = "--" if wall.open else ":" if wall.passes is not None else "-"
    return {"color": color, "linewidth": 2.2 if color != INK else 1.6, "linestyle": line}


def _draw_container(axes: Axes, geometry: Geometry) -> None:
    walls = geometry.walls if isinstance(geometry, Enclosure) else (None,) * 4
    match geometry.container if isinstance(geometry, Enclosure) else geometry:
        case Circle(center=center, radius=radius):
            axes.add_patch(Round(center, radius, fill=False, **_style(walls[0])))
        case Polygon(vertices=vertices):
            for wall, start, end in zip(walls, vertices, (*vertices[1:], vertices[0]), strict=False):
                _line(axes, start, end, wall)
        case Rectangle():
            left, right, bottom, top = _box(geometry)
            corners = ((left, bottom), (left, top)), ((right, bottom), (right, top))
            sides = (*corners, ((left, bottom), (right, bottom)), ((left, top), (right, top)))
            for number, (start, end) in enumerate(sides):
                if geometry.periodic[number // 2]:
                    axes.plot(*zip(start, end, strict=True), color=GRID, linewidth=1.0)
                else:
                    _line(axes, start, end, walls[number])


def _box(geometry: Geometry) -> tuple[float, float, float, float]:
    moved = geometry.displacement[:4] if isinstance(geometry, Enclosure) else ()
    left, right, bottom, top = moved or (0.0, 0.0, 0.0, 0.0)
    return left, geometry.width + right, bottom, geometry.height + top


def _line(axes: Axes, start: Point, end: Point, wall: Wall | None) -> None:
    style = _style(wall)
    axes.plot(*zip(start, end, strict=True), solid_capstyle="round", **style)


def _draw_obstacle(axes: Axes, geometry: Enclosure, number: int) -> None:
    index = side_count(geometry.container) + number
    wall, obstacle = geometry.walls[index], geometry.obstacles[number]
    if not wall.present:
        return
    style = {"facecolor": _BLOCK, "edgecolor": _style(wall)["color"], "linewidth": 1.2}
    way = geometry.displacement[index] if geometry.displacement else 0.0
    patch: Patch
    match obstacle:
        case Segment(start=start, end=end, normal=(nx, ny)):
            _line(
                axes, (start[0] + way * nx, start[1] + way * ny), (end[0] + way * nx, end[1] + way * ny), wall
            )
            return
        case Block(vertices=vertices):
            patch = Filled(np.array(vertices), closed=True, **style)
        case Post(center=(x, y), radius=radius, direction=(nx, ny)):
            patch = Round((x + way * nx, y + way * ny), radius, **style)
    axes.add_patch(patch)


def _fit(axes: Axes, geometry: Geometry, state: State) -> None:
    left, right, bottom, top = _box(geometry)
    margin = 0.02 * math.hypot(right - left, top - bottom)
    axes.set_xlim(min(left, 0.0) - margin, max(right, geometry.width) + margin)
    axes.set_ylim(min(bottom, 0.0) - margin, max(top, geometry.height) + margin)
    axes.set_aspect("equal")
    axes.spines[["top", "right", "left", "bottom"]].set_visible(False)
    axes.tick_params(colors=QUIET, labelsize=8, length=3)
