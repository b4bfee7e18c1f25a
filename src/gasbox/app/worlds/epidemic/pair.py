"""A second box beside the first: the same scenario from the same seed, with measures of its own."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping

from nicegui import ElementFilter, run, ui

from gasbox.app.canvas import LabCanvas
from gasbox.app.registry import BusyError
from gasbox.app.sample import Sample
from gasbox.app.session import Session
from gasbox.app.tandem import Encore, Tandem
from gasbox.errors import GasboxError
from gasbox.state import SetWorld

__all__ = ["Pair"]

_PATIENCE = 20.0
"""Seconds that a second gas may take to be made."""


class Pair:
    """Two sessions in step, and the box of the second."""

    def __init__(self, first: Session, second: Session, settings: Mapping[str, float]) -> None:
        self.second = second
        self._tandem = Tandem(Encore(first, {}), Encore(second, settings))
        (boxes,) = ElementFilter(marker="boxes")
        with boxes, ui.element("section").classes("card box second").mark("second-box") as self._root:
            self._root.props('aria-label="The box of run B"')
            canvas = LabCanvas(second, guest=True, on_pick=second.follow).classes("canvas")
            canvas.props('role=img aria-label="Run B: the same people with other measures"')
            ui.label("B").classes("run-mark run-b")

    @classmethod
    async def opened(cls, first: Session, settings: Mapping[str, float]) -> Pair:
        """Both from the start, paused; the second with these settings.

        Raises
        ------
        GasboxError
            There cannot be a second gas, or there is no place for it, with the reason.
        """
        if first.home is None:
            raise BusyError("there is no room for a second box here")
        second = first.home.open(first.scenario)
        second.pause()
        try:
            second.start()
            first.pause()
            await asyncio.wrap_future(first.reset())
            await run.io_bound(second.settle, _PATIENCE)
            if second.trouble is not None:
                raise GasboxError(second.trouble)
            for name, value in settings.items():
                await asyncio.wrap_future(second.change(SetWorld(name, value)))
        except BaseException:
            await run.io_bound(first.home.dismiss, second)
            raise
        return cls(first, second, settings)

    def choose(self, which: str, name: str, value: float) -> Session:
        """A setting of run "a" or "b" is to last; whose session to tell."""
        encore = self._tandem.encores[which == "b"]
        encore.settings[name] = value
        return encore.session

    def sample(self) -> Sample | None:
        """The newest copy of the second."""
        return self.second.sample()

    async def end(self) -> None:
        """Let the second go; its box leaves the page."""
        self._tandem.part()
        if not self._root.is_deleted:
            self._root.delete()
        if self.second.home is not None:
            await run.io_bound(self.second.home.dismiss, self.second)
