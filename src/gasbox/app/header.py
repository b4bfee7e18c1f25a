"""The bar at the top: which scenario, files, and switches."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.files import Files
from gasbox.scenario import Scenario, load, shipped

__all__ = ["Actions", "Header"]


@dataclass(frozen=True)
class Actions:
    """What the bar's buttons do."""

    files: Files
    edit: Callable[[], Any]
    keys: Callable[[], Any]
    charts: Callable[[], Any]
    dark: Callable[[], Any]
    surroundings: Callable[[], Any]


_EXTERN = "*"
"""The choice that stands for a gas that is none of the shipped ones."""


@functools.cache
def _shipped() -> dict[str, tuple[str, str]]:
    """Title and hash of each shipped scenario, by name."""
    scenarios = {name: load(name) for name in shipped()}
    return {name: (scenario.title or name, scenario.hash()) for name, scenario in scenarios.items()}


def _is_shipped(name: str, scenario: Scenario) -> bool:
    title, said = _shipped()[name]
    # The title is compared first, because hashing a large snapshot takes its time.
    return scenario.snapshot is None and scenario.title == title and scenario.hash() == said


class Header:
    """The bar; on a narrow screen most of its buttons move into a menu."""

    def __init__(self, scenario: Scenario, actions: Actions) -> None:
        self._actions = actions
        self._titles = {name: title for name, (title, _) in _shipped().items()}
        with ui.element("header").classes("lab-bar"):
            ui.label("gasbox").classes("wordmark")
            self._select = ui.select({**self._titles}, on_change=self._chosen)
            self._select.props('dense outlined options-dense aria-label="Scenario"').classes("scenario").mark(
                "scenario"
            )
            self._buttons(actions)
        self.show(scenario)

    def _buttons(self, actions: Actions) -> None:
        files = actions.files
        opener = (
            ui.button("Open", icon="folder_open", color=None).props("flat").classes("only-wide").mark("open")
        )
        opener.on("click", js_handler=files.pick).tooltip(
            "Open a scenario or a snapshot (or drop a file on the page)  O"
        )
        with (
            ui.button("Save", icon="download", color=None).props("flat").classes("only-wide").mark("save"),
            ui.menu(),
        ):
            self._save_items(files)
        ui.element("div").classes("push")
        edit = ui.button("Edit", icon="tune", on_click=actions.edit, color=None).props(
            'flat aria-label="Edit the gas"'
        )
        edit.classes("only-wide").mark("edit").tooltip("Species, container, seed and dynamics  E")
        for icon, hint, action, marker in (
            ("south", "Gravity and walls", actions.surroundings, "show-surroundings"),
            ("bar_chart", "Histograms on or off", actions.charts, "charts"),
            ("contrast", "Light or dark", actions.dark, "dark"),
            ("keyboard", "Keys  ?", actions.keys, "keys"),
        ):
            button = ui.button(icon=icon, on_click=action, color=None).props(
                f'flat round aria-label="{hint}"'
            )
            button.classes("only-wide").mark(marker).tooltip(hint)
        with (
            ui.button(icon="more_vert", color=None)
            .props('flat round aria-label="Menu"')
            .classes("only-narrow")
            .mark("menu"),
            ui.menu(),
        ):
            ui.menu_item("Open a file").on("click", js_handler=files.pick)
            self._save_items(files)
            ui.separator()
            ui.menu_item("Edit the gas", on_click=actions.edit)
            ui.menu_item("Gravity and walls", on_click=actions.surroundings)
            ui.menu_item("Histograms on or off", on_click=actions.charts)
            ui.menu_item("Light or dark", on_click=actions.dark)

    @staticmethod
    def _save_items(files: Files) -> None:
        ui.menu_item("Save a snapshot of the gas now", on_click=files.save_snapshot).mark("save-snapshot")
        ui.menu_item("Download the scenario", on_click=files.save_scenario).mark("save-scenario")

    async def _chosen(self, event: ValueChangeEventArguments[str]) -> None:
        if event.value in self._titles and event.value != self._shown:
            await self._actions.files.choose(event.value)

    def show(self, scenario: Scenario) -> None:
        """Name the scenario that is in the box."""
        name = next((name for name in self._titles if _is_shipped(name, scenario)), _EXTERN)
        self._shown = name
        title = f"{scenario.title or 'untitled'} ({'snapshot' if scenario.snapshot else 'own'})"
        options = self._titles if name != _EXTERN else {**self._titles, _EXTERN: title}
        self._select.set_options(dict(options), value=name)
