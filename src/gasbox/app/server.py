"""The live page's server: one process, one port, one session per browser tab."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import os
import socket
import sys
import threading
import webbrowser
from collections.abc import AsyncIterator, Callable
from typing import Any, Final

import uvicorn
from fastapi import FastAPI, WebSocket
from nicegui import ui

from gasbox import jit
from gasbox.app import protocol
from gasbox.app.page import build
from gasbox.app.preparation import Preparation
from gasbox.app.registry import KEEP, Registry
from gasbox.app.security import Guard, is_loopback
from gasbox.app.session import Session
from gasbox.app.stream import PATH, serve_frames
from gasbox.errors import UsageError
from gasbox.scenario import Scenario

__all__ = ["DEFAULT_PORT", "serve"]

DEFAULT_PORT: Final = 8765
_ICON: Final = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32"><rect width="32" height="32" rx="7" fill="#12161d"/>'
    '<circle cx="11" cy="20" r="7" fill="#009e73"/><circle cx="22" cy="11" r="5" fill="#e05a00"/>'
    '<circle cx="24" cy="23" r="3" fill="#5b6cf0"/></svg>'
)
"""Three discs, in the colours of the default scenario."""


def _say(line: str) -> None:
    print(line, flush=True)


def serve(
    scenario: Scenario,
    host: str = "127.0.0.1",
    port: int | None = None,
    show: bool = True,
    max_sessions: int = 16,
    tell: Callable[[str], None] = _say,
) -> None:
    """Serve the live page until Ctrl-C.

    Parameters
    ----------
    scenario : what a new tab shows
    host : address to listen on; anything but a loopback address lets others on the network in, and says so
    port : None tries `DEFAULT_PORT` and takes a free one if it is taken; 0 takes any free one
    show : open the browser once the port listens
    max_sessions : tabs with a gas at the same time
    tell : called with each line for the terminal

    Raises
    ------
    UsageError
        The address or port cannot be had.
    """
    listener = _listen(host, port, tell)
    registry, preparation = _sessions(max_sessions, tell)
    address = _address(host, listener.getsockname()[1])

    def on_ready() -> None:
        for line in _greeting(host, address):
            tell(line)
        preparation.start()
        if show and _has_screen():
            threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()

    config = uvicorn.Config(
        Guard(_application(scenario, registry), host),
        log_level="error",
        ws="websockets-sansio",
        ws_per_message_deflate=False,  # compression costs most of the frames and gains little
        ws_max_size=2**20,
        timeout_graceful_shutdown=1,
    )
    server = _Server(config, on_ready)
    try:
        with contextlib.suppress(KeyboardInterrupt):
            server.run(sockets=[listener])
    finally:
        registry.close()
        listener.close()
    tell("gasbox has ended.")


def _greeting(host: str, address: str) -> list[str]:
    lines = [f"gasbox is at {address} (Ctrl-C ends it)"]
    if not is_loopback(host):
        lines.append(f"Warning: listening on {host}: everyone who can reach this machine can use it.")
    return lines


def _has_screen() -> bool:
    """Whether a browser can be opened; without a screen a text browser might take the terminal over."""
    named = ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    return not sys.platform.startswith("linux") or any(os.environ.get(name) for name in named)


class _Server(uvicorn.Server):
    """Calls back once connections are accepted."""

    def __init__(self, config: uvicorn.Config, on_ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._on_ready = on_ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self._on_ready()


def _sessions(max_sessions: int, tell: Callable[[str], None]) -> tuple[Registry, Preparation]:
    """The registry, and the compilation of kernels that its sessions wait for."""
    first_start = not jit.was_compiled()

    def progress(done: int, total: int, name: str) -> None:
        registry.announce(protocol.notice("preparing", done=done, total=total, name=name, first=first_start))
        if first_start:
            tell(
                f"Compiling, only at the first start: {name} ({done + 1} of {total})" if name else "Compiled."
            )

    preparation = Preparation(progress)

    def prepare() -> None:
        preparation.wait()
        registry.announce(None)

    registry = Registry(max_sessions, make=functools.partial(Session, prepare=prepare))
    return registry, preparation


def _application(scenario: Scenario, registry: Registry) -> FastAPI:
    """The frame socket and, below it, NiceGUI with the page."""

    @contextlib.asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncIterator[None]:
        task = asyncio.create_task(_sweep(registry))
        yield
        task.cancel()

    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None, lifespan=lifespan)

    @app.websocket(PATH)
    async def frames(socket: WebSocket, session_id: str, previous: str | None = None) -> None:
        await serve_frames(socket, registry, session_id, previous)

    @ui.page("/")
    def page() -> None:
        build(registry.open(scenario))

    ui.run_with(
        app,
        title="gasbox",
        favicon=_ICON,
        tailwind=False,  # its runtime watches every change of the page; the page has a style sheet of its own
        reconnect_timeout=KEEP,
        show_welcome_message=False,
        dark=None,
    )
    return app


async def _sweep(registry: Registry) -> None:
    while True:
        await asyncio.sleep(5.0)
        await asyncio.to_thread(registry.sweep)


def _listen(host: str, port: int | None, tell: Callable[[str], None]) -> socket.socket:
    """A listening socket on this port, or on a free one if the default port is taken."""
    try:
        return _bind(host, DEFAULT_PORT if port is None else port)
    except OSError as error:
        if port is not None:
            raise UsageError(f"--host {host} --port {port}: {error.strerror or error}") from error
    try:
        listener = _bind(host, 0)
    except OSError as error:
        raise UsageError(f"--host {host}: {error.strerror or error}") from error
    tell(f"Port {DEFAULT_PORT} is taken; using {listener.getsockname()[1]} instead.")
    return listener


def _bind(host: str, port: int) -> socket.socket:
    bare = host.strip("[]")
    family = socket.getaddrinfo(bare, port, type=socket.SOCK_STREAM)[0][0]
    listener = socket.socket(family, socket.SOCK_STREAM)
    try:
        if sys.platform != "win32":  # there it would let two servers share a port
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((bare, port))
        listener.listen(128)
    except OSError:
        listener.close()
        raise
    return listener


def _address(host: str, port: int) -> str:
    shown: dict[str, Any] = {"0.0.0.0": "127.0.0.1", "::": "[::1]", "::1": "[::1]"}
    return f"http://{shown.get(host, host)}:{port}/"
