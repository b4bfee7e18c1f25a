"""The controls of a game of pong: who plays, how fast, how long, and on which table."""

from __future__ import annotations

from collections import defaultdict
from typing import Any, Final, Literal

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.asked import Asked
from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.wording import number
from gasbox.app.worlds.live_values import LiveValues
from gasbox.app.worlds.panel import Send
from gasbox.app.worlds.pong_tables import TableMenu
from gasbox.scenario.pong import Pong
from gasbox.state import SetWorld

__all__ = ["PongPanel"]

_PLAYERS: Final = {"human": "You", "easy": "Easy", "medium": "Medium", "hard": "Hard"}
_LENGTHS: Final = (1, 3, 5, 7, 11, 15, 21)
_FRESH_FRAMES: Final = 120
"""So many frames old, a game has only begun."""
_SLIDER_FACTOR: Final = 2.5
"""Sliders of speeds go from what the scenario says over this to what it says times this."""


class PongPanel:
    """Players, points, speeds, and buttons; what belongs to the table itself is in a menu, and begins a new game."""

    charts: Literal["none", "own", "all"] = "none"

    def __init__(self, session: Session, send: Send, charts: ui.element) -> None:
        world = session.scenario.world
        assert isinstance(world, Pong)
        self._send, self._session = send, session
        self._waits = session.playing
        start = {name: getattr(world, name) for name in ("points", "ball_speed", "paddle_speed")}
        self._values = LiveValues({**start, "left": world.players.left, "right": world.players.right})
        self._shown: dict[str, Any] = {}
        self._showing = False
        self._readings: dict[str, ui.label] = {}
        self._controls: dict[str, Any] = {}
        self._asked: defaultdict[str, Asked] = defaultdict(Asked)
        with ui.element("div").classes("pong"):
            self._players("left", "Left")
            if world.right is not None:
                self._players("right", "Right")
            self._pace("ball_speed", "Ball", world.ball_speed)
            self._pace("paddle_speed", "Bats", world.paddle_speed)
            self._length(world.points, "to {}" if world.right is not None else "{} balls")
            self._buttons(session)

    def _players(self, side: str, name: str) -> None:
        with ui.element("div").classes("player"):
            ui.label(name).classes("word")
            choice = ui.toggle(dict(_PLAYERS), on_change=lambda event: self._chosen(side, event))
            choice.props(f'unelevated no-caps toggle-color=primary aria-label="Who plays on the {side}"')
            self._controls[side] = choice.mark(f"pong-{side}")

    def _pace(self, name: str, label: str, usual: float) -> None:
        with ui.element("div").classes("pace-of"):
            with ui.element("div"):
                ui.label(label).classes("word").style("display:inline")
                self._readings[name] = ui.label().classes("word number").style("display:inline;float:right")
            slider = ui.slider(
                min=usual / _SLIDER_FACTOR,
                max=usual * _SLIDER_FACTOR,
                step=usual / 50,
                on_change=lambda event: self._chosen(name, event),
            )
            slider.props(f'dense aria-label="Speed: {label.lower()}"').mark(f"pong-{name}")
            self._controls[name] = slider

    def _length(self, usual: int, wording: str) -> None:
        self._wording = wording
        choice = ui.select(
            {points: wording.format(points) for points in sorted({*_LENGTHS, usual})},
            on_change=lambda event: self._chosen("points", event),
        )
        choice.props('dense outlined options-dense aria-label="How long a game is"').classes("points")
        self._controls["points"] = choice.mark("pong-points")

    def _buttons(self, session: Session) -> None:
        with ui.element("div").classes("doing"):
            TableMenu(session, self._kept)
            self._sound()
            self._serve = ui.button("Serve", on_click=lambda: self._send(SetWorld("serve", True)), color=None)
            self._serve.props("flat dense no-caps").classes("quiet").mark("pong-serve")
            self._serve.tooltip("Serve at once  Space")
            again = ui.button("New game", on_click=lambda: self._send(SetWorld("restart", True)))
            again.props("unelevated dense no-caps color=primary").style("padding:2px 12px").mark("pong-again")

    @staticmethod
    def _sound() -> None:
        # Only the browser knows; `frontend/core/worlds/sounds.js` listens to the attribute.
        button = ui.button(color=None).props("flat round dense data-gasbox-sound aria-pressed=false")
        button.props('aria-label="Sound"').classes("quiet").mark("pong-sound")
        with button:
            ui.icon("volume_up").classes("sound-on")
            ui.icon("volume_off").classes("sound-off")
            ui.tooltip("Sound on or off  M")

    def _kept(self) -> dict[str, Any]:
        """What goes on in a new game on another table."""
        shown = self._shown
        return {"players": (shown.get("left"), shown.get("right", "medium")), "points": shown.get("points")}

    def show(self, sample: Sample) -> None:
        """Show the settings as they are now."""
        self._wait_for_people(sample)
        self._showing = True
        for name, control in self._controls.items():
            value = self._values.of(name, sample)
            if value is None or value == self._shown.get(name) or self._asked[name].is_old(value):
                continue
            self._shown[name] = value
            if name == "points" and value not in control.options:
                control.set_options({**control.options, value: self._wording.format(value)})
            control.set_value(value)
            if name in self._readings:
                self._readings[name].set_text(number(float(value)))
        self._showing = False
        serving = sample.world.get("phase") == "serve"
        if self._serve.enabled != serving:
            self._serve.set_enabled(serving)

    def _wait_for_people(self, sample: Sample) -> None:
        """A game in which somebody plays begins when that somebody says so."""
        if self._waits:
            self._waits = False
            if sample.frame < _FRESH_FRAMES and "human" in sample.world.get("players", {}).values():
                self._session.pause()

    def _chosen(self, name: str, event: ValueChangeEventArguments[Any]) -> None:
        if self._showing or event.value is None:
            return
        self._asked[name].ask(event.value)
        self._shown[name] = event.value
        if name in self._readings:
            self._readings[name].set_text(number(float(event.value)))
        self._send(SetWorld(name, event.value))
