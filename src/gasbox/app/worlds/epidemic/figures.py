"""The numbers of an epidemic: of one run, or of two beside each other."""

from __future__ import annotations

from nicegui import ui

from gasbox.app.wording import number, whole
from gasbox.app.worlds.epidemic.course import Course

__all__ = ["Numbers", "written"]

_HINTS = {
    "day": "since the start",
    "infected now": "people who are exposed or infectious now",
    "R now": "how many each infectious person infects in the end, as estimated now",
    "peak": "most people infected at a time, and on which day",
    "infected so far": "people who were ever infected, those of the start included; in brackets the attack rate: "
    "the part of those susceptible at the start who were",
    "dead": "people who died of it",
}


def written(course: Course) -> dict[str, str]:
    """Name of a number -> how it is written."""
    share = course.peak / max(course.people, 1)
    return {
        "day": f"{course.day:.1f}",
        "infected now": whole(course.infected),
        "R now": number(course.r),
        "peak": f"{whole(course.peak)} ({share:.0%}) day {course.peak_day:.0f}",
        "infected so far": whole(course.total) + ("" if course.attack is None else f" ({course.attack:.0%})"),
        "dead": "–" if course.dead is None else whole(course.dead),
    }


def _hint(course: Course) -> str:
    """What theory says of a population without places or distances, in which anybody meets anybody."""
    if course.r0 is None or course.expected is None:
        return ""
    return f"Well mixed, R₀ = {number(course.r0, 2)}: {course.expected:.0%} infected in the end"


class Numbers:
    """A grid of names and values; a second row of values while two runs are compared."""

    def __init__(self) -> None:
        self._values: dict[str, tuple[ui.label, ui.label]] = {}
        with (
            ui.element("section")
            .classes("card figures epidemic-numbers")
            .props('aria-label="Numbers"') as self._root
        ):
            for name, hint in _HINTS.items():
                with ui.element("div").classes(f"figure of-{name.replace(' ', '-')}") as figure:
                    figure.tooltip(hint)
                    ui.label(name).classes("name")
                    mark = name.replace(" ", "-")
                    first = ui.label("–").classes("value number run-a").mark(f"epidemic-{mark}")
                    second = ui.label("").classes("value number run-b").mark(f"epidemic-{mark}-b")
                self._values[name] = first, second
            self._hint = ui.label("").classes("hint").mark("well-mixed")

    def show(self, first: Course, second: Course | None) -> None:
        """Write all numbers, and only those that have changed."""
        rows = written(first), {} if second is None else written(second)
        for name, labels in self._values.items():
            for label, row in zip(labels, rows, strict=True):
                text = row.get(name, "")
                if label.text != text:
                    label.set_text(text)
        hint = _hint(first if second is None else second)
        if self._hint.text != hint:
            self._hint.set_text(hint)
        paired = "paired" in self._root.classes
        if paired != (second is not None):
            self._root.classes(remove="paired") if paired else self._root.classes(add="paired")
