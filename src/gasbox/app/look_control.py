"""The menu that says what the colour of a disc tells, and the legend beside it."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.look import COLORINGS, Coloring, Look, after
from gasbox.app.session import Session
from gasbox.app.shading import MOST_NEIGHBOURS

__all__ = ["LookControl"]

_NAMES: Final[dict[Coloring, str]] = {
    "species": "by species",
    "phase": "by phase: gas, liquid, solid",
    "neighbours": "by number of neighbours",
    "speed": "by speed",
}
_PHASES: Final = ("gas", "liquid", "solid")


class LookControl:
    """A button with a menu, and a legend where colours say something else than the species."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._shown: Look | None = None
        self._showing = False
        self._legend = ui.element("div").classes("legend number").props('role="note"').mark("legend")
        button = ui.button(icon="palette", color=None).props('flat round dense aria-label="Colour and bonds"')
        button.classes("look").mark("look").tooltip("Colour  C, bonds  B")
        with button, ui.menu().props('aria-label="Colour and bonds"'), ui.element("div").classes("bins-form"):
            ui.label("Colour of discs").classes("hint")
            self._choice = ui.radio(dict(_NAMES), value="species", on_change=self._chosen)
            self._choice.props("dense").mark("coloring")
            self._bonds = ui.checkbox("Join neighbours by lines", on_change=self._ticked)
            self._bonds.props("dense").mark("bonds")
            ui.label(
                "Neighbours are nearer than 1.5 diameters (σ). Discs are drawn smaller between lines."
            ).classes("hint")
        self.show()

    def show(self) -> None:
        """Show what the session shows."""
        look = self._session.look
        if look == self._shown:
            return
        if self._shown is None or look.coloring != self._shown.coloring:
            self._explain(look.coloring)
        self._shown = look
        self._showing = True
        self._choice.set_value(look.coloring)
        self._bonds.set_value(look.bonds)
        self._showing = False

    def next_coloring(self) -> None:
        """The next way of colouring."""
        self._dress(replace(self._session.look, coloring=after(self._session.look.coloring)))

    def toggle_bonds(self) -> None:
        """Lines between neighbours on or off."""
        self._dress(replace(self._session.look, bonds=not self._session.look.bonds))

    def _dress(self, look: Look) -> None:
        self._session.dress(look)
        self.show()

    def _chosen(self, event: ValueChangeEventArguments[Coloring]) -> None:
        if not self._showing and event.value in COLORINGS:
            self._dress(replace(self._session.look, coloring=event.value))

    def _ticked(self, event: ValueChangeEventArguments[bool | None]) -> None:
        if not self._showing:
            self._dress(replace(self._session.look, bonds=bool(event.value)))

    def _explain(self, coloring: Coloring) -> None:
        self._legend.clear()
        self._legend.set_visibility(coloring != "species")
        with self._legend:
            match coloring:
                case "phase":
                    for name in _PHASES:
                        _entry(name, name)
                case "neighbours":
                    for count in range(MOST_NEIGHBOURS + 1):
                        text = f"{count}+" if count == MOST_NEIGHBOURS else str(count)
                        _entry(f"neighbours-{count}", text)
                    self._legend.tooltip("neighbours of a disc")
                case "speed":
                    ui.label("slow")
                    ui.element("span").classes("ramp")
                    ui.label("fast")
                    self._legend.tooltip("Half way: the mean speed at the start (root of the mean square)")


def _entry(color: str, text: str) -> None:
    with ui.element("span").classes("entry"):
        ui.element("span").classes("dot").style(f"background:var(--gasbox-{color})")
        ui.label(text)
