"""Gravity on the page: a pad, a strength, exact numbers, and a switch."""

from __future__ import annotations

import math
from collections.abc import Callable

from nicegui import ui
from nicegui.element import Element
from nicegui.events import GenericEventArguments, ValueChangeEventArguments

from gasbox.app.pull import Pull, unit_of
from gasbox.app.sample import Sample
from gasbox.app.wording import number
from gasbox.state import SetGravity

__all__ = ["GravityControl"]

_UNIT = "length/time²"


class _Pad(Element, component="frontend/gravity_pad.js"):
    """The round pad; see the component."""

    def __init__(self) -> None:
        super().__init__()
        self.show(Pull(), "no gravity")

    def show(self, pull: Pull, text: str) -> None:
        """Show where gravity points, and say it in words."""
        self._props["x"], self._props["y"] = pull.place
        self._props["text"] = text
        self.update()


class GravityControl:
    """Shows and changes the vector of gravity.

    Parameters
    ----------
    send : takes each change
    """

    def __init__(self, send: Callable[[SetGravity], None]) -> None:
        self._send = send
        self._pull = self._last = Pull()
        self._shown: tuple[float, float] | None = None
        self._floors = (True, True)
        self._unit = 1.0
        self._version = -1
        self._showing = False
        with ui.element("div").classes("gravity").props('role="group" aria-label="Gravity"'):
            self._pad = _Pad().mark("gravity-pad")
            self._pad.on("tilt", self._tilted, throttle=0.05)
            with ui.element("div").classes("gravity-strength"):
                self._text = ui.label("no gravity").classes("reading number").mark("gravity-reading")
                self._slider = (
                    ui.slider(min=0, max=1, step=0.01, value=0, on_change=self._slid)
                    .props('aria-label="Strength of gravity" dense')
                    .mark("gravity-strength")
                )
            self._switch = ui.button(icon="power_settings_new", on_click=self.toggle, color=None)
            self._switch.props('flat round dense aria-label="Gravity on or off"').mark("gravity-switch")
            self._switch.tooltip("Gravity on or off  G")
            self._menu()

    def _menu(self) -> None:
        with (
            ui.button(icon="more_horiz", color=None)
            .props('flat round dense aria-label="Gravity in numbers"')
            .mark("gravity-numbers"),
            ui.menu().props('aria-label="Gravity in numbers"'),
            ui.element("div").classes("bins-form"),
        ):
            self._size = ui.number(f"strength ({_UNIT})", min=0, on_change=self._typed).mark("gravity-size")
            self._angle = ui.number(
                "direction (degrees, −90 is down)", min=-360, max=360, on_change=self._typed
            ).mark("gravity-angle")
            for box in (self._size, self._angle):
                box.props("dense outlined hide-bottom-space debounce=300")
            ui.button("No gravity", on_click=self.off, color=None).props("flat dense").mark("gravity-zero")
            ui.label("Halfway, the scale height T/(m g) is the height of the box.").classes("hint")

    def show(self, sample: Sample) -> None:
        """Show the gravity of the gas, unless it is the one shown."""
        if sample.version != self._version:
            self._version = sample.version
            self._unit = unit_of(sample)
            self._shown = None
            self._allow(bool(sample.geometry.periodic_x), bool(sample.geometry.periodic_y))
        vector = sample.geometry.gravity
        if vector != self._shown:
            self._draw(vector)

    def _allow(self, periodic_x: bool, periodic_y: bool) -> None:
        """Gravity needs a floor: along a periodic direction there is none."""
        self._floors = (not periodic_x, not periodic_y)
        self._last = Pull(0.0)
        for control in (self._slider, self._switch, self._size, self._angle):
            control.set_enabled(any(self._floors))

    def toggle(self) -> None:
        """From some gravity to none, and back to what it was (at first: half strength, down if that has a floor)."""
        if self._pull.strength:
            self.off()
        else:
            self._choose(self._last if self._last.strength else Pull(0.5, -90.0 if self._floors[1] else 0.0))

    def off(self) -> None:
        """No gravity."""
        self._choose(Pull(0.0, self._pull.angle))

    def _choose(self, pull: Pull) -> None:
        self._set(pull.vector(self._unit))

    def _set(self, vector: tuple[float, float]) -> None:
        x, y = (part if floor else 0.0 for part, floor in zip(vector, self._floors, strict=True))
        if (x, y) != self._shown:
            self._draw((x, y))
            self._send(SetGravity((x, y)))

    def _draw(self, vector: tuple[float, float]) -> None:
        self._shown = vector
        self._pull = Pull.of(vector, self._unit, self._pull.angle)
        if self._pull.strength:
            self._last = self._pull
        size = math.hypot(*vector)
        text = f"g = {number(size)}" if size else "no gravity" if any(self._floors) else "no floor: periodic"
        self._showing = True
        self._text.set_text(text)
        self._pad.show(self._pull, f"{text}, {self._pull.angle:.0f} degrees" if size else text)
        self._slider.set_value(round(min(self._pull.strength, 1.0), 2))
        self._size.set_value(float(f"{size:.6g}"))
        self._angle.set_value(float(f"{self._pull.angle:.4g}"))
        self._showing = False

    def _tilted(self, event: GenericEventArguments) -> None:
        self._choose(Pull.at(float(event.args["x"]), float(event.args["y"])))

    def _slid(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None:
            self._choose(Pull(float(event.value), self._pull.angle))

    def _typed(self) -> None:
        size, angle = self._size.value, self._angle.value
        if self._showing or size is None or angle is None or size < 0:
            return
        turn = math.radians(float(angle))
        x, y = float(size) * math.cos(turn), float(size) * math.sin(turn)
        self._pull = Pull(self._pull.strength, float(angle))
        self._set((round(x, 12) + 0.0, round(y, 12) + 0.0))
