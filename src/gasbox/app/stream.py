"""The frame socket: one raw binary websocket per page, beside the channel of the controls."""

from __future__ import annotations

import asyncio
import contextlib
import json
from typing import Any, Final

from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketState

from gasbox.app import protocol
from gasbox.app.mailbox import Mailbox
from gasbox.app.registry import BusyError, Registry
from gasbox.app.session import Session
from gasbox.state import SetWorld

__all__ = ["GONE", "PATH", "serve_frames"]

PATH: Final = "/gasbox/frames/{session_id}"
GONE, BUSY, REPLACED = 4404, 4503, 4409
"""Close codes: no such session (load the page again), no room (try again later), another socket took over."""
_PARTING: Final = 0.5
"""Seconds for the socket of an earlier load of the same tab to close."""
_SENSELESS: Final = (ValueError, TypeError, KeyError, OverflowError)
"""What comes of a message that makes no sense; it ends the connection."""
_LONGEST_MESSAGE: Final = 1000
"""Characters; what a browser has to say on this socket is short."""


async def serve_frames(socket: WebSocket, registry: Registry, session_id: str, previous: str | None) -> None:
    """Answer one frame socket until it closes.

    Parameters
    ----------
    session_id : of the page that connects
    previous : id of an earlier load of the same tab, whose gas is taken over if nobody else holds it
    """
    await socket.accept()
    session = registry.find(session_id)
    if session is None:
        await _refuse(socket, GONE, protocol.notice("gone"))
        return
    try:
        await _seat(registry, session, previous)
    except BusyError as error:
        await _refuse(socket, BUSY, protocol.notice("busy", text=str(error), places=registry.max_sessions))
        return
    await _converse(socket, session, registry.announcement)


async def _seat(registry: Registry, session: Session, previous: str | None) -> None:
    if previous and not session.started:
        await _parting(registry.find(previous))
        await asyncio.to_thread(registry.inherit, session, previous)
    session.start()


async def _parting(previous: Session | None) -> None:
    """Wait a moment: of a page that is loaded again, the old socket may close after the new one has opened."""
    patience = _PARTING
    while previous is not None and previous.audience.attached and patience > 0:
        await asyncio.sleep(0.02)
        patience -= 0.02


async def _refuse(socket: WebSocket, code: int, text: str) -> None:
    with contextlib.suppress(WebSocketDisconnect, RuntimeError):
        await socket.send_text(text)
        await socket.close(code)


async def _converse(socket: WebSocket, session: Session, greeting: str | None) -> None:
    loop = asyncio.get_running_loop()
    news = asyncio.Event()
    mailbox = Mailbox(ring=lambda: _ring(loop, news))
    if greeting is not None:
        mailbox.put_text(greeting)
    session.attach(mailbox)
    tasks = [
        asyncio.create_task(_send(socket, mailbox, news)),
        asyncio.create_task(_listen(socket, session, mailbox)),
    ]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        session.audience.detach(mailbox)
        for task in tasks:
            task.cancel()
        for task in tasks:
            with contextlib.suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError, *_SENSELESS):
                await task
        if socket.application_state is WebSocketState.CONNECTED:
            with contextlib.suppress(RuntimeError, WebSocketDisconnect):
                await socket.close(REPLACED)


def _ring(loop: asyncio.AbstractEventLoop, news: asyncio.Event) -> None:
    with contextlib.suppress(RuntimeError):  # the loop is closed: the server is going down
        loop.call_soon_threadsafe(news.set)


async def _send(socket: WebSocket, mailbox: Mailbox, news: asyncio.Event) -> None:
    while not mailbox.closed:
        message = mailbox.take()
        if message is None:
            await news.wait()
            news.clear()
        elif isinstance(message, str):
            await socket.send_text(message)
        else:
            await socket.send_bytes(message)


def _setting(name: Any, value: Any) -> SetWorld:
    """A setting of the world; one that it does not have is refused in the session's thread, and nobody waits for it."""
    if not isinstance(name, str) or not isinstance(value, bool | int | float | str):
        raise ValueError("a setting that is none")
    return SetWorld(name, value)


async def _listen(socket: WebSocket, session: Session, mailbox: Mailbox) -> None:
    while True:
        text = await socket.receive_text()
        if len(text) > _LONGEST_MESSAGE:
            raise ValueError("a message that is too long")
        message: Any = json.loads(text)
        if not isinstance(message, dict):
            raise ValueError("a message that is no object")
        if "ack" in message:
            mailbox.ack(int(message["ack"]), int(message.get("drawn", 0)))
        if "hidden" in message:
            mailbox.hidden = bool(message["hidden"])
        if "drag" in message:
            session.drag(int(message["drag"]), float(message["to"]))
        if "drop" in message:
            session.drop(int(message["drop"]))
        if "set" in message:
            session.change(_setting(*message["set"]))
        if "point" in message:
            session.point(message["point"])
        session.wake()
