"""The histograms beside the box: one for each kind of particle, all cut the same way."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from nicegui import ui

from gasbox.app.bins import BinChoice, Law, automatic_ends, edges_of, law_of
from gasbox.app.histogram import Histogram
from gasbox.app.sample import Sample
from gasbox.observe import Histogram as Counts
from gasbox.observe import histogram
from gasbox.scenario import Kind

__all__ = ["MOST_CHARTS", "Charts", "Counted"]

MOST_CHARTS = 6
"""Histograms that have room on the page."""

Counted = tuple[Counts, Law | None]
"""What was counted of one kind, and the law that it should follow."""
Lit = Callable[[int, float, float], None]


class Charts:
    """All histograms, and how they are cut.

    Parameters
    ----------
    light : called with species, low and high end of the bin that is pointed at
    dim : called when no bin is pointed at any more

    Attributes
    ----------
    choice : the bins as chosen
    theory : whether the curves are shown
    window : how long to average [s]
    """

    def __init__(self, kinds: Sequence[Kind], choice: BinChoice, light: Lit, dim: Callable[[], None]) -> None:
        self.choice = choice
        self.theory = True
        self.window = 0.0
        self._light = light
        self._dim = dim
        self._lit: tuple[int, int] | None = None
        self._shown: tuple[Any, ...] = ()
        self._temperature: float | None = None
        self._automatic: list[float] = []
        self._root = ui.element("div").classes("contents")
        self.histograms: list[Histogram] = []
        self.build(kinds, choice)

    def build(self, kinds: Sequence[Kind], choice: BinChoice) -> None:
        """Make the charts of these kinds of particle, in place of the old ones."""
        self.choice, self._kinds = choice, kinds
        self._root.clear()
        with self._root:
            shown = enumerate(kinds[:MOST_CHARTS])
            self.histograms = [Histogram(index, one, choice, self._pointed) for index, one in shown]
        self.smooth(self.window)
        self.forget()

    def choose(self, choice: BinChoice) -> None:
        """Cut the bins anew."""
        if choice.quantity != self.choice.quantity:
            self.build(self._kinds, choice)
            return
        self.choice = choice
        self.forget()

    def smooth(self, window: float) -> None:
        """Average over so many seconds [s]."""
        self.window = window
        self._shown = ()
        for chart in self.histograms:
            chart.smooth(window)

    def show_theory(self, shown: bool) -> None:
        """Switch the curves on or off."""
        self.theory = shown
        self._shown = ()

    def forget(self) -> None:
        """Another gas: averages and axes start anew."""
        self._shown = ()
        self._temperature = None
        for chart in self.histograms:
            chart.forget()

    def count(self, sample: Sample, temperature: float | None) -> list[Counted]:
        """Count all particles; nothing if nothing has changed. Touches no element, so any thread may call it."""
        ready = sum(chart.ready for chart in self.histograms)
        state = (sample.version, sample.frame, ready)
        if state == self._shown:
            return []
        self._shown = state
        every = edges_of(self.choice, self._ends(sample, temperature or 0.0))
        quantity = self.choice.quantity
        return [
            (histogram(sample.state, index, edges, quantity), law_of(sample, quantity, index, temperature))
            for index, edges in enumerate(every)
        ]

    def show(self, counts: list[Counted]) -> None:
        """Bring the charts up to date with what `count` has found."""
        for chart, (counted, law) in zip(self.histograms, counts, strict=False):
            chart.show(counted, self.choice, self.theory, law)

    def _ends(self, sample: Sample, temperature: float) -> list[float]:
        """The automatic ends of the axes; they stay while the temperature changes little."""
        old = self._temperature
        if old is None or not 0.7 * old <= temperature <= 1.4 * old:
            self._temperature = temperature
            self._automatic = automatic_ends(sample, self.choice.quantity, len(self.histograms))
        return self._automatic

    def _pointed(self, index: int, place: int | None) -> None:
        """The pointer has come to a bin, or left."""
        if place is None:
            if self._lit is not None and self._lit[0] == index:
                self._lit = None
                self._dim()
            return
        edges = self.histograms[index].edges
        if place + 1 < len(edges) and self._lit != (index, place):
            self._lit = (index, place)
            self._light(index, float(edges[place]), float(edges[place + 1]))
