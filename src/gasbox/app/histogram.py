"""The histogram of one kind of particle on the page, with the curve that theory expects."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np
from nicegui import ui
from nicegui.events import GenericEventArguments
from numpy.typing import NDArray

from gasbox.app.bins import ROTATION, BinChoice, Law, curve, expected
from gasbox.app.ceiling import Ceiling, interval
from gasbox.app.chart_options import bar_rows, changes, curve_rows, initial, value_axis
from gasbox.app.smoothing import Smoothing
from gasbox.app.wording import whole
from gasbox.observe import Histogram as Counts
from gasbox.scenario import Kind

__all__ = ["Histogram", "Pointed"]

Pointed = Callable[[int, int | None], None]
"""Called with the species and the bin that the pointer has come to, or None when it has left."""


class Histogram:
    """A chart with its title.

    Attributes
    ----------
    index, kind : whose histogram this is
    edges : (bins+1,) float64, as shown last
    ready : whether the browser has drawn the chart, so that it can take changes
    """

    def __init__(self, index: int, kind: Kind, choice: BinChoice, pointed: Pointed) -> None:
        self.index = index
        self.kind = kind
        self.ready = False
        self.edges = np.linspace(0.0, 1.0, choice.count + 1)
        self._ceiling = Ceiling()
        self._smoothing = Smoothing()
        self._pointed = pointed
        options = initial(kind.name, str(kind.color), choice.quantity)
        with ui.element("section").classes("card histogram") as card:
            card.props["aria-label"] = f"Histogram of {kind.name}"
            with ui.element("div").classes("title"):
                ui.element("span").classes("dot").style(f"background:{kind.color}")
                ui.label(kind.name).classes("name")
                self._facts = ui.label("").classes("facts number").mark(f"facts-{index}")
            self.chart = ui.echart(options, renderer="svg").classes("plot").mark(f"histogram-{index}")
        self._listen()

    def _listen(self) -> None:
        # The throttle lets only the first of many events through.
        self.chart.on("chart:rendered", self._is_ready, args=[], throttle=1e6, trailing_events=False)
        self.chart.on("chart:highlight", self._entered, args=["batch"])
        for left in ("chart:downplay", "chart:globalout"):
            self.chart.on(left, lambda: self._pointed(self.index, None), args=[])

    def _is_ready(self) -> None:
        self.ready = True

    def _entered(self, event: GenericEventArguments) -> None:
        arguments = event.args if isinstance(event.args, dict) else {}
        for item in arguments.get("batch") or []:
            if item.get("seriesIndex") == 0 and isinstance(item.get("dataIndex"), int):
                self._pointed(self.index, item["dataIndex"])

    def smooth(self, window: float) -> None:
        """Choose how long to average [s]."""
        self._smoothing.choose(window)

    def forget(self) -> None:
        """Another gas, or other bins."""
        self._smoothing.forget()
        self._ceiling.forget()

    def show(self, seen: Counts, choice: BinChoice, theory: bool, law: Law | None) -> None:
        """Bring the chart up to date with what was counted, and with the law that it should follow."""
        now = time.monotonic()
        self.edges = seen.edges
        row = self._smoothing.mean(now, np.array([seen.underflow, *seen.counts, seen.overflow]))
        total = round(seen.total)
        wanted = self._wanted(now, row[1:-1], total, choice, theory, law)
        option = changes(self.chart.options, wanted)
        if option and self.ready:
            self.chart.run_chart_method("setOption", option)
        self._write_facts(total, round(float(row[0])), round(float(row[-1])), choice)

    def _wanted(
        self,
        now: float,
        counts: NDArray[np.float64],
        total: int,
        choice: BinChoice,
        theory: bool,
        law: Law | None,
    ) -> dict[str, Any]:
        wanted, line = None, None
        if law is not None and total:
            wanted = expected(self.edges, choice.quantity, total, law)
            line = curve(self.edges, choice.quantity, total, law) if theory else None
        highest = max(float(counts.max(initial=0.0)), 0.0 if line is None else float(line[1].max()))
        top = self._ceiling.cover(now, highest)
        return {
            "xAxis": value_axis(float(self.edges[0]), float(self.edges[-1]), choice.quantity),
            "yAxis": {"max": top, "interval": interval(top)},
            "series": [
                {"data": bar_rows(self.edges, counts, wanted)},
                {"data": [] if line is None else curve_rows(*line)},
            ],
        }

    def _write_facts(self, total: int, below: int, beyond: int, choice: BinChoice) -> None:
        still = choice.quantity in ROTATION and self.kind.inertia == 0.0
        parts = ["does not turn" if still else f"N = {whole(total)}"]
        if below:
            parts.append(f"{whole(below)} below the range")
        if beyond:
            parts.append(f"{whole(beyond)} beyond the range")
        text = " · ".join(parts)
        if self._facts.text != text:
            self._facts.set_text(text)
