"""A server in a process of its own, and pages in a real Chromium."""

from __future__ import annotations

import re
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from chromium import ARGUMENTS

Opened = Callable[..., Page]


class Server:
    """`serve_lab.py`, started and ended by its process id."""

    def __init__(self, scenario: str = "three-gases", max_sessions: int = 8) -> None:
        script = Path(__file__).parent / "serve_lab.py"
        self.lines: list[str] = []
        self._process = subprocess.Popen(
            [sys.executable, str(script), scenario, str(max_sessions)],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._listening = threading.Event()
        self.address = ""
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self.lines.append(line)
            found = re.search(r"http://127\.0\.0\.1:\d+/", line)
            if found:
                self.address = found[0]
                self._listening.set()
        self._listening.set()

    def wait(self) -> Server:
        self._listening.wait(60)
        assert self.address, "".join(self.lines)
        return self

    def close(self) -> None:
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait(10)
        self._reader.join(5)
        if self._process.stdout is not None:
            self._process.stdout.close()


@pytest.fixture(scope="session")
def lab_server() -> Iterator[Server]:
    server = Server()
    try:
        yield server.wait()
    finally:
        server.close()


# Not for the whole session: while Playwright's own event loop runs, no asynchronous test can.
@pytest.fixture(scope="module")
def browser(chromium_path: str) -> Iterator[Browser]:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium_path, args=list(ARGUMENTS))
        yield browser
        browser.close()


@pytest.fixture
def open_page(browser: Browser, lab_server: Server) -> Iterator[Opened]:
    """Opens a page and waits until its gas is drawn; at the end there must be no complaint and no foreign request."""
    complaints: list[str] = []
    contexts: list[Any] = []

    def opened(
        query: str = "", size: tuple[int, int] = (1280, 720), scheme: Any = "light", **settings: Any
    ) -> Page:
        width, height = size
        context = browser.new_context(
            viewport={"width": width, "height": height},
            color_scheme=scheme,
            accept_downloads=True,
            **settings,
        )
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(20_000)
        page.on(
            "console", lambda message: complaints.append(message.text) if message.type == "error" else None
        )
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on(
            "request", lambda request: complaints.append(request.url) if _is_foreign(request.url) else None
        )
        page.goto(lab_server.address + query)
        page.wait_for_function("window.gasboxStats && gasboxStats.drawn > 3", timeout=180_000)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert not complaints


def _is_foreign(url: str) -> bool:
    return not url.startswith(("http://127.0.0.1:", "ws://127.0.0.1:", "data:", "blob:"))
