"""The frame socket behind its guard in a real server, without the page."""

from __future__ import annotations

import contextlib
import functools
import socket
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import uvicorn
from fastapi import FastAPI, Request, WebSocket
from fastapi.responses import HTMLResponse
from fastapi.staticfiles import StaticFiles
from free_flight import FreeFlight

import gasbox.app
from gasbox.app.registry import Registry
from gasbox.app.security import Guard
from gasbox.app.session import Session
from gasbox.app.stream import PATH, serve_frames

CORE = Path(gasbox.app.__file__).parent / "frontend" / "core"
PAGE = """<!doctype html><meta charset="utf-8"><title>box</title><link rel="icon" href="data:,">
<style>html, body { margin: 0 } #box { width: 620px; height: 420px }</style><div id="box"></div>
<script type="module">
  import { createLab } from "/core/index.js";
  window.picked = [];
  window.notices = [];
  window.lab = createLab(document.getElementById("box"), {
    session: "SESSION",
    onPick: (row) => window.picked.push(row),
    onNotice: (notice) => window.notices.push(notice.kind),
  });
</script>"""


@dataclass
class FrameServer:
    registry: Registry
    port: int

    def url(self, session: Session, query: str = "") -> str:
        return f"ws://127.0.0.1:{self.port}/gasbox/frames/{session.id}{query}"

    def page(self, session: Session, query: str = "") -> str:
        return f"http://127.0.0.1:{self.port}/lab/{session.id}{query}"


def application(registry: Registry) -> FastAPI:
    app = FastAPI()

    @app.websocket(PATH)
    async def frames(socket: WebSocket, session_id: str, previous: str | None = None) -> None:
        await serve_frames(socket, registry, session_id, previous)

    @app.post("/size")
    async def size(request: Request) -> int:
        return len(await request.body())

    @app.get("/")
    async def page() -> str:
        return "the page"

    @app.get("/lab/{session_id}")
    async def lab(session_id: str) -> HTMLResponse:
        return HTMLResponse(PAGE.replace("SESSION", session_id))

    app.mount("/core", StaticFiles(directory=CORE))
    return app


@contextlib.contextmanager
def running(
    max_sessions: int = 3, max_body: int = 10_000, simulate: Callable[..., Any] = FreeFlight
) -> Iterator[FrameServer]:
    registry = Registry(max_sessions, functools.partial(Session, simulate=simulate))
    listener = socket.create_server(("127.0.0.1", 0))
    app = Guard(application(registry), max_body=max_body)
    server = uvicorn.Server(
        uvicorn.Config(app, log_level="error", ws="websockets-sansio", ws_per_message_deflate=False)
    )
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    while not server.started:
        time.sleep(0.01)
    try:
        yield FrameServer(registry, listener.getsockname()[1])
    finally:
        registry.close()
        server.should_exit = True
        thread.join(10)
        listener.close()
