"""The row above the histograms: theory, smoothing, bins and range."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.bins import BinChoice
from gasbox.app.charts import Charts
from gasbox.app.smoothing import CHOICES
from gasbox.app.studies import Studies, StudyMenu

__all__ = ["ChartSettings"]

_MOST_BINS = 200
_OF_DISCS = {"speed": "speed", "energy": "energy"}
_OF_MOLECULES = {
    **_OF_DISCS,
    "angular-velocity": "angular velocity",
    "rotational-energy": "rotational energy",
}


class ChartSettings:
    """Controls that act on the histograms at once.

    Parameters
    ----------
    charts : returns the histograms (they are made after this row)
    changed : called after each change
    studies : returns the other charts, likewise
    molecules : whether the gas has any, and thus histograms of rotation
    """

    def __init__(
        self,
        choice: BinChoice,
        charts: Callable[[], Charts],
        changed: Callable[[], None],
        studies: Callable[[], Studies],
        *,
        molecules: bool = False,
    ) -> None:
        self._charts = charts
        self._changed = changed
        self._choice = choice
        self._showing = False
        with ui.element("div").classes("chart-settings"):
            self.theory = (
                ui.switch("Theory", value=True, on_change=self._theory).props("dense").mark("theory")
            )
            self.theory.tooltip(
                "What theory expects at the temperature of the whole gas, or with molecules at that of each kind  T"
            )
            self.menu = StudyMenu(studies, changed)
            ui.element("div").classes("push")
            ui.label("average over").classes("word")
            self.smoothing = ui.select(CHOICES, value=0.0, on_change=self._smooth).mark("smoothing")
            self.smoothing.props('dense options-dense borderless aria-label="Average over"')
            with (
                ui.button(icon="settings", color=None)
                .props('flat round dense aria-label="Bins and range"')
                .mark("bins-menu")
            ):
                with ui.menu().props("persistent=false") as menu, ui.element("div").classes("bins-form"):
                    self._form()
                menu.props('aria-label="Bins and range"')
        self.show(choice, molecules=molecules)

    def _form(self) -> None:
        self._quantity = ui.toggle(_OF_DISCS, value="speed", on_change=self._cut)
        self._quantity.props("dense no-caps unelevated").classes("quantities").mark("quantity")
        self._bins = ui.number("bins", min=1, max=_MOST_BINS, precision=0, on_change=self._cut).mark("bins")
        self._range = ui.select(
            {"all": "automatic, the same for all", "own": "automatic, for each its own", "given": "given"},
            label="range",
            on_change=self._cut,
        ).mark("range")
        with ui.element("div").classes("fields two") as ends:
            self._minimum = ui.number("from", on_change=self._cut).mark("minimum")
            self._maximum = ui.number("to", min=0, on_change=self._cut).mark("maximum")
        ends.bind_visibility_from(self._range, "value", lambda value: value == "given")
        for box in (self._bins, self._range, self._minimum, self._maximum):
            box.props("dense outlined options-dense hide-bottom-space")

    def show(self, choice: BinChoice, *, molecules: bool = False) -> None:
        """Show the bins of another scenario; with `molecules`, what only these have can be chosen."""
        self._choice = choice
        self._showing = True
        self._quantity.set_options(_OF_MOLECULES if molecules else _OF_DISCS)
        self._quantity.set_value(choice.quantity)
        self._bins.set_value(choice.count)
        self._minimum.set_value(choice.minimum)
        self._maximum.set_value(choice.maximum)
        self._range.set_value("given" if choice.maximum is not None else "own" if choice.own else "all")
        self._showing = False

    def _theory(self, event: ValueChangeEventArguments[bool | None]) -> None:
        self._charts().show_theory(bool(event.value))
        self._changed()

    def _smooth(self, event: ValueChangeEventArguments[float]) -> None:
        self._charts().smooth(float(event.value))
        self._changed()

    def _cut(self) -> None:
        choice = None if self._showing else self._typed()
        if choice is not None and choice != self._choice:
            self._choice = choice
            self._charts().choose(choice)
            self._changed()

    def _typed(self) -> BinChoice | None:
        """What the form asks for, or None while it makes no sense."""
        bins, minimum, maximum = self._bins.value, self._minimum.value, self._maximum.value
        if bins is None or not 1 <= bins <= _MOST_BINS:
            return None
        choice = replace(self._choice, quantity=self._quantity.value, count=int(bins))
        if self._range.value != "given":
            return replace(choice, minimum=0.0, maximum=None, own=self._range.value == "own")
        least = -math.inf if choice.quantity == "angular-velocity" else 0.0
        if minimum is None or maximum is None or not least <= minimum < maximum:
            return None
        return replace(choice, minimum=float(minimum), maximum=float(maximum), own=False)
