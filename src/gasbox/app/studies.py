"""All studies, which of them are chosen, and their charts beside the histograms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.studies_of_matter import Order, Pairs, Wandering
from gasbox.app.studies_of_profiles import Density, Temperature
from gasbox.app.studies_of_walls import Pressures, Work
from gasbox.app.studies_over_time import Centers, Energy, Flow, Mixing, Sides
from gasbox.app.study import Study
from gasbox.app.study_chart import StudyChart
from gasbox.app.study_of_degrees import Degrees
from gasbox.app.study_of_heating import Heating
from gasbox.app.window import Lately

__all__ = ["STUDIES", "Studies", "StudyMenu"]

STUDIES: Final[tuple[type[Study], ...]] = (
    Degrees, Heating, Order, Pairs, Density, Work, Sides, Flow, Temperature, Mixing, Energy, Wandering,
    Pressures, Centers,
)  # fmt: skip
"""In the order in which they are shown, and in which they are taken where nobody has chosen."""
_BY_ITSELF: Final = 2
"""Charts that are shown before anybody has chosen."""


class Studies:
    """The charts. Every study that suits the gas takes in all samples, so that a chart shows what was before it.

    Parameters
    ----------
    session : remembers for its tab what was chosen
    changed : called when another number of charts is shown
    """

    def __init__(self, session: Session, changed: Callable[[], None]) -> None:
        self._session = session
        self._changed = changed
        self.all: dict[str, Study] = {study.name: study for study in (make() for make in STUDIES)}
        self._root = ui.element("div").classes("contents")
        self.charts: dict[str, StudyChart] = {}
        self.suitable: frozenset[str] = frozenset()
        self._version = -1
        self._wanted: frozenset[str] = frozenset()

    @property
    def shown(self) -> frozenset[str]:
        """Names of the studies that are shown."""
        chosen = self._session.charts
        return self.suitable & (self._wanted if chosen is None else chosen)

    def choose(self, name: str, wanted: bool) -> None:
        """Show a study, or leave it out."""
        kept = self._wanted if self._session.charts is None else self._session.charts
        self._session.charts = kept | {name} if wanted else kept - {name}
        self._arrange()

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """Take in a sample. Touches no element."""
        for name in self.suitable:
            if name in self.shown or self.all[name].is_light:
                self.all[name].take(sample, lately)

    def fit(self, sample: Sample) -> None:
        """Find out which studies suit the gas; they change with the gas and with its walls."""
        suitable = frozenset(name for name, study in self.all.items() if study.suits(sample))
        if sample.version == self._version and suitable == self.suitable:
            return
        if sample.version != self._version:
            wanted = [name for name in self.all if name in suitable and self.all[name].is_wanted(sample)]
            self._wanted = frozenset(wanted[:_BY_ITSELF])
        self._version, self.suitable = sample.version, suitable
        self._arrange()

    def show(self) -> None:
        """Bring the charts up to date."""
        for name, chart in self.charts.items():
            chart.show(self.all[name].picture())

    def _arrange(self) -> None:
        shown = [name for name in self.all if name in self.shown]
        if shown == list(self.charts):
            return
        self._root.clear()
        with self._root:
            self.charts = {name: StudyChart(name, self.all[name].title) for name in shown}
        self.show()
        self._changed()


class StudyMenu:
    """The menu with a box for each chart."""

    def __init__(self, studies: Callable[[], Studies], chosen: Callable[[], None]) -> None:
        self._studies, self._chosen = studies, chosen
        self._boxes: dict[str, ui.checkbox] = {}
        self._showing = False
        button = (
            ui.button("Charts", icon="add_chart", color=None).props("flat dense no-caps").mark("studies-menu")
        )
        button.tooltip("More charts beside the histograms")
        with button, ui.menu().props('aria-label="Charts"'), ui.element("div").classes("bins-form"):
            for make in STUDIES:
                self._boxes[make.name] = (
                    ui.checkbox(make.title, on_change=self._ticked).props("dense").mark(f"show-{make.name}")
                )

    def refresh(self) -> None:
        """Show what can be chosen, and what is."""
        studies = self._studies()
        self._showing = True
        for name, box in self._boxes.items():
            box.set_value(name in studies.shown)
            box.set_enabled(name in studies.suitable)
        self._showing = False

    def _ticked(self, event: ValueChangeEventArguments[bool | None]) -> None:
        if not self._showing:
            name = next(name for name, box in self._boxes.items() if box is event.sender)
            self._studies().choose(name, bool(event.value))
            self._chosen()
