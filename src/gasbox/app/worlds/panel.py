"""The role of a world's panel on the page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, Protocol, runtime_checkable

from nicegui import ui

from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.state import Change

__all__ = ["Ending", "MakePanel", "Send", "WorldPanel"]

Send = Callable[[Change], None]
"""Takes a change, and says on the page why it could not be made."""


class WorldPanel(Protocol):
    """Controls under the box, built where they stand when it is made, and charts in their column."""

    charts: Literal["none", "own", "all"]
    """Which charts are seen at first: none at all, those of the world alone, or also those of every gas."""

    def show(self, sample: Sample) -> None:
        """Called four times a second."""
        ...


@runtime_checkable
class Ending(Protocol):
    """What a panel also has if it must put things in order before another one takes its place."""

    def end(self) -> None:
        """Called once, when another scenario has come."""
        ...


MakePanel = Callable[[Session, Send, ui.element], WorldPanel]
"""Makes a panel in the slot that is open; the last parameter is the element in the column of charts for its own."""
