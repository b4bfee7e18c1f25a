"""The chart of one study on the page."""

from __future__ import annotations

from gasbox.app.chart_card import ChartCard
from gasbox.app.study import Picture
from gasbox.app.study_options import filled, layout

__all__ = ["StudyChart"]


class StudyChart(ChartCard):
    """It is made anew when it gets other curves, and else only told what is new."""

    def __init__(self, name: str, title: str) -> None:
        super().__init__(name, title, f"study of-{name}", f"study-{name}")
        self._kind: tuple[object, ...] | None = None

    def show(self, picture: Picture | None) -> None:
        """Bring the chart up to date."""
        if picture is None:
            return
        self.say(picture.fact)
        kind = (picture.x.name, picture.y.name, *((one.name, one.kind, one.color) for one in picture.traces))
        if kind != self._kind:
            self._kind = kind
            names = ", ".join(trace.name for trace in picture.traces)
            about = f"{self.title}: {picture.y.name} against {picture.x.name}, {names}."
            self.draw(layout(picture, about))
        option = filled(picture)
        # Functions were said when the chart was made.
        option["series"] = [{"data": series["data"]} for series in option["series"]]
        self.change(option)
