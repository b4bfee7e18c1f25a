"""The row under the box for what surrounds the gas: gravity, and walls that can be warmed, moved or taken away."""

from __future__ import annotations

import asyncio

from nicegui import background_tasks, ui

from gasbox.app.gravity_control import GravityControl
from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.wall_controls import WallControls, can_move, walls_with_controls
from gasbox.errors import GasboxError
from gasbox.geometry import Enclosure, Geometry, side_count
from gasbox.scenario.pong import Pong
from gasbox.state import Change

__all__ = ["Surroundings"]


class Surroundings:
    """Live controls; each sends a change, which is carried out between two beats."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._built: tuple[object, ...] = ()
        self._sample: Sample | None = None
        with ui.element("section").classes("card surroundings") as self._root:
            self._root.props('aria-label="Gravity and walls"').mark("surroundings")
            self.gravity = GravityControl(self.send)
            self._chips = ui.element("div").classes("wall-chips")
        self._root.set_visibility(False)
        self.walls: list[WallControls] = []

    @property
    def visible(self) -> bool:
        """Whether the row is shown."""
        return bool(self._root.visible)

    def toggle(self) -> None:
        """Show or hide the row."""
        self._root.set_visibility(not self.visible)

    def show(self, sample: Sample) -> None:
        """Show gravity and walls as they are now; a gas with anything special about them opens the row.

        A game does not: its court needs the room.
        """
        self._sample = sample
        geometry = sample.geometry
        indices = walls_with_controls(sample.scenario, geometry) if isinstance(geometry, Enclosure) else []
        built = (sample.version, *indices, *(_kinds(geometry, index) for index in indices))
        if built != self._built:
            if self._built[:1] != built[:1]:
                special = isinstance(geometry, Enclosure) and bool(indices or any(geometry.gravity))
                self._root.set_visibility(special and not isinstance(sample.scenario.world, Pong))
            self._built = built
            self._chips.clear()
            with self._chips:
                self.walls = [WallControls(index, sample, self._session, self.send) for index in indices]
        else:
            for wall in self.walls:
                wall.show(sample)
        self.gravity.show(sample)

    def toggle_gravity(self) -> None:
        """Gravity on or off."""
        self._root.set_visibility(True)
        self.gravity.toggle()

    def toggle_divider(self) -> None:
        """Take away the first obstacle that has controls, or put it back."""
        geometry = None if self._sample is None else self._sample.geometry
        if not isinstance(geometry, Enclosure):
            return
        first = side_count(geometry.container)
        for control in self.walls:
            if control.index >= first:
                control.toggle()
                return

    def send(self, change: Change) -> None:
        """Have a change carried out, and say so if it cannot be."""
        background_tasks.create(self._carry_out(change), name="change")

    async def _carry_out(self, change: Change) -> None:
        try:
            await asyncio.wrap_future(self._session.change(change))
        except (GasboxError, asyncio.CancelledError) as error:
            with self._root:
                ui.notify(str(error) or "This session has ended.", type="warning")


def _kinds(geometry: Geometry, index: int) -> tuple[bool, bool]:
    """What decides which controls a wall has."""
    assert isinstance(geometry, Enclosure)
    return geometry.walls[index].temperature is not None, can_move(geometry, index)
