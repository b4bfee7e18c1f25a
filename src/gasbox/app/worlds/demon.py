"""The panel of a demon: its rule under the box, its books and what became of both sides beside it."""

from __future__ import annotations

from collections import defaultdict
from typing import Any, Final, Literal

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.asked import Asked
from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.study_chart import StudyChart
from gasbox.app.wording import number
from gasbox.app.worlds.demon_books import BOOKS, PICTURES, written
from gasbox.app.worlds.panel import Send
from gasbox.state import SetWorld

__all__ = ["DemonPanel", "meaning"]

_RULES: Final = {
    "speed": "Speed",
    "species": "Kind",
    "direction": "One way",
    "none": "Open",
    "closed": "Closed",
}
_TO: Final = {"left": "to the left", "right": "to the right", "below": "down", "above": "up"}
_ENDS: Final = (0.2, 2.5)
"""Of the slider, in units of the threshold at the start."""


def meaning(view: dict[str, Any]) -> str:
    """What the rule means, in a few words; `view` as the world shows it."""
    near, far = (_TO[side] for side in (view["sides"][::-1] if view["reversed"] else view["sides"]))
    match view["rule"]:
        case "speed":
            return f"fast {far}, slow {near}"
        case "species":
            return f"{view['species']} {far}, others {near}"
        case "direction":
            return f"only {far}"
        case "closed":
            return "nobody passes: nothing is decided"
    return "everybody passes: nothing is decided"


def _told(value: Any) -> Any:
    """As a control tells it: of a number no more digits than a slider has."""
    return round(value, 6) if isinstance(value, float) else value


class DemonPanel:
    """By what it decides, its threshold or species, and the other way round; charts in the element `charts`."""

    charts: Literal["none", "own", "all"] = "own"

    def __init__(self, session: Session, send: Send, charts: ui.element) -> None:
        self._send = send
        self._kinds = [kind.name for kind in session.scenario.kinds]
        self._showing = False
        self._asked: defaultdict[str, Asked] = defaultdict(Asked)
        self._version = -1
        self._usual: float | None = None
        with ui.element("div").classes("demon"):
            self._build()
        self._figures: dict[str, ui.label] = {}
        with charts:
            with (
                ui.element("section")
                .classes("card figures demon-books")
                .props('aria-label="The books of the demon"')
            ):
                for name, (title, hint) in BOOKS.items():
                    with ui.element("div").classes("figure") as figure:
                        figure.tooltip(hint)
                        ui.label(title).classes("name")
                        self._figures[name] = ui.label("–").classes("value number").mark(f"demon-{name}")
            with ui.element("div").classes("demon-plots"):
                self._charts = {
                    name: StudyChart(f"demon-{name}", title) for name, (title, _) in PICTURES.items()
                }

    def _build(self) -> None:
        self._rule = ui.toggle(dict(_RULES), on_change=lambda event: self._chosen("rule", event))
        self._rule.props('unelevated no-caps toggle-color=primary aria-label="By what the demon decides"')
        self._rule.mark("demon-rule")
        with ui.element("div").classes("pace-of") as self._speed:
            with ui.element("div"):
                ui.label("Fast is above").classes("word").style("display:inline")
                self._reading = ui.label().classes("word number").style("display:inline;float:right")
            self._slider = ui.slider(
                min=0.1, max=3.0, step=0.01, on_change=lambda event: self._chosen("threshold", event)
            )
            self._slider.props('dense aria-label="Speed above which a disc is fast"').mark("demon-threshold")
        self._species = ui.select(self._kinds, on_change=lambda event: self._chosen("species", event))
        self._species.props('dense outlined options-dense aria-label="Kind that is let through one way"')
        self._species.classes("kinds").mark("demon-species")
        self._swap = ui.button(icon="swap_horiz", on_click=self._turn, color=None)
        self._swap.props('flat round dense aria-label="The other way round"').mark("demon-reversed")
        self._swap.tooltip("The other way round")
        self._says = ui.label().classes("hint").mark("demon-says")
        self._reversed = False

    def show(self, sample: Sample) -> None:
        """Show the rule as it is now, the books, and the charts."""
        view = sample.world
        if "rule" not in view:
            return
        if sample.version != self._version:
            self._version, self._usual = sample.version, None
        self._showing = True
        self._show_rule(view)
        self._showing = False
        for name, text in written(view).items():
            if self._figures[name].text != text:
                self._figures[name].set_text(text)
        for name, (_, picture) in PICTURES.items():
            self._charts[name].show(picture(view, sample.series))

    def _show_rule(self, view: dict[str, Any]) -> None:
        if self._usual is None:
            self._usual = float(view["threshold"])
            low, high = (end * self._usual for end in _ENDS)
            self._slider.props(f"min={low:.4g} max={high:.4g} step={self._usual / 50:.3g}")
        if not self._asked["reversed"].is_old(bool(view["reversed"])):
            self._reversed = bool(view["reversed"])
        controls = {"rule": self._rule, "threshold": self._slider, "species": self._species}
        for name, control in controls.items():
            value = _told(view[name])
            if control.value != value and not self._asked[name].is_old(value):
                control.set_value(value)
        self._reading.set_text(number(float(view["threshold"])))
        self._says.set_text(meaning(view))
        self._speed.set_visibility(view["rule"] == "speed")
        self._species.set_visibility(view["rule"] == "species")
        self._swap.set_visibility(view["rule"] in ("speed", "species", "direction"))

    def _chosen(self, name: str, event: ValueChangeEventArguments[Any]) -> None:
        if not self._showing and event.value is not None:
            self._asked[name].ask(_told(event.value))
            self._send(SetWorld(name, event.value))

    def _turn(self) -> None:
        self._reversed = not self._reversed
        self._asked["reversed"].ask(self._reversed)
        self._send(SetWorld("reversed", self._reversed))
