"""Heat on the page: two buttons to be held down, a slider for a constant power, and an exact number."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.asked import Asked
from gasbox.app.wording import number

__all__ = ["HOLDS", "HeatControl"]

HOLDS: Final[dict[str, int]] = {"heat": +1, "cool": -1}
"""What can be held down, by key or pointer (`page.js`), and the sign of the heat that it adds."""
_UNIT: Final = "energy/time for each disc"
_STEEPNESS: Final = 3
"""Power goes with the cube of the slider, whose half is the power of the hand."""
_STILL: Final = 0.06
"""So near to the middle the slider means nothing."""


class HeatControl:
    """Shows and changes the power of heating.

    Parameters
    ----------
    send : takes each new power [energy/time]
    """

    def __init__(self, send: Callable[[float], None]) -> None:
        self._send = send
        self._unit = 1.0
        self._steady = 0.0
        """The power while nothing is held down [energy/time]."""
        self._held = ""
        self._shown: float | None = None
        self._asked = Asked()
        self._showing = False
        self._buttons: dict[str, ui.button] = {}
        with ui.element("div").classes("aim").props('role="group" aria-label="Heat"') as self.root:
            self._hold("heat", "local_fire_department", "Hold to heat", "H")
            self._hold("cool", "ac_unit", "Hold to cool", "F")
            with ui.element("div").classes("setting"):
                self._text = ui.label("").classes("reading number").mark("heat-reading")
                self._slider = (
                    ui.slider(min=-1, max=1, step=0.02, value=0, on_change=self._slid)
                    .props('dense aria-label="Constant heating, left of the middle cooling"')
                    .mark("heat-slider")
                )
            self._menu()

    def _hold(self, name: str, icon: str, what: str, key: str) -> None:
        button = ui.button(icon=icon, color=None).props(f'flat round dense aria-label="{what}"')
        button.props(f"data-hold={name}").classes(f"hold {name}").mark(f"hold-{name}").tooltip(
            f"{what}  {key}"
        )
        self._buttons[name] = button

    def _menu(self) -> None:
        with (
            ui.button(icon="more_horiz", color=None)
            .props('flat round dense aria-label="Heating in numbers"')
            .classes("more")
            .mark("heat-numbers"),
            ui.menu().props('aria-label="Heating in numbers"'),
            ui.element("div").classes("bins-form"),
        ):
            self._power = ui.number(f"power ({_UNIT})", value=0, on_change=self._typed).mark("heat-power")
            self._power.props("dense outlined hide-bottom-space debounce=600")
            ui.button("No heating", on_click=lambda: self._go(0.0), color=None).props("flat dense").mark(
                "heat-zero"
            )
            ui.label("Less than 0 takes heat away. A thermostat works against it.").classes("hint")

    def begin(self, unit: float) -> None:
        """Another gas, with the power [energy/time] of the hand."""
        self._unit = unit
        self._shown = None

    def show(self, power: float) -> None:
        """Show the power [energy/time] of the gas, unless it is the one shown."""
        if self._asked.is_old(power) or power == self._shown:
            return
        if not self._held:
            self._steady = power
        self._draw(power)

    def _draw(self, power: float) -> None:
        self._shown = power
        self._showing = True
        sign = "+" if power > 0 else ""
        self._text.set_text(f"heat {sign}{number(power)}" if power else "no heating")
        share = 0.5 * (abs(self._steady) / self._unit) ** (1 / _STEEPNESS)
        self._slider.set_value(round(min(share, 1.0) * (-1 if self._steady < 0 else 1), 2))
        self._power.set_value(float(f"{self._steady:.6g}"))
        self._showing = False

    def hold(self, name: str) -> None:
        """Heat or cool for as long as something is held down; an empty name lets go."""
        if name == self._held:
            return
        self._held = name if name in HOLDS else ""
        for key, button in self._buttons.items():
            button.classes(add="held") if key == self._held else button.classes(remove="held")
        self._ask(HOLDS[self._held] * self._unit if self._held else self._steady)

    def _slid(self, event: ValueChangeEventArguments[float | None]) -> None:
        if self._showing or event.value is None:
            return
        size = self._unit * (2.0 * abs(event.value)) ** _STEEPNESS if abs(event.value) > _STILL else 0.0
        self._go(float(f"{size:.3g}") * (-1 if event.value < 0 else 1) + 0.0)

    def _typed(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None:
            self._go(float(event.value))

    def _go(self, power: float) -> None:
        self._steady = power
        if power != self._shown:
            self._ask(power)

    def _ask(self, power: float) -> None:
        self._asked.ask(power)
        self._draw(power)
        self._send(power)
