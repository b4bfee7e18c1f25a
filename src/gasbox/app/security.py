"""Who may speak to the server: Host and Origin checks, a limit on uploads, and a few headers. Pure ASGI.

A page on another site can make a browser send requests to 127.0.0.1. It cannot fake the two headers that are
checked here: ``Host`` (against names that are re-bound to 127.0.0.1) and ``Origin`` (against plain cross-site
requests and websockets). Socket.io and the frame socket go through the same door.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Iterable
from typing import Final
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

__all__ = ["MAX_BODY", "Guard", "is_loopback"]

MAX_BODY: Final = 64 * 1024 * 1024
"""Bytes of one request: a snapshot of some 10^5 discs."""
_HEADERS: Final = {
    "X-Content-Type-Options": "nosniff",
    "Content-Security-Policy": "frame-ancestors 'self'",
    "X-Frame-Options": "SAMEORIGIN",
    "Referrer-Policy": "same-origin",
}
_LOCAL: Final = frozenset({"localhost", "127.0.0.1", "::1"})


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach a server that listens on `host`."""
    try:
        return host == "localhost" or ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


class Guard:
    """Lets through what comes from the page itself.

    Parameters
    ----------
    app : what is guarded
    host : the address that the server listens on. Names of this machine are always good; if the server can be
        reached from elsewhere, so is any plain address (what the check is against is a name that is re-bound)
    names : more host names that are good
    """

    def __init__(
        self, app: ASGIApp, host: str = "127.0.0.1", names: Iterable[str] = (), max_body: int = MAX_BODY
    ) -> None:
        self.app = app
        self._max_body = max_body
        self._names = {*_LOCAL, host.strip("[]").lower(), *(name.lower() for name in names)}
        self._open = not is_loopback(host)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check one connection and pass it on, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        hosts = headers.getlist("host")
        if len(hosts) != 1 or not self._is_good_host(hosts[0]):
            await _refuse(scope, receive, send, 400, "This address is not one of this server.")
        elif not _is_same_origin(headers):
            await _refuse(scope, receive, send, 403, "Requests from other sites are not answered.")
        elif scope["type"] == "websocket":
            await self.app(scope, receive, send)
        else:
            await self._answer(scope, receive, send, headers)

    def _is_good_host(self, host: str) -> bool:
        try:
            name = urlsplit(f"//{host}").hostname
        except ValueError:
            return False
        if name is None:
            return False
        return name in self._names or (self._open and _is_address(name))

    async def _answer(self, scope: Scope, receive: Receive, send: Send, headers: Headers) -> None:
        length = headers.get("content-length", "0")
        if not length.isdigit() or int(length) > self._max_body:
            await _refuse(scope, receive, send, 413, self._limit())
            return
        await _Measured(self.app, scope, receive, send, self._max_body, self._limit()).answer()

    def _limit(self) -> str:
        return f"The file is too large: at most {self._max_body // 2**20} MB are accepted."


class _Measured:
    """One answer, whose request's body is counted while it comes in; a body that is too long ends in status 413."""

    def __init__(
        self, app: ASGIApp, scope: Scope, receive: Receive, send: Send, max_body: int, limit: str
    ) -> None:
        self._app, self._scope, self._receive, self._send = app, scope, receive, send
        self._left, self._limit = max_body, limit
        self._begun = False

    async def answer(self) -> None:
        try:
            await self._app(self._scope, self._count, self._pass_on)
        except Exception:
            if self._left >= 0:
                raise
        if self._left < 0 and not self._begun:
            await _refuse(self._scope, self._receive, self._send, 413, self._limit)

    async def _count(self) -> Message:
        message = await self._receive()
        self._left -= len(message.get("body", b""))
        # What reads the body then gives up; what it says about that is not passed on.
        return {"type": "http.disconnect"} if self._left < 0 else message

    async def _pass_on(self, message: Message) -> None:
        if self._left < 0 and not self._begun:
            return
        if message["type"] == "http.response.start":
            self._begun = True
            _add_headers(message)
        await self._send(message)


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _is_same_origin(headers: Headers) -> bool:
    """Whether the request comes from a page of this server, or from no page at all."""
    origins = headers.getlist("origin")
    if not origins:
        return True
    site = urlsplit(origins[0])
    return len(origins) == 1 and site.scheme in ("http", "https") and site.netloc == headers.get("host")


def _add_headers(message: Message) -> None:
    headers = MutableHeaders(scope=message)
    for name, value in _HEADERS.items():
        headers.setdefault(name, value)


async def _refuse(scope: Scope, receive: Receive, send: Send, status: int, text: str) -> None:
    body = text.encode()
    start: Message = {
        "type": "http.response.start",
        "status": status,
        "headers": [
            (b"content-type", b"text/plain; charset=utf-8"),
            (b"content-length", str(len(body)).encode()),
            (b"connection", b"close"),
        ],
    }
    end: Message = {"type": "http.response.body", "body": body}
    if scope["type"] == "websocket":
        if "websocket.http.response" not in scope.get("extensions", {}):
            await send({"type": "websocket.close", "code": 1008})
            return
        start["type"], end["type"] = "websocket.http.response.start", "websocket.http.response.body"
    else:
        _add_headers(start)
    await send(start)
    await send(end)
