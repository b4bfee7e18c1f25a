"""The row under the box for a world: the controls of whichever it is, and its charts."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import ui

from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.worlds import PANELS
from gasbox.app.worlds.panel import Ending, Send, WorldPanel
from gasbox.scenario import Scenario

__all__ = ["WorldRow"]


class WorldRow:
    """Empty and out of sight where there is no world.

    Parameters
    ----------
    arrange : called with which charts are seen, whenever there is another world or none
    """

    def __init__(self, session: Session, send: Send, arrange: Callable[[str], None]) -> None:
        self._session, self._send, self._arrange = session, send, arrange
        self._scenario: Scenario | None = None
        self.panel: WorldPanel | None = None
        self._charts: ui.element | None = None
        with (
            ui.element("section")
            .classes("card world")
            .props('aria-label="World"')
            .mark("world") as self._root
        ):
            pass
        self._root.set_visibility(False)

    def build_charts(self) -> None:
        """Take the place in the column of charts that is open now."""
        self._charts = ui.element("div").classes("world-charts")

    def show(self, sample: Sample) -> None:
        """Show the world as it is now; other controls for another scenario."""
        if sample.scenario is not self._scenario:
            self._build(sample.scenario)
        if self.panel is not None:
            self.panel.show(sample)

    def _build(self, scenario: Scenario) -> None:
        if isinstance(self.panel, Ending):
            self.panel.end()
        before, self._scenario = self._scenario, scenario
        self._root.clear()
        self.panel = None
        assert self._charts is not None
        self._charts.clear()
        kind = None if scenario.world is None else scenario.world.kind
        if kind in PANELS:
            with self._root:
                self.panel = PANELS[kind](self._session, self._send, self._charts)
        self._root.set_visibility(self.panel is not None)
        if before is None or kind != (before.world and before.world.kind):
            self._arrange("all" if self.panel is None else self.panel.charts)
