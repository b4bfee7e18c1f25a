"""A simulated user of the page, with a gas that needs no engine."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from typing import Any

from nicegui.elements.upload_files import SmallFileUpload
from nicegui.testing import User

from gasbox.app.page import Page
from gasbox.state import SetWorld

WIDE = {"shape": "rectangle", "width": 200, "height": 150, "periodic": ["x", "y"]}


class Lab:
    """A user, the page that they see, and its session."""

    def __init__(self, user: User, page: Page) -> None:
        self.user = user
        self.page = page
        self.session = page.session

    def one(self, marker: str) -> Any:
        return next(iter(self.user.find(marker=marker).elements))

    def time(self) -> float:
        sample = self.session.sample()
        return math.nan if sample is None else sample.time

    def click(self, marker: str) -> None:
        self.user.find(marker=marker).click()

    async def press(self, key: str) -> None:
        """As `page.js` tells it."""
        with self.user:
            await self.page.press(key)

    async def upload(self, name: str, data: bytes) -> None:
        with self.user:
            await self.page.files.upload.handle_uploads([SmallFileUpload(name, "application/json", data)])

    async def until(self, condition: Callable[[], Any], seconds: float = 5.0) -> None:
        end = asyncio.get_running_loop().time() + seconds
        while not condition():
            assert asyncio.get_running_loop().time() < end, "it did not come true"
            await asyncio.sleep(0.02)


def asked(lab: Lab) -> list[SetWorld]:
    """What was asked of the world so far."""
    return [change for _, change in lab.session.show.simulation.changes if isinstance(change, SetWorld)]


class Watched:
    """A control and all values that it shows from now on."""

    def __init__(self, control: Any) -> None:
        self.control = control
        self.shown: list[Any] = []
        control.on_value_change(lambda event: self.shown.append(event.value))


async def keeps_what_is_chosen(lab: Lab, marker: str, value: Any) -> None:
    """A hand sets a control: news from before that must not move it back, nor may anything later."""
    before = lab.session.sample()
    watched = Watched(lab.one(marker))
    watched.control.set_value(value)
    for _ in range(3):
        lab.page.world.panel.show(before)
    later = lab.session.sample
    await lab.until(lambda: later() is not before and asked(lab))
    await asyncio.sleep(1.0)  # longer than the patience of a control
    assert watched.shown == [value]


def bars(lab: Lab, species: int) -> list[list[float]]:
    rows: list[list[float]] = lab.page.charts.histograms[species].chart.options["series"][0]["data"]
    return rows
