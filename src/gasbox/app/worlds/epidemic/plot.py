"""A chart of an epidemic on the page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from gasbox.app.chart_card import ChartCard

__all__ = ["Plot"]


class Plot(ChartCard):
    """One that is there from the start, and may be left out.

    Parameters
    ----------
    make : the options of the chart while it is empty
    """

    def __init__(self, name: str, title: str, make: Callable[[], dict[str, Any]]) -> None:
        super().__init__(name, title, f"plot-of-{name}", f"plot-{name}")
        self.draw(make())

    def tell(self, option: dict[str, Any], fact: str = "") -> None:
        """Bring the chart up to date; `fact` stands beside the title."""
        self.say(fact)
        self.change(option)

    def see(self, visible: bool) -> None:
        """Show it, or leave it out."""
        if self.root.visible != visible:
            self.root.set_visibility(visible)
