"""The box with its particles, what to watch for above it, and what hides it while there is no gas yet."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from gasbox.app.canvas import LabCanvas
from gasbox.app.sample import Followed
from gasbox.app.session import Session
from gasbox.app.wording import number
from gasbox.scenario import Scenario

__all__ = ["Caption", "Stage"]


class Caption:
    """The sentence above the box, warnings, and the followed particle."""

    def __init__(self, unfollow: Callable[[], None]) -> None:
        with ui.element("div").classes("caption") as self.root:
            self._watch = ui.label().classes("watch").mark("watch-for")
            with ui.element("div").classes("followed").mark("followed") as self._followed:
                self._dot = ui.element("span").classes("dot")
                self._text = ui.label().classes("number").mark("followed-text")
                stop = ui.button(icon="close", on_click=unfollow, color=None).props(
                    'flat round dense size=sm aria-label="Stop following"'
                )
                stop.tooltip("Stop following  Esc")
        self._followed.set_visibility(False)
        self._notice = ui.label().classes("notice").props('role="status"').mark("warnings")
        self._notice.set_visibility(False)

    def show(self, scenario: Scenario, warnings: tuple[str, ...]) -> None:
        """What to watch for, and what the scenario is warned of."""
        if self._watch.text != scenario.watch_for:
            self._watch.set_text(scenario.watch_for)
            self._watch.props["title"] = scenario.watch_for
        self.warn(" ".join(f"{warning[:1].upper()}{warning[1:]}." for warning in warnings))

    def warn(self, text: str) -> None:
        """Say something that must not be overlooked; nothing hides it again."""
        if self._notice.text != text:
            self._notice.set_text(text)
            self._notice.set_visibility(bool(text))

    def follow(self, followed: Followed | None, scenario: Scenario) -> None:
        """Show the followed particle's numbers, or nothing."""
        if self._followed.visible != (followed is not None):
            self._followed.set_visibility(followed is not None)
        if followed is None:
            return
        species = scenario.kinds[followed.species]
        self._dot.style(f"background:{species.color}")
        text = f"{species.name} no. {followed.id} · speed {number(followed.speed)}{_turning(followed)}"
        if self._text.text != text:
            self._text.set_text(text)


def _turning(followed: Followed) -> str:
    """What a molecule has beside its speed."""
    had = followed.energies
    if had is None or had.rotational is None:
        return ""
    parts = [f"flight {number(had.translational)}", f"rotation {number(had.rotational)}"]
    if had.vibrational is not None:
        parts.append(f"vibration {number(had.vibrational)}")
    return f", angular velocity {number(had.angular_velocity)} · energy of {', '.join(parts)}"


class Stage:
    """The box itself, with a curtain before it while kernels are compiled, or no place is free."""

    def __init__(self, session: Session, pick: Callable[[int | None], None]) -> None:
        with (
            ui.element("div").classes("boxes").mark("boxes"),
            ui.element("section").classes("card box").props('aria-label="The box with its particles"'),
        ):
            self.canvas = LabCanvas(session, on_pick=pick, on_notice=self.hear).classes("canvas").mark("box")
            self.canvas.props(
                'role=img aria-label="Particles moving in the box; the numbers below describe them"'
            )
            with ui.element("div").classes("curtain").props('role="status"').mark("curtain") as self._curtain:
                self._heading = ui.label("Filling the box …").classes("heading")
                self._text = ui.label("").classes("text")
                self._progress = ui.linear_progress(value=0, show_value=False).props(
                    "rounded aria-label=Progress"
                )
                self._again = ui.button("Try again", on_click=ui.navigate.reload).props(
                    "unelevated color=primary"
                )
        self._progress.set_visibility(False)
        self._again.set_visibility(False)
        self._reason = "preparing"

    def hear(self, notice: dict[str, Any]) -> None:
        """What the server says to the box."""
        kind = notice.get("kind")
        self._reason = str(kind)
        if kind == "preparing":
            done, total = int(notice.get("done", 0)), max(int(notice.get("total", 1)), 1)
            first = notice.get("first", True)
            self._draw(
                "Compiling for this machine …" if first else "Loading …",
                f"Only at the first start: {done} of {total} done, now {notice.get('name', '')}."
                if first
                else "",
                done / total,
            )
        elif kind == "busy":
            places = int(notice.get("places", 0))
            taken = "Its only place is taken." if places == 1 else f"All its {places or ''} places are taken."
            self._draw("The lab is full", f"{taken} Close another tab, or wait a minute.", again=True)
        elif kind == "trouble":
            self._draw("The gas can't go on", str(notice.get("text", "")))
        elif kind == "gone":
            self._draw("This page is too old", "Its gas was let go.", again=True)
        elif kind == "lost":
            self._draw("Connection lost", "Trying to reconnect …")
        elif kind in ("ready", "connected"):
            self.open()

    def open(self) -> None:
        """Draw the curtain back: there is a gas."""
        self._reason = ""
        if self._curtain.visible:
            self._curtain.set_visibility(False)

    def settle(self) -> None:
        """There is a gas: whatever was said of its preparation is over."""
        if self._reason == "preparing":
            self.open()

    def _draw(self, heading: str, text: str, progress: float | None = None, *, again: bool = False) -> None:
        self._heading.set_text(heading)
        self._text.set_text(text)
        self._progress.set_visibility(progress is not None)
        if progress is not None:
            self._progress.set_value(progress)
        self._again.set_visibility(again)
        self._curtain.set_visibility(True)
