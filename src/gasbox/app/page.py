"""The page of one browser tab: the box, its histograms, the controls, and the beat that keeps them up to date."""

from __future__ import annotations

import json
import time
from pathlib import Path

from nicegui import background_tasks, run, ui
from nicegui.events import GenericEventArguments

from gasbox.app.aims import has_forces
from gasbox.app.bins import BinChoice
from gasbox.app.chart_settings import ChartSettings
from gasbox.app.charts import Charts, Counted
from gasbox.app.dialogs import keys_dialog
from gasbox.app.figures import Figures, figures
from gasbox.app.files import Files
from gasbox.app.header import Actions, Header
from gasbox.app.look_control import LookControl
from gasbox.app.matter import Matter
from gasbox.app.panel import Panel
from gasbox.app.readouts import Readouts
from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.shortcuts import SHORTCUTS, action_of
from gasbox.app.stage import Caption, Stage
from gasbox.app.studies import Studies
from gasbox.app.surroundings import Surroundings
from gasbox.app.transport import Transport
from gasbox.app.window import SlidingWindow
from gasbox.app.world_row import WorldRow

__all__ = ["BEAT", "Page", "build"]

BEAT = 0.25
"""Seconds between two updates of charts and numbers."""
_ASSETS = Path(__file__).parent / "assets"
_SLOW = 30.0
"""Frames per second below which the browser gets new histograms only at every third beat: the box comes first."""
_MANY = 20_000
"""So many particles are counted in a thread, so that frames keep flowing."""
_MANY_WITH_FORCES = 1_000
"""The same where neighbours are looked for as well."""


def build(session: Session) -> Page:
    """Build the page of one tab; ``?charts=0`` in the address leaves the histograms out."""
    request = ui.context.client.request
    return Page(session, charts=request is None or request.query_params.get("charts") != "0")


class Page:
    """All parts of the page, and what happens between them."""

    def __init__(self, session: Session, *, charts: bool = True) -> None:
        self.session = session
        self._window = SlidingWindow()
        self._scenario = session.scenario
        self._version = -1
        self._visible = True
        self._beating = False
        self._beats = 0
        self._dark = ui.dark_mode(None)
        self._keys = keys_dialog()
        self.files = Files(session, self._redraw)
        self.panel = Panel(session.scenario, self.files.apply)
        self._build_bar()
        self._build_lab()
        self._show_charts = True
        self._charts_wanted = charts
        if not charts:
            self.toggle_charts()
        self._listen()
        self._timer = ui.timer(BEAT, self.beat)

    # -- building ------------------------------------------------------------------------------------------------

    def _build_bar(self) -> None:
        actions = Actions(
            self.files,
            self.panel.toggle,
            self._keys.open,
            self.toggle_charts,
            self.toggle_dark,
            lambda: self.surroundings.toggle(),
        )
        self.header = Header(self.session.scenario, actions)

    def _build_lab(self) -> None:
        scenario = self.session.scenario
        choice = BinChoice.of(scenario)
        with ui.element("main").classes("lab") as self._lab:
            with ui.element("div").classes("stage"):
                self.caption = Caption(lambda: self.session.follow(None))
                with self.caption.root:
                    self.looks = LookControl(self.session)
                self.stage = Stage(self.session, self.session.follow)
                self.surroundings = Surroundings(self.session)
                self.matter = Matter(self.surroundings.send)
                self.world = WorldRow(self.session, self.surroundings.send, self._choose_charts)
                self.transport = Transport(self.session)
                self.readouts = Readouts(scenario)
            with ui.element("div").classes("charts"):
                self.chart_settings = ChartSettings(
                    choice,
                    lambda: self.charts,
                    self._redraw,
                    lambda: self.studies,
                    molecules=bool(scenario.molecules),
                )
                self.world.build_charts()
                with ui.element("div").classes("histograms"):
                    self.charts = Charts(scenario.kinds, choice, self._light, self.session.clear_highlight)
                    self.studies = Studies(self.session, self._arrange)
        self.caption.show(scenario, ())
        self._arrange()

    def _listen(self) -> None:
        keys = [key for shortcut in SHORTCUTS for key in shortcut.keys if not shortcut.holds]
        holds = {key: shortcut.holds for shortcut in SHORTCUTS for key in shortcut.keys if shortcut.holds}
        settings = json.dumps({"keys": keys, "holds": holds, "upload": self.files.upload.id})
        ui.add_css(_ASSETS / "page.css")
        ui.add_css(_ASSETS / "worlds.css")
        ui.add_css(_ASSETS / "epidemic.css")
        ui.add_body_html(
            f"<script>window.gasboxPage = {settings};\n{(_ASSETS / 'page.js').read_text()}</script>"
        )
        ui.label("Drop a scenario or a snapshot here").classes("drop-hint").props('aria-hidden="true"')
        ui.on("gasbox_key", lambda event: self.press(str(event.args)))
        ui.on("gasbox_hold", lambda event: self.matter.hold(str(event.args)))
        ui.on("gasbox_visible", self._seen)

    def _arrange(self) -> None:
        """Make room for as many charts as there are."""
        many = len(self.charts.histograms) + len(self.studies.charts) > 3
        self._lab.classes(add="many") if many else self._lab.classes(remove="many")
        self.chart_settings.menu.refresh()

    # -- what happens --------------------------------------------------------------------------------------------

    async def beat(self) -> None:
        """Bring charts, numbers and controls up to date, unless that is being done."""
        if self._visible and not self._beating:
            self._beating = True
            try:
                await self._update()
            finally:
                self._beating = False

    async def _update(self) -> None:
        sample = self.session.sample()
        self.transport.refresh()
        self.looks.show()
        if sample is None:
            return
        self.stage.settle()
        if sample.version != self._version:
            self._changed(sample)
        self.surroundings.show(sample)
        self.world.show(sample)
        self.studies.fit(sample)
        self.transport.show_reached(sample.keeping_up or not sample.playing, sample.speed_reached)
        self.caption.follow(self.session.followed(), sample.scenario)
        if sample.state.count > (_MANY_WITH_FORCES if has_forces(sample.scenario) else _MANY):
            measured = await run.io_bound(self._measure, sample)
        else:
            measured = self._measure(sample)
        if measured is not None and sample.version == self._version:
            numbers, counts = measured
            self.readouts.show(numbers, sample)
            self.matter.show(sample, numbers)
            self.charts.show(counts)
            if self._show_charts and self._beats % 2:
                self.studies.show()

    def _measure(self, sample: Sample) -> tuple[Figures, list[Counted]]:
        lately = self._window.take(
            time.monotonic(), sample.version, sample.time, sample.tallies, sample.state.wall_displacement
        )
        self.studies.take(sample, lately)
        numbers = figures(sample, lately)
        self._beats += 1
        struggles = sample.playing and 0 < sample.shown_fps < _SLOW and self._beats % 3
        if not self._show_charts or struggles:
            return numbers, []
        return numbers, self.charts.count(sample, numbers.temperature)

    def _changed(self, sample: Sample) -> None:
        """Another gas, or the same one from its start."""
        self._version = sample.version
        self.stage.open()
        self.caption.show(sample.scenario, sample.warnings)
        if sample.scenario is self._scenario:
            self.charts.forget()
            return
        self._scenario = sample.scenario
        choice = BinChoice.of(sample.scenario)
        self.chart_settings.show(choice, molecules=bool(sample.scenario.molecules))
        self.charts.build(sample.scenario.kinds, choice)
        self.header.show(sample.scenario)
        self.panel.show(sample.scenario)
        self._arrange()

    def _redraw(self) -> None:
        """Do not wait for the next beat."""
        background_tasks.create(self.beat(), name="redraw")

    def _light(self, species: int, low: float, high: float) -> None:
        self.session.highlight(species, low, high, self.charts.choice.quantity)

    def toggle_charts(self) -> None:
        """Show or leave out the charts."""
        self._show_charts = not self._show_charts
        self._lab.classes(remove="bare") if self._show_charts else self._lab.classes(add="bare")

    def _choose_charts(self, which: str) -> None:
        """Another world has come, or has gone: which charts are seen at first."""
        self._lab.classes(add="world-only") if which == "own" else self._lab.classes(remove="world-only")
        if self._show_charts == (which == "none") and self._charts_wanted:
            self.toggle_charts()

    async def toggle_dark(self) -> None:
        """From light to dark or back; at first the page follows the system."""
        dark = await ui.run_javascript("document.body.classList.contains('body--dark')")
        self._dark.set_value(not dark)

    def _seen(self, event: GenericEventArguments) -> None:
        self._visible = bool(event.args)

    async def press(self, key: str) -> None:
        """Do what a key stands for; `key` is the browser's name of it."""
        action = action_of(key)
        if action == "save":
            await self.files.save_snapshot()
        elif action == "open":
            ui.run_javascript(f"({self.files.pick})()")
        elif action == "theory":
            self.chart_settings.theory.set_value(not self.chart_settings.theory.value)
        elif action is not None:
            {
                "toggle": self.transport.toggle,
                "step": self.transport.step,
                "reset": self.transport.reset,
                "faster": self.transport.faster,
                "slower": self.transport.slower,
                "edit": self.panel.toggle,
                "gravity": self.surroundings.toggle_gravity,
                "divider": self.surroundings.toggle_divider,
                "coloring": self.looks.next_coloring,
                "bonds": self.looks.toggle_bonds,
                "unfollow": lambda: self.session.follow(None),
                "keys": self._keys.open,
            }[action]()
