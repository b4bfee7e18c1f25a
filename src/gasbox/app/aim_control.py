"""A value that something is held at: a switch, a slider around the start, and exact numbers."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.aims import Aim
from gasbox.app.asked import Asked
from gasbox.app.wording import number

__all__ = ["AimControl", "Kind"]

_OCTAVES: Final = 4
"""The slider goes up and down by so many factors of two."""


@dataclass(frozen=True)
class Kind:
    """What is held.

    Attributes
    ----------
    name : of the quantity, also for tests
    device : that holds it
    icon, sign : of the quantity
    unit : in words
    """

    name: str
    device: str
    icon: str
    sign: str
    unit: str


class AimControl:
    """Shows and changes what a thermostat or a barostat aims at.

    Parameters
    ----------
    send : takes each new aim, None to switch it off, and the time in which it is to be reached [time]
    """

    def __init__(self, kind: Kind, send: Callable[[float | None, float], None]) -> None:
        self._kind, self._send = kind, send
        self._aim: Aim | None = None
        self._now: float | None = None
        """What the gas has by itself: where the aim begins when it is switched on."""
        self._reference = 1.0
        self._real: Callable[[float], str] = lambda _: ""
        self._showing = False
        self._asked = Asked()
        name, device = kind.name, kind.device
        with (
            ui.element("div")
            .classes("aim")
            .props(f'role="group" aria-label="{device.capitalize()}"') as self.root
        ):
            self._switch = ui.button(icon=kind.icon, on_click=self.toggle, color=None)
            self._switch.props(f'flat round dense aria-label="{device.capitalize()} on or off"')
            self._switch.mark(f"{name}-switch").tooltip(f"{device.capitalize()} on or off")
            with ui.element("div").classes("setting"):
                self._text = ui.label("").classes("reading number").mark(f"{name}-aim")
                self._slider = (
                    ui.slider(min=-_OCTAVES, max=_OCTAVES, step=0.05, value=0, on_change=self._slid)
                    .props(f'dense aria-label="{device.capitalize()}, logarithmic"')
                    .mark(f"{name}-slider")
                )
            self._menu()

    def _menu(self) -> None:
        name, device = self._kind.name, self._kind.device
        with (
            ui.button(icon="more_horiz", color=None)
            .props(f'flat round dense aria-label="{device.capitalize()} in numbers"')
            .classes("more")
            .mark(f"{name}-numbers"),
            ui.menu().props(f'aria-label="{device.capitalize()} in numbers"'),
            ui.element("div").classes("bins-form"),
        ):
            self._goal = ui.number(f"{name} ({self._kind.unit})", min=0, on_change=self._typed)
            self._goal.mark(f"{name}-goal")
            self._over = ui.number("reached after (time)", min=0, value=0).mark(f"{name}-over")
            for box in (self._goal, self._over):
                box.props("dense outlined hide-bottom-space debounce=600")
            ui.label(f"The {device} goes there evenly, in this time.").classes("hint")

    def begin(self, reference: float | None, real: Callable[[float], str]) -> None:
        """Another gas.

        Parameters
        ----------
        reference : the slider is around this value
        real : says a value in real units, or nothing
        """
        self._reference, self._real = reference or 1.0, real
        self._aim = None
        self._over.set_value(0)
        self._draw(0.0)

    def show(self, aim: Aim | None, time: float, now: float | None) -> None:
        """Show what is aimed at.

        Parameters
        ----------
        now : what the gas has, as measured
        """
        self._now = now
        if not self._asked.is_old(None if aim is None else aim.goal):
            self._aim = aim
            self._draw(time)

    def toggle(self) -> None:
        """Switch it off, or on: at what it was, or at what the gas has."""
        if self._aim is not None:
            self._ask(None)
            return
        value = self._goal.value
        if value is None:
            value = self._now if self._now is not None and self._now > 0.0 else self._reference
        self._ask(float(f"{value:.3g}"))

    def _draw(self, time: float) -> None:
        aim, sign = self._aim, self._kind.sign
        if aim is None:
            text = f"{self._kind.device} off"
        else:
            at = aim.at(time)
            text = f"{sign} → {number(aim.goal)}" if at != aim.goal else f"{sign} = {number(at)}"
            real = self._real(aim.goal)
            text += f" · {real}" if real else ""
        if self._text.text != text:
            self._text.set_text(text)
        pressed = "true" if aim is not None else "false"
        if self._switch.props.get("aria-pressed") != pressed:
            self._switch.props["aria-pressed"] = pressed
            self._switch.update()
        if aim is not None:
            self._showing = True
            octaves = math.log2(aim.goal / self._reference) if aim.goal > 0 else -_OCTAVES
            self._slider.set_value(round(min(max(octaves, -_OCTAVES), _OCTAVES), 2))
            self._goal.set_value(float(f"{aim.goal:.6g}"))
            self._showing = False

    def _slid(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None:
            self._lead(float(f"{self._reference * 2.0**event.value:.3g}"))

    def _typed(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None and event.value >= 0:
            self._lead(float(event.value), float(self._over.value or 0.0))

    def _lead(self, goal: float, over: float = 0.0) -> None:
        if self._aim is None or goal != self._aim.goal:
            self._ask(goal, max(over, 0.0))

    def _ask(self, goal: float | None, over: float = 0.0) -> None:
        self._asked.ask(goal)
        self._aim = None if goal is None else Aim(goal)
        self._draw(0.0)
        self._send(goal, over)
