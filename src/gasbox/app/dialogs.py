"""What opens over the page: what is wrong with a file, and the list of keys."""

from __future__ import annotations

from collections.abc import Sequence

from nicegui import ui

from gasbox.app.shortcuts import SHORTCUTS
from gasbox.errors import Problem

__all__ = ["keys_dialog", "show_message", "show_problems"]

_POINTING = (
    "In the box: point at a particle to read its energies, click to follow it, turn the wheel to zoom, drag to move. "
    "In a histogram: point at a bar to light up its particles."
)


def show_problems(source: str, problems: Sequence[Problem]) -> None:
    """List everything that is wrong with a scenario."""
    count = len(problems)
    with ui.dialog(value=True) as dialog, ui.element("div").classes("dialog").mark("problems-dialog"):
        _heading(f"{source} can't be used")
        ui.label(f"{count} problem{'s' if count != 1 else ''} found. The gas in the box goes on as it was.")
        with ui.element("div").style("overflow:auto;max-height:55vh;margin:10px 0"), ui.element("table"):
            with ui.element("tr"):
                for name in ("Where", "Found", "Allowed"):
                    _cell(name, "th")
            for problem in problems:
                with ui.element("tr"):
                    _cell(problem.path or "the whole file", code=bool(problem.path))
                    _cell(problem.found or "–")
                    _cell(problem.allowed)
        _close(dialog)


def show_message(heading: str, text: str) -> None:
    """One sentence that must be read."""
    with ui.dialog(value=True) as dialog, ui.element("div").classes("dialog").mark("message-dialog"):
        _heading(heading)
        ui.label(text).style("margin:8px 0 12px;white-space:pre-wrap;overflow-wrap:anywhere")
        _close(dialog)


def keys_dialog() -> ui.dialog:
    """The list of keys, still closed."""
    with ui.dialog() as dialog, ui.element("div").classes("dialog").mark("keys-dialog"):
        _heading("Keys")
        with ui.element("table").style("margin:6px 0 12px"):
            for shortcut in SHORTCUTS:
                with ui.element("tr"):
                    with ui.element("td"):
                        for key in shortcut.shown:
                            with ui.element("kbd"):
                                ui.label(key).style("display:inline")
                    _cell(shortcut.meaning)
        ui.label(_POINTING)
        _close(dialog)
    return dialog


def _heading(text: str) -> None:
    with ui.element("h2"):
        ui.label(text)


def _cell(text: str, tag: str = "td", *, code: bool = False) -> None:
    with ui.element(tag).classes("path" if code else ""), ui.element("code" if code else "span"):
        ui.label(text)


def _close(dialog: ui.dialog) -> None:
    with ui.element("div").style("display:flex;justify-content:flex-end"):
        ui.button("Close", on_click=dialog.close).props("flat color=primary autofocus").mark("close-dialog")
