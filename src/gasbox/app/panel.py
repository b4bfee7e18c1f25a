"""The side panel in which the gas is edited."""

from __future__ import annotations

import random
from collections.abc import Awaitable, Callable
from typing import Any

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.charts import MOST_CHARTS
from gasbox.app.draft import Draft
from gasbox.app.draft_kinds import MoleculeDraft, SpeciesDraft
from gasbox.errors import Problem
from gasbox.scenario import Scenario

__all__ = ["Panel"]

_KINDS = {
    "event-driven": "event-driven (exact)",
    "stepped": "stepped (classroom rule)",
    "forced": "forces between discs",
    "walk": "people who walk",
}
_SHAPES = {"rectangle": "rectangle", "circle": "circle", "regular-polygon": "regular polygon"}
_SELECT = "dense outlined options-dense"
_STARTS = {"temperature": "temperature", "speed": "one speed"}


class Panel:
    """A drawer with fields for the species and molecules, the container, gravity, the seed and the dynamics.

    Parameters
    ----------
    apply : takes the scenario as typed, and returns what is wrong with it (nothing: it was applied)
    """

    def __init__(
        self, scenario: Scenario, apply: Callable[[dict[str, Any]], Awaitable[list[Problem]]]
    ) -> None:
        self._apply = apply
        self._scenario = scenario
        self._draft: Draft | None = None
        self._fields: dict[str, ui.input] = {}
        self.drawer = ui.right_drawer(value=False, fixed=True, bordered=False)
        self.drawer.props('width=360 breakpoint=1023 aria-label="Edit the gas"').classes("panel").mark(
            "panel"
        )
        with self.drawer:
            with ui.element("div").classes("panel-head"):
                with ui.element("h2"):
                    ui.label("Edit the gas")
                ui.button(icon="close", on_click=self.drawer.hide, color=None).props(
                    'flat round dense aria-label="Close"'
                )
            self._body = ui.element("div").classes("panel-body")
            with ui.element("div").classes("panel-foot"):
                self._problems = (
                    ui.element("div").classes("problems").props('role="alert"').mark("panel-problems")
                )
                with ui.element("div").classes("line"):
                    ui.button("Apply", on_click=self.apply).props("unelevated color=primary").classes(
                        "grow"
                    ).mark("apply")
                    ui.button("Undo edits", on_click=self.revert, color=None).props("flat").mark("revert")
        self.drawer.on_value_change(self._opened)

    def toggle(self) -> None:
        """Open or close."""
        self.drawer.toggle()

    def show(self, scenario: Scenario) -> None:
        """Another gas is in the box: its values replace what was typed."""
        self._scenario = scenario
        self._draft = None
        if self.drawer.value:
            self.revert()

    def _opened(self) -> None:
        if self.drawer.value and self._draft is None:
            self.revert()

    def revert(self) -> None:
        """Back to what is in the box."""
        self._draft = Draft.of(self._scenario)
        self._say([])
        self._build(self._draft)

    async def apply(self) -> None:
        """Check, and replace the gas if nothing is wrong; otherwise say what is, and keep what was typed."""
        if self._draft is not None:
            self._say(await self._apply(self._draft.to_dict()))

    def _say(self, problems: list[Problem]) -> None:
        for box in self._fields.values():
            box.error = None
        self._problems.clear()
        if not problems:
            return
        with self._problems, ui.element("ul"):
            for problem in problems:
                with ui.element("li"):
                    ui.label(str(problem))
                if problem.path in self._fields:
                    self._fields[problem.path].error = problem.allowed

    def _build(self, draft: Draft) -> None:
        self._fields.clear()
        self._body.clear()
        with self._body:
            for index, species in enumerate(draft.species):
                self._species_form(index, species, draft)
            for index, molecule in enumerate(draft.molecules):
                self._molecule_form(index, molecule, draft)
            add = ui.button("Add a species", icon="add", on_click=lambda: self._add(draft), color=None)
            add.props("flat dense").mark("add-species").set_enabled(draft.kinds < MOST_CHARTS)
            self._container_form(draft)
            self._dynamics_form(draft)

    def _field(self, path: str, label: str, owner: Any, attribute: str) -> ui.input:
        box = ui.input(label, value=getattr(owner, attribute), on_change=_into(owner, attribute)).mark(path)
        box.props("dense outlined hide-bottom-space inputmode=decimal").on("keydown.enter", self.apply)
        self._fields[path] = box
        return box

    def _choice(
        self, path: str, label: str, choices: dict[str, str], owner: Any, attribute: str
    ) -> ui.select:
        value, into = getattr(owner, attribute), _into(owner, attribute)
        return ui.select(choices, label=label, value=value, on_change=into).props(_SELECT).mark(path)

    def _species_form(self, index: int, species: SpeciesDraft, draft: Draft) -> None:
        path, name = f"species[{index}]", f"Species {index + 1}"
        with ui.element("div").classes("species-form").props(f'role="group" aria-label="{name}"'):
            self._heading(path, name, species, draft, draft.species)
            with ui.element("div").classes("fields"):
                for quantity in ("count", "mass", "radius"):
                    self._field(f"{path}.{quantity}", quantity, species, quantity)
            with ui.element("div").classes("fields two"):
                self._start_form(path, species)

    def _molecule_form(self, index: int, molecule: MoleculeDraft, draft: Draft) -> None:
        path, name = f"molecules[{index}]", f"Molecule {index + 1}"
        with ui.element("div").classes("species-form").props(f'role="group" aria-label="{name}"'):
            self._heading(path, name, molecule, draft, draft.molecules)
            ui.label(self._made_of(molecule)).classes("hint")
            with ui.element("div").classes("fields"):
                self._field(f"{path}.count", "count", molecule, "count")
                self._choice(f"{path}.start", "start with", _STARTS, molecule, "start")
                value = self._field(f"{path}.warmth", "value", molecule, "warmth")
                self._fields[f"{path}.temperature"] = self._fields[f"{path}.speed"] = value
            turning = self._field(
                f"{path}.rotational_temperature", "temperature of its rotation", molecule, "turning"
            )
            turning.props('placeholder="that of its flight" stack-label')

    @staticmethod
    def _made_of(molecule: MoleculeDraft) -> str:
        model, atoms = molecule.kept.get("model"), molecule.kept.get("atoms", ())
        return f"Model {model}" if model else f"{len(atoms)} atoms, as in the file"

    def _heading(
        self, path: str, name: str, one: SpeciesDraft | MoleculeDraft, draft: Draft, among: list[Any]
    ) -> None:
        """Colour, name, and a button that removes it from those that it is among."""

        def remove() -> None:
            among[:] = [other for other in among if other is not one]
            self._build(draft)

        with ui.element("div").classes("line"):
            color = ui.input(value=one.color, on_change=_into(one, "color")).mark(f"{path}.color")
            color.props(f'type=color dense borderless aria-label="Colour of {name}"').classes("swatch")
            self._field(f"{path}.name", "name", one, "name").props(remove="inputmode").classes("grow")
            button = ui.button(icon="delete_outline", on_click=remove, color=None)
            button.props(f'flat round dense aria-label="Remove {name}"').mark(f"{path}.remove")
            button.set_enabled(draft.kinds > 1)

    def _start_form(self, path: str, species: SpeciesDraft) -> None:
        choices = {**_STARTS, "velocities": "as listed"} if "velocities" in species.kept else _STARTS
        start = self._choice(f"{path}.start", "start with", choices, species, "start")
        value = self._field(f"{path}.warmth", "value", species, "warmth")
        value.bind_visibility_from(start, "value", lambda start: start != "velocities")
        self._fields[f"{path}.temperature"] = self._fields[f"{path}.speed"] = value

    def _container_form(self, draft: Draft) -> None:
        container = draft.container
        with ui.element("h3"):
            ui.label("Container")
        shapes = _SHAPES if draft.shape != "polygon" else {**_SHAPES, "polygon": "polygon (as in the file)"}
        shape = self._choice("container.shape", "shape", shapes, container, "shape")

        def only(element: Any, *of: str) -> None:
            element.bind_visibility_from(shape, "value", lambda value: value in of)

        with ui.element("div").classes("fields two"):
            for key in ("width", "height", "sides", "radius"):
                box = self._field(f"container.{key}", key, container, key)
                only(box, *(one for one, keys in container.SHOWN.items() if key in keys))
        with ui.element("div").classes("line") as axes:
            for axis in ("x", "y"):
                attribute = f"periodic_{axis}"
                check = ui.checkbox(
                    f"periodic in {axis}",
                    value=getattr(container, attribute),
                    on_change=_into(container, attribute),
                )
                check.props("dense").mark(f"periodic-{axis}")
        only(axes, "rectangle")
        self._surroundings_form(draft)

    def _surroundings_form(self, draft: Draft) -> None:
        with ui.element("div").classes("fields two"):
            self._field("gravity[0]", "gravity to the right", draft, "gravity_x")
            self._field("gravity[1]", "gravity up", draft, "gravity_y")
        kept = [f"{len(draft.rest[key])} {key}" for key in ("walls", "obstacles") if draft.rest.get(key)]
        if kept:
            ui.label(f"Kept as in the file: {', '.join(kept)} with properties of their own.").classes("hint")

    def _dynamics_form(self, draft: Draft) -> None:
        with ui.element("h3"):
            ui.label("Dynamics and chance")
        kind = self._choice("dynamics.kind", "dynamics", _KINDS, draft, "kind")
        with ui.element("div").classes("fields two"):
            self._field("seed", "seed", draft, "seed").props("inputmode=numeric")
            step = self._field("dynamics.time_step", "time step", draft, "step")
            step.bind_visibility_from(kind, "value", lambda kind: kind != "event-driven")
        kind.on_value_change(lambda: step.set_value(draft.step))
        dice = ui.button("Another seed", icon="casino", on_click=self._roll, color=None)
        dice.props("flat dense").mark("roll").tooltip("the same gas, drawn anew")

    def _roll(self) -> None:
        self._fields["seed"].set_value(str(random.SystemRandom().randrange(1, 1_000_000)))

    def _add(self, draft: Draft) -> None:
        draft.add_species()
        self._build(draft)


def _into(owner: Any, attribute: str) -> Callable[[ValueChangeEventArguments[Any]], None]:
    """Keeps what is typed. (NiceGUI's bindings would poll a plain object ten times a second.)"""
    return lambda event: setattr(owner, attribute, event.value)
