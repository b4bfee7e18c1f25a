"""The sliders of an epidemic's measures, under headings; they act at once, and show what a schedule sets."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.asked import Asked
from gasbox.app.worlds.epidemic.dials import Dial, Group

__all__ = ["Measures"]

Choose = Callable[[str, float], None]
"""Takes the name of a setting and its new value."""


class _DialControl:
    """A slider with a number beside its name, either of which sets the value."""

    def __init__(self, dial: Dial, choose: Choose) -> None:
        self._dial, self._choose = dial, choose
        self._asked = Asked()
        self._shown: float | None = None
        self._showing = False
        with ui.element("div").classes("dial") as root:
            root.tooltip(dial.hint)
            with ui.element("div").classes("head"):
                ui.label(dial.label).classes("name")
                self._number = ui.number(
                    min=dial.setting.least,
                    max=dial.setting.greatest,
                    on_change=self._typed,
                    format="%.6g",
                ).props(
                    f'dense borderless hide-bottom-space debounce=600 aria-label="{dial.label}, as a number"'
                )
                self._number.classes("number").mark(f"number-{dial.name}")
                if dial.unit:
                    ui.label(dial.unit).classes("unit")
            self._slider = (
                ui.slider(min=0, max=1, step=0.01, value=0, on_change=self._slid)
                .props(f'dense aria-label="{dial.label}"')
                .mark(f"dial-{dial.name}")
            )

    def show(self, value: float) -> None:
        """Show the value that holds now, unless another one is on its way."""
        if not self._asked.is_old(value) and value != self._shown:
            self._draw(value)

    def forget(self) -> None:
        """Another run is shown from now on."""
        self._asked, self._shown = Asked(), None

    def _draw(self, value: float) -> None:
        self._shown = value
        self._showing = True
        self._slider.set_value(self._dial.place(value))
        self._number.set_value(float(f"{value:.6g}"))
        self._showing = False

    def _slid(self, event: ValueChangeEventArguments[float | None]) -> None:
        if not self._showing and event.value is not None:
            self._go(self._dial.value(event.value))

    def _typed(self, event: ValueChangeEventArguments[float | None]) -> None:
        setting = self._dial.setting
        if not self._showing and event.value is not None and setting.least <= event.value <= setting.greatest:
            self._go(float(event.value), slid=False)

    def _go(self, value: float, *, slid: bool = True) -> None:
        if value == self._shown:
            return
        self._asked.ask(value)
        self._shown = value
        self._showing = True
        # What the hand is on is left to it.
        if slid:
            self._number.set_value(float(f"{value:.6g}"))
        else:
            self._slider.set_value(self._dial.place(value))
        self._showing = False
        self._choose(self._dial.name, value)


class Measures:
    """All sliders of one epidemic, a heading at a time.

    Parameters
    ----------
    groups : headings with their sliders
    choose : called with each new value
    """

    def __init__(self, groups: list[tuple[Group, list[Dial]]], choose: Choose) -> None:
        self._controls: dict[str, _DialControl] = {}
        self._tabs: list[tuple[Group, ui.tab]] = []
        self._active: dict[str, bool] = {}
        first = groups[0][0].title
        with ui.tabs().props(
            'dense inline-label no-caps outside-arrows mobile-arrows align=left aria-label="Measures"'
        ) as tabs:
            tabs.classes("measure-tabs")
            for group, _ in groups:
                tab = ui.tab(group.title).mark(f"tab-{group.title}")
                if group.measure:
                    self._tabs.append((group, tab))
        with ui.tab_panels(tabs, value=first, animated=False).classes("measure-panels"):
            for group, mine in groups:
                with ui.tab_panel(group.title), ui.element("div").classes("dials"):
                    for dial in mine:
                        self._controls[dial.name] = _DialControl(dial, choose)

    def show(self, settings: Mapping[str, float], active: Mapping[str, bool]) -> None:
        """Show the values that hold now, and which measures are acting."""
        for name, control in self._controls.items():
            if name in settings:
                control.show(settings[name])
        for group, tab in self._tabs:
            acting = bool(active.get(group.measure)) and (
                not group.strength or settings.get(group.strength, 0.0) > 0.0
            )
            if acting != self._active.get(group.title, False):
                self._active[group.title] = acting
                tab.props(add="alert" if acting else None, remove=None if acting else "alert")

    def forget(self) -> None:
        """Another run is shown from now on: nothing is on its way."""
        for control in self._controls.values():
            control.forget()


def settings_of(view: Mapping[str, Any]) -> dict[str, float]:
    """Name of each setting -> its value now."""
    return {name: float(value) for name, value in view.get("settings", {}).items()}
