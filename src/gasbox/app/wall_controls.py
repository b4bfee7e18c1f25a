"""The controls of one wall: there or not, its temperature, its place."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.aims import walls_come, walls_move
from gasbox.app.reins import displacement_of, limits, movable, released
from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.wording import number
from gasbox.geometry import Enclosure, Geometry, Segment, Wall, side_count
from gasbox.scenario import Demon, Scenario
from gasbox.scenario.pong import Pong
from gasbox.state import Change, SetWall

__all__ = ["MOST_WALLS", "WallControls", "can_move", "walls_with_controls"]

MOST_WALLS: Final = 12
"""Walls that get controls; a board of pegs has no room for more."""
_OCTAVES: Final = 4
"""The slider of a temperature goes up and down by so many factors of two."""


def walls_with_controls(scenario: Scenario, geometry: Enclosure) -> list[int]:
    """Indices of the walls that can be changed by hand: dividers and what has a name, thermal and moving walls.

    Where they can neither move nor go, only thermal ones are left. Bats and goal lines belong to their game, the
    divider with its gate to a demon.
    """
    first = side_count(geometry.container)
    moves, comes = walls_move(scenario), walls_come(scenario)
    played = _played(scenario, geometry)
    found = []
    for index, wall in enumerate(geometry.walls):
        if wall.name in played:
            continue
        is_obstacle = index >= first
        named = is_obstacle and scenario.obstacles[index - first].name is not None
        divides = is_obstacle and scenario.obstacles[index - first].shape == "segment"
        if (
            wall.temperature is not None
            or (moves and (wall.motion is not None or divides))
            or (comes and (named or divides))
        ):
            found.append(index)
    return found[:MOST_WALLS]


def _played(scenario: Scenario, geometry: Enclosure) -> frozenset[str | None]:
    """Names of the walls that a world cannot do without."""
    match scenario.world:
        case Pong() as pong:
            return frozenset((pong.left, pong.right, *pong.goals))
        case Demon():
            first = side_count(geometry.container)
            segments = zip(geometry.walls[first:], geometry.obstacles, strict=True)
            return frozenset(wall.name for wall, obstacle in segments if isinstance(obstacle, Segment))
    return frozenset()


def can_move(geometry: Enclosure, index: int) -> bool:
    """Whether a wall can be moved by hand, were it there."""
    return movable(geometry.with_wall(index, present=True), index)


class WallControls:
    """A chip with the name of a wall, and in its menu what can be done to it.

    Parameters
    ----------
    index : of the wall
    sample : with the geometry that it stands in
    change : takes each change
    """

    def __init__(
        self, index: int, sample: Sample, session: Session, change: Callable[[Change], None]
    ) -> None:
        assert isinstance(sample.geometry, Enclosure)
        self.index = index
        self._session, self._change = session, change
        self._wall = wall = sample.geometry.walls[index]
        self._start = wall.temperature
        self._showing = False
        scenario = sample.scenario
        self._is_obstacle = walls_come(scenario) and index >= side_count(sample.geometry.container)
        self._moves = walls_move(scenario) and can_move(sample.geometry, index)
        with ui.element("div").classes("wall-chip").props(f'role="group" aria-label="{_plain(wall.name)}"'):
            if self._is_obstacle:
                self._present = ui.button(on_click=self.toggle, color=None).props("flat round dense")
                self._present.mark(f"wall-{index}-present")
            ui.label(wall.name).classes("name")
            if wall.temperature is not None or self._moves:
                self._value = ui.button(color=None).props(
                    f'flat dense no-caps aria-label="{_plain(wall.name)}"'
                )
                self._value.classes("number").mark(f"wall-{index}-value")
                with self._value, ui.menu() as menu, ui.element("div").classes("bins-form"):
                    if wall.temperature is not None:
                        self._temperature_form(wall.temperature)
                    if self._moves:
                        self._place_form(sample.scenario.geometry())
                menu.props(f'aria-label="{_plain(wall.name)}"')
        self.show(sample)

    def _temperature_form(self, temperature: float) -> None:
        ui.label("temperature").classes("hint")
        self._warm = (
            ui.slider(min=-_OCTAVES, max=_OCTAVES, step=0.05, value=0, on_change=self._warmed)
            .props('aria-label="Temperature, logarithmic" dense')
            .mark(f"wall-{self.index}-warmth")
        )
        self._degrees = ui.number("temperature (energy)", min=0, value=temperature, on_change=self._typed)
        self._degrees.props("dense outlined hide-bottom-space debounce=300").mark(
            f"wall-{self.index}-temperature"
        )

    def _place_form(self, start: Geometry) -> None:
        ui.label("place (or drag the wall)").classes("hint")
        self._slide = (
            ui.slider(min=-1, max=1, step=0.001, value=0, on_change=self._slid)
            .props('aria-label="Place along the normal" dense')
            .mark(f"wall-{self.index}-place")
        )
        self._goal = ui.number("move to (length)", on_change=self._went)
        self._goal.props("dense outlined hide-bottom-space debounce=300").mark(f"wall-{self.index}-goal")
        if released(start, self.index) is not None:
            ui.button("Let it go", on_click=lambda: self._session.drop(self.index), color=None).props(
                "flat dense"
            ).mark(f"wall-{self.index}-free")

    def toggle(self) -> None:
        """Take it away, or put it back."""
        self._change(SetWall(self._wall.name, present=not self._wall.present))

    def show(self, sample: Sample) -> None:
        """Show the wall as it is now."""
        assert isinstance(sample.geometry, Enclosure)
        self._wall = wall = sample.geometry.walls[self.index]
        self._showing = True
        if self._is_obstacle:
            self._show_present(wall)
        parts = []
        if wall.temperature is not None:
            self._show_temperature(wall.temperature)
            parts.append(f"T = {number(wall.temperature)}")
        if self._moves:
            place = displacement_of(sample.state, self.index)
            self._show_place(sample, place)
            if place or wall.motion is not None:
                parts.append(f"at {number(place)}")
        if wall.temperature is not None or self._moves:
            text = " · ".join(parts) or "move"
            if self._value.text != text:
                self._value.set_text(text)
        self._showing = False

    def _show_present(self, wall: Wall) -> None:
        what = f"{'Remove' if wall.present else 'Put back'} {wall.name}"
        icon = "visibility" if wall.present else "visibility_off"
        if self._present.props.get("aria-label") != what:
            self._present.props["aria-label"] = what
            self._present.props["icon"] = icon
            self._present.props["aria-pressed"] = "true" if wall.present else "false"
            self._present.update()

    def _show_temperature(self, temperature: float) -> None:
        octaves = math.log2(temperature / self._reference) if temperature > 0 else -_OCTAVES
        self._warm.set_value(round(min(max(octaves, -_OCTAVES), _OCTAVES), 2))
        self._degrees.set_value(float(f"{temperature:.6g}"))

    def _show_place(self, sample: Sample, place: float) -> None:
        assert isinstance(sample.geometry, Enclosure)
        self._slide.set_enabled(movable(sample.geometry, self.index))
        if not self._slide.enabled:
            return
        low, high = limits(sample.geometry, sample.state, self.index)
        span = high - low
        old = float(self._slide.props["max"]) - float(self._slide.props["min"])
        if abs(low - float(self._slide.props["min"])) > 0.05 * span or abs(span - old) > 0.05 * span:
            self._slide.props["min"], self._slide.props["max"] = float(f"{low:.4g}"), float(f"{high:.4g}")
            self._slide.props["step"] = float(f"{span / 200:.1g}")
            self._slide.update()
        self._slide.set_value(float(f"{place:.3g}"))

    @property
    def _reference(self) -> float:
        return self._start or 1.0

    def _warmed(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None:
            self._warm_to(float(f"{self._reference * 2.0**event.value:.3g}"))

    def _typed(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None and event.value >= 0:
            self._warm_to(float(event.value))

    def _warm_to(self, temperature: float) -> None:
        if temperature != self._wall.temperature:
            self._change(SetWall(self._wall.name, temperature=temperature))

    def _slid(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None:
            self._session.drag(self.index, float(event.value))

    def _went(self, event: ValueChangeEventArguments[float | None]) -> None:
        if event.value is not None:
            self._session.drag(self.index, float(event.value))


def _plain(name: str) -> str:
    """A name for an attribute: without what would end it."""
    return name.replace('"', "'")
