"""A simulated user of the page, with a gas that needs no engine."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from typing import Any

from nicegui.elements.upload_files import SmallFileUpload
from nicegui.testing import User

from gasbox.app.page import Page

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


def bars(lab: Lab, species: int) -> list[list[float]]:
    rows: list[list[float]] = lab.page.charts.histograms[species].chart.options["series"][0]["data"]
    return rows
