"""A card with a chart that is told only what is new."""

from __future__ import annotations

import json
from typing import Any

from nicegui import ui

__all__ = ["ChartCard"]


class ChartCard:
    """A title, a fact beside it, and under them a chart, once it has been drawn.

    Parameters
    ----------
    name : short, for tests: the chart is marked ``chart-<name>``
    classes : of the card, for the style sheet

    Attributes
    ----------
    chart : None before it was drawn
    told : the option that was told last; browsers that are not ready get the one after
    """

    def __init__(self, name: str, title: str, classes: str, mark: str) -> None:
        self.name, self.title = name, title
        self.chart: ui.echart | None = None
        self.told: dict[str, Any] = {}
        self._text = ""
        self._ready = False
        with ui.element("section").classes(f"card histogram {classes}").mark(mark) as self.root:
            self.root.props["aria-label"] = title
            with ui.element("div").classes("title"):
                ui.label(title).classes("name")
                self._fact = ui.label("").classes("facts number")
            self._slot = ui.element("div").classes("plot-slot")

    def draw(self, options: dict[str, Any]) -> None:
        """Make the chart, in the place of the one that is there."""
        self._ready, self._text, self.told = False, "", {}
        self._slot.clear()
        with self._slot:
            self.chart = ui.echart(options, renderer="svg").classes("plot").mark(f"chart-{self.name}")
        self.chart.on("chart:rendered", self._is_ready, args=[], throttle=1e6, trailing_events=False)

    def _is_ready(self) -> None:
        self._ready = True

    def say(self, fact: str) -> None:
        """What stands beside the title."""
        if self._fact.text != fact:
            self._fact.set_text(fact)

    def change(self, option: dict[str, Any]) -> None:
        """Tell the chart these options, if they are others than before."""
        assert self.chart is not None
        self.told = option
        text = json.dumps(option)
        if self._ready and text != self._text:
            self._text = text
            self.chart.run_chart_method("setOption", option)
