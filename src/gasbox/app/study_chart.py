"""The chart of one study on the page."""

from __future__ import annotations

import json

from nicegui import ui

from gasbox.app.study import Picture
from gasbox.app.study_options import filled, layout

__all__ = ["StudyChart"]


class StudyChart:
    """A card with a title; the chart in it is made anew when it gets other curves, and else only told what is new.

    Attributes
    ----------
    shown : the options as last told
    """

    def __init__(self, name: str, title: str) -> None:
        self._title = title
        self._kind: tuple[object, ...] | None = None
        self._ready = False
        self._told = ""
        self.shown: dict[str, object] = {}
        with ui.element("section").classes(f"card histogram study of-{name}").mark(f"study-{name}") as card:
            card.props["aria-label"] = title
            with ui.element("div").classes("title"):
                ui.label(title).classes("name")
                self._fact = ui.label("").classes("facts number")
            self._slot = ui.element("div").classes("plot-slot")
        self._chart: ui.echart | None = None
        self._name = name

    def show(self, picture: Picture | None) -> None:
        """Bring the chart up to date."""
        if picture is None:
            return
        if self._fact.text != picture.fact:
            self._fact.set_text(picture.fact)
        kind = (picture.x.name, picture.y.name, *((one.name, one.kind, one.color) for one in picture.traces))
        if kind != self._kind or self._chart is None:
            self._kind = kind
            self._build(picture)
        elif self._ready:
            self._tell(picture)

    def _build(self, picture: Picture) -> None:
        self._ready, self._told = False, ""
        self._slot.clear()
        names = ", ".join(trace.name for trace in picture.traces)
        with self._slot:
            options = layout(picture, f"{self._title}: {picture.y.name} against {picture.x.name}, {names}.")
            chart = ui.echart(options, renderer="svg").classes("plot").mark(f"chart-{self._name}")
        chart.on("chart:rendered", self._is_ready, args=[], throttle=1e6, trailing_events=False)
        self._chart, self.shown = chart, filled(picture)

    def _is_ready(self) -> None:
        self._ready = True

    def _tell(self, picture: Picture) -> None:
        assert self._chart is not None
        option = filled(picture)
        # Functions were said when the chart was made.
        option["series"] = [{"data": series["data"]} for series in option["series"]]
        text = json.dumps(option)
        if text != self._told:
            self._told, self.shown = text, option
            self._chart.run_chart_method("setOption", option)
