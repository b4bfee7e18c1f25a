"""Play, pause, single frame, reset; faster and slower."""

from __future__ import annotations

import math
from typing import Protocol

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.wording import times

__all__ = ["LADDER", "Runnable", "Transport", "next_speed"]

LADDER: tuple[float, ...] = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
"""The speeds that buttons and keys go through; the slider gives all between."""


class Runnable(Protocol):
    """What the controls need of a session."""

    @property
    def playing(self) -> bool: ...  # noqa: D102
    @property
    def speed(self) -> float: ...  # noqa: D102
    def toggle(self) -> None: ...  # noqa: D102
    def step(self) -> object: ...  # noqa: D102
    def reset(self) -> object: ...  # noqa: D102
    def set_speed(self, speed: float, /) -> None: ...  # noqa: D102


def next_speed(speed: float, direction: int) -> float:
    """The next speed on the ladder, up (+1) or down (-1)."""
    if direction > 0:
        return next((rung for rung in LADDER if rung > speed * 1.001), LADDER[-1])
    return next((rung for rung in reversed(LADDER) if rung < speed * 0.999), LADDER[0])


class Transport:
    """The bar under the box."""

    def __init__(self, session: Runnable) -> None:
        self._session = session
        self._shown_playing: bool | None = None
        with ui.element("section").classes("card transport").props('aria-label="Time"'):
            self._play = (
                ui.button(on_click=self.toggle, color=None)
                .props("round unelevated")
                .classes("play")
                .mark("play")
            )
            self._button("skip_next", "One frame  →", "One frame", self.step, "step")
            self._button("replay", "Back to the start  R", "Back to the start", self.reset, "reset")
            ui.element("div").classes("rule")
            self._button("remove", "Slower  ↓", "Slower", self.slower, "slower")
            self._slider = (
                ui.slider(min=-1, max=2, step=0.01, value=0, on_change=self._slid)
                .props('aria-label="Speed, logarithmic, from a tenth to a hundred times" snap')
                .classes("speed")
                .mark("speed")
            )
            self._button("add", "Faster  ↑", "Faster", self.faster, "faster")
            with ui.element("div").classes("pace"):
                self._reading = ui.label().classes("reading number").mark("speed-reading")
                self._behind = ui.label().classes("behind").props('role="status"').mark("behind")
        self.refresh()

    def _button(self, icon: str, hint: str, name: str, action: object, marker: str) -> None:
        button = ui.button(icon=icon, on_click=action, color=None)  # type: ignore[arg-type]
        button.props(f'flat round aria-label="{name}"').mark(marker).tooltip(hint)

    def toggle(self) -> None:
        """Play if paused, pause if playing."""
        self._session.toggle()
        self.refresh()

    def step(self) -> None:
        """One frame."""
        self._session.step()
        self.refresh()

    def reset(self) -> None:
        """Back to the start of the same scenario."""
        self._session.reset()
        self.refresh()

    def faster(self) -> None:
        """The next higher speed."""
        self._choose(next_speed(self._session.speed, +1))

    def slower(self) -> None:
        """The next lower speed."""
        self._choose(next_speed(self._session.speed, -1))

    def _choose(self, speed: float) -> None:
        self._session.set_speed(speed)
        self.refresh()

    def _slid(self, event: ValueChangeEventArguments[float | None]) -> None:
        if event.value is not None and abs(event.value - math.log10(self._session.speed)) > 0.006:
            self._session.set_speed(float(f"{10**event.value:.3g}"))
        self.refresh()

    def refresh(self) -> None:
        """Show what the session does."""
        playing = self._session.playing
        if playing != self._shown_playing:
            self._shown_playing = playing
            name, icon = ("Pause", "pause") if playing else ("Play", "play_arrow")
            self._play.props(f'icon={icon} aria-label="{name}"')
        self._slider.set_value(round(math.log10(self._session.speed), 2))
        self._reading.set_text(times(self._session.speed))

    def show_reached(self, keeping_up: bool, reached: float | None) -> None:
        """Say so if the engine cannot keep up."""
        text = "" if keeping_up or reached is None else f"can't keep up: {times(float(f'{reached:.2g}'))}"
        if self._behind.text != text:
            self._behind.set_text(text)
