"""The panel of an epidemic: measures under the box, curves and numbers beside it, and two runs compared."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Iterator
from typing import Any, Literal

from nicegui import background_tasks, ui

from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.tandem import Encore
from gasbox.app.worlds.epidemic import options
from gasbox.app.worlds.epidemic.course import Course, chosen, marks
from gasbox.app.worlds.epidemic.dials import dials
from gasbox.app.worlds.epidemic.figures import Numbers
from gasbox.app.worlds.epidemic.measures import Measures, settings_of
from gasbox.app.worlds.epidemic.pair import Pair
from gasbox.app.worlds.epidemic.plot import Plot
from gasbox.app.worlds.panel import Send
from gasbox.errors import GasboxError
from gasbox.scenario import Scenario
from gasbox.scenario.epidemic import Epidemic
from gasbox.state import SetWorld

__all__ = ["EpidemicPanel"]

_SLOW = 30.0
"""Frames per second below which charts are drawn half as often: the boxes come first."""


class EpidemicPanel:
    """Sliders in the slot that is open, charts in the element `charts`.

    There is one run; or it and an earlier one that was kept; or two that run beside each other.
    """

    charts: Literal["none", "own", "all"] = "own"

    def __init__(self, session: Session, send: Send, charts: ui.element) -> None:
        self._session, self._send = session, send
        self._measures: Measures | None = None
        self._version = -1
        self._beats = 0
        self._kept: Course | None = None
        self._encore: Encore | None = None
        """Of a run beside one that was kept: its measures last when it begins anew."""
        self._last: Course | None = None
        self.pair: Pair | None = None
        self._busy = self._ended = False
        with ui.element("div").classes("epidemic") as self._root:
            self._build_head()
            self._slot = ui.element("div").classes("measures")
        with charts:
            self.numbers = Numbers()
            self._plots: dict[str, Plot] = {}
            self._slots = ui.element("div").classes("epidemic-plots")
        self._arrange()

    # -- building ------------------------------------------------------------------------------------------------

    def _build_head(self) -> None:
        with ui.element("div").classes("epidemic-head") as self._head:
            self._whose = (
                ui.toggle({"a": "A", "b": "B"}, value="b", on_change=self._turned)
                .props('dense unelevated no-caps aria-label="Whose measures the sliders show and set"')
                .classes("whose")
                .mark("whose")
            )
            self._say = ui.label("").classes("hint say").mark("compare-say")
            self._keep = self._button("push_pin", "Keep curve", "keep", self.keep)
            self._keep.tooltip("Keep this run's curve as A, and begin again from the same seed as B")
            self._side = self._button("compare", "Side by side", "side-by-side", self.side_by_side)
            self._side.tooltip("A second box from the same seed, with measures of its own")
            self._end = self._button("close", "End comparison", "end-compare", self.alone)

    @staticmethod
    def _button(icon: str, text: str, mark: str, action: Any) -> ui.button:
        button = ui.button(text, icon=icon, on_click=action, color=None).props("flat dense no-caps")
        return button.classes("compare-button").mark(mark)

    def _build(self, scenario: Scenario, view: dict[str, Any]) -> None:
        people, counts = int(view["people"]), view["counts"]
        colors = {kind.name: kind.color for kind in scenario.kinds}
        with self._slot:
            self._measures = Measures(dials(Epidemic.SETTINGS, settings_of(view), people), self._choose)
        with self._slots:
            self._plots = {
                "runs": Plot("runs", "Infected people", options.runs),
                "stages": Plot("stages", "Everybody", lambda: options.stages(list(counts), colors, people)),
                "spread": Plot("spread", "Reproduction number", options.spread),
            }
        self._arrange()

    def _arrange(self) -> None:
        """Show what belongs to one run, to a kept one, or to two."""
        comparing = self._kept is not None or self.pair is not None
        self._head.classes(add="comparing" if comparing else None, remove=None if comparing else "comparing")
        self._whose.set_visibility(self.pair is not None)
        self._end.set_visibility(comparing)
        self._keep.set_visibility(self.pair is None)
        self._side.set_visibility(self.pair is None)
        if "runs" in self._plots:
            self._plots["runs"].see(comparing)
        self._say.set_text(
            "Same seed. Set the measures of A and of B, then play."
            if self.pair is not None
            else "A is kept. Set other measures, then play."
            if self._kept is not None
            else ""
        )

    # -- what is asked for ---------------------------------------------------------------------------------------

    def _choose(self, name: str, value: float) -> None:
        change = SetWorld(name, value)
        if self._encore is not None:
            self._encore.settings[name] = value
        whose = self._session if self.pair is None else self.pair.choose(str(self._whose.value), name, value)
        if whose is self._session:
            self._send(change)
        else:
            background_tasks.create(self._send_second(whose, change), name="change of run B")

    async def _send_second(self, second: Session, change: SetWorld) -> None:
        try:
            await asyncio.wrap_future(second.change(change))
        except (GasboxError, asyncio.CancelledError) as error:
            self._tell(str(error) or "The second run has ended.")

    def _turned(self) -> None:
        if self._measures is not None:
            self._measures.forget()

    def _tell(self, text: str) -> None:
        with self._root:
            ui.notify(text, type="warning")

    async def keep(self) -> None:
        """Keep the curve of this run, and begin again from the same seed, paused, with the measures as they are set."""
        if self._last is None or self._busy:
            return
        kept = self._last
        with self._occupied():
            chosen_by_hand = await self._chosen()
            if self._ended:
                return
            self._encore = Encore(self._session, chosen_by_hand)
            self._session.show.partner = self._encore
            self._session.pause()
            await asyncio.wrap_future(self._session.reset())
            if not self._ended:
                self._kept = kept
                self._arrange()

    @contextlib.contextmanager
    def _occupied(self) -> Iterator[None]:
        """While this lasts nothing else is begun; what goes wrong in it is told, and the page goes on."""
        self._busy = True
        try:
            yield
        except (GasboxError, TimeoutError) as error:
            text = str(error) or "it took too long"
            self._tell(f"{text[:1].upper()}{text[1:]}.")
        finally:
            self._busy = False

    async def _chosen(self) -> dict[str, float]:
        """Settings that were changed by hand in this run."""
        session = self._session
        changes = await asyncio.wrap_future(session.ask(lambda: tuple(session.show.simulation.changes)))
        return chosen(changes, session.scenario.schedule)

    async def side_by_side(self) -> None:
        """Open the second box: A as the scenario says, B with the measures as they are set."""
        if self._busy or self.pair is not None:
            return
        self._forget_kept()
        with self._occupied(), self._root:
            pair = await Pair.opened(self._session, await self._chosen())
            if self._ended:
                await pair.end()
                return
            self.pair = pair
        self._turned()
        self._arrange()

    async def alone(self) -> None:
        """Back to one run."""
        self._forget_kept()
        await self._part()
        self._turned()
        self._arrange()

    def _forget_kept(self) -> None:
        self._kept = None
        if self._encore is not None:
            self._session.show.partner = self._encore = None

    async def _part(self) -> None:
        pair, self.pair = self.pair, None
        if pair is not None:
            await pair.end()

    def end(self) -> None:
        """Another scenario has come."""
        self._ended = True
        self._forget_kept()
        if self.pair is not None:
            background_tasks.create(self._part(), name="end of run B")

    # -- what is shown -------------------------------------------------------------------------------------------

    def show(self, sample: Sample) -> None:
        """Bring sliders, numbers and charts up to date."""
        view = sample.world
        if not view:
            return
        if self._measures is None:
            self._build(sample.scenario, view)
        assert self._measures is not None
        other = None if self.pair is None else self.pair.sample()
        theirs = view if other is None or self._whose.value == "a" else other.world
        self._measures.show(settings_of(theirs), theirs.get("active", {}))
        if self._version != sample.version:
            self._version = sample.version
            self._beats = 0
        self._beats += 1
        struggles = sample.playing and 0 < sample.shown_fps < _SLOW
        if self._beats % (4 if struggles else 2) == 1:
            self._draw(sample, other)

    def _draw(self, sample: Sample, other: Sample | None) -> None:
        course = Course.of(sample.world, sample.series)
        self._last = course
        first, second, shown, whose = course, None, sample, ""
        if self._kept is not None:
            first, second, whose = self._kept, course, "run B"
        elif other is not None and other.world:
            second = Course.of(other.world, other.series)
            whose = f"run {str(self._whose.value).upper()}"
            shown = other if self._whose.value == "b" else sample
        self.numbers.show(first, second)
        world = sample.scenario.world
        day = world.day if isinstance(world, Epidemic) else 1.0
        self._plots["stages"].tell(options.stages_now(shown.series, marks(shown.changes, day)), whose)
        self._plots["spread"].tell(options.spread_now(first, second))
        if second is not None:
            self._plots["runs"].tell(options.runs_now(first, second), "A solid, B dashed")
