"""Opening and saving files: scenarios and snapshots come in by one door, and leave as downloads."""

from __future__ import annotations

import gzip
import re
from collections.abc import Callable
from typing import Any

from nicegui import run, ui
from nicegui.events import UploadEventArguments

from gasbox.app.dialogs import show_message, show_problems
from gasbox.app.security import MAX_BODY
from gasbox.app.session import Session
from gasbox.errors import GasboxError, Problem, ScenarioError
from gasbox.scenario import Scenario, load, parse

__all__ = ["Files", "file_name"]

MAX_UNPACKED = 512 * 1024 * 1024
"""Bytes of a compressed file when unpacked; more is refused before memory is gone."""


def file_name(title: str, ending: str) -> str:
    """A name for a download, from the title of the scenario."""
    stem = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")[:60] or "gas"
    return f"{stem}{ending}"


class Files:
    """Opens scenarios and snapshots, and saves them."""

    def __init__(self, session: Session, loaded: Callable[[], None]) -> None:
        self._session = session
        self._loaded = loaded
        self.upload = ui.upload(
            auto_upload=True, max_file_size=MAX_BODY, on_upload=self._uploaded, on_rejected=self._rejected
        )
        self.upload.props('accept=".json,.gz" aria-hidden="true" tabindex=-1').classes("away").mark("upload")

    @property
    def pick(self) -> str:
        """JavaScript that opens the browser's file dialog (only the browser may, on a click)."""
        return f"() => getElement({self.upload.id}).$refs.qRef.pickFiles()"

    async def _uploaded(self, event: UploadEventArguments) -> None:
        name = event.file.name or "the file"
        data = await event.file.read()
        self.upload.reset()
        await self._try(name, lambda: parse(data, source=name, largest=MAX_UNPACKED))

    def _rejected(self) -> None:
        self.upload.reset()
        show_message(
            "This file can't be opened",
            f"A .json or .json.gz file of at most {MAX_BODY // 2**20} MB is needed.",
        )

    async def choose(self, name: str) -> None:
        """Put a shipped scenario into the box."""
        await self._try(name, lambda: load(name))

    async def apply(self, data: dict[str, Any]) -> list[Problem]:
        """Put an edited scenario into the box; what is wrong with it, or nothing."""
        try:
            await run.io_bound(self._take, lambda: parse(data))
        except ScenarioError as error:
            return list(error.problems)
        except GasboxError as error:
            return [Problem("", "", str(error))]
        self._loaded()
        return []

    async def _try(self, source: str, read: Callable[[], Scenario]) -> None:
        try:
            await run.io_bound(self._take, read)
        except ScenarioError as error:
            show_problems(source, error.problems)
        except GasboxError as error:
            show_message(f"{source} can't be used", str(error))
        else:
            self._loaded()

    def _take(self, read: Callable[[], Scenario]) -> None:
        self._session.load(read())

    async def save_snapshot(self) -> None:
        """Download the gas as it is now, to the bit."""
        await self._save(self._session.snapshot, "-snapshot")

    async def save_scenario(self) -> None:
        """Download what the gas was made from."""
        await self._save(lambda: self._session.scenario, "")

    async def _save(self, take: Callable[[], Scenario], mark: str) -> None:
        try:
            written = await run.io_bound(self._written, take, mark)
        except GasboxError as error:
            show_message("Nothing was saved", str(error))
            return
        if written is not None:  # it is when the server is going down
            ui.download.content(*written)

    @staticmethod
    def _written(take: Callable[[], Scenario], mark: str) -> tuple[bytes, str]:
        scenario = take()
        text = scenario.to_json().encode()
        name = file_name(scenario.title or "gas", f"{mark}.json")
        if len(text) > 20_000_000:
            return gzip.compress(text, 5, mtime=0), f"{name}.gz"
        return text, name
