"""Sessions; a simulated user of the page; a server in a process of its own, and pages in a real Chromium."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Iterator
from typing import Any

import pytest
from free_flight import FreeFlight, gas
from lab_server import Server
from nicegui.testing import user_simulation
from playwright.sync_api import Browser, Page, sync_playwright
from simulated_lab import WIDE, Lab

from chromium import ARGUMENTS
from gasbox.app.page import Page as LabPage
from gasbox.app.page import build
from gasbox.app.session import Session
from gasbox.compiling import compile_kernels

Opened = Callable[..., Page]


@pytest.fixture
def session() -> Iterator[Session]:
    one = Session(gas(), unwatched=True, simulate=FreeFlight)
    yield one
    one.close()


@pytest.fixture
def paused(session: Session) -> Session:
    session.pause()
    session.start()
    session.settle()
    return session


@pytest.fixture
async def lab() -> AsyncIterator[Lab]:
    pages: list[LabPage] = []
    scenario = gas((300, 200, 100), watch_for="Watch this.", container=WIDE)

    def root() -> None:
        pages.append(build(Session(scenario, unwatched=True, simulate=FreeFlight)))

    async with user_simulation(root=root) as user:
        await user.open("/")
        page = pages[-1]
        page.session.start()
        one = Lab(user, page)
        await one.until(lambda: page.session.sample() is not None and one.one("particles").text == "600")
        yield one
        page.session.close()


@pytest.fixture(scope="session")
def lab_server() -> Iterator[Server]:
    # On a fresh machine this takes a minute or two, which is no matter of the page.
    compile_kernels()
    server = Server(max_sessions=100)  # each test leaves one behind, which is kept for a while
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
