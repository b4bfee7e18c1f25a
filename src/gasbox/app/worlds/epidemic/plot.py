"""A card with a chart that is told only what is new."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from nicegui import ui

__all__ = ["Plot"]


class Plot:
    """One chart of an epidemic.

    Parameters
    ----------
    name : short, for tests and the style sheet
    make : the options of the chart while it is empty

    Attributes
    ----------
    told : the option that was told last
    """

    def __init__(self, name: str, title: str, make: Callable[[], dict[str, Any]]) -> None:
        self.told: dict[str, Any] = {}
        self._text = ""
        self._ready = False
        with (
            ui.element("section").classes(f"card histogram plot-of-{name}").mark(f"plot-{name}") as self.root
        ):
            self.root.props["aria-label"] = title
            with ui.element("div").classes("title"):
                ui.label(title).classes("name")
                self._fact = ui.label("").classes("facts number")
            self.chart = ui.echart(make(), renderer="svg").classes("plot").mark(f"chart-{name}")
        self.chart.on("chart:rendered", self._is_ready, args=[], throttle=1e6, trailing_events=False)

    def _is_ready(self) -> None:
        self._ready = True

    def tell(self, option: dict[str, Any], fact: str = "") -> None:
        """Bring the chart up to date; `fact` stands beside the title."""
        if self._fact.text != fact:
            self._fact.set_text(fact)
        text = json.dumps(option)
        self.told = option
        if self._ready and text != self._text:
            self._text = text
            self.chart.run_chart_method("setOption", option)

    def see(self, visible: bool) -> None:
        """Show it, or leave it out."""
        if self.root.visible != visible:
            self.root.set_visibility(visible)
