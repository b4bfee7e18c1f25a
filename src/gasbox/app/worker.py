"""A thread that alone touches what it owns: others hand it orders and get futures."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import CancelledError, Future
from typing import Any, TypeVar

from gasbox.errors import UsageError

__all__ = ["Worker", "outcome"]

_T = TypeVar("_T")


class Worker:
    """Runs orders one after the other, and between them `beat`.

    `beat` returns the seconds after which it wants to be called again, or None: not before something happens
    (`wake` or an order). An idle worker uses no processor time.
    """

    def __init__(self, beat: Callable[[], float | None], name: str) -> None:
        self._beat = beat
        self._orders: deque[tuple[Callable[[], Any], Future[Any]]] = deque()
        self._changed = threading.Condition()
        self._woken = False
        self._closed = False
        self._thread = threading.Thread(target=self._work, name=name, daemon=True)

    def start(self) -> None:
        """Begin to work."""
        self._thread.start()

    def ask(self, order: Callable[[], _T]) -> Future[_T]:
        """Have `order` run in the thread; errors that it raises come out of the future."""
        future: Future[_T] = Future()
        with self._changed:
            if self._closed:
                future.cancel()
                return future
            self._orders.append((order, future))
            self._changed.notify()
        return future

    def wake(self) -> None:
        """Call `beat` soon, because something has changed that it depends on."""
        with self._changed:
            self._woken = True
            self._changed.notify()

    def close(self) -> None:
        """Stop after the order or beat at hand; what still waits is cancelled. Does not wait."""
        with self._changed:
            self._closed = True
            while self._orders:
                self._orders.popleft()[1].cancel()
            self._changed.notify()

    def join(self, timeout: float) -> bool:
        """Wait for the end of the thread; whether it has ended."""
        if self._thread.ident is not None and self._thread is not threading.current_thread():
            self._thread.join(timeout)
        return not self._thread.is_alive()

    def _work(self) -> None:
        pause: float | None = 0.0
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._orders or self._woken or self._closed, pause)
                if self._closed:
                    return
                self._woken = False
                order = self._orders.popleft() if self._orders else None
            if order is not None:
                _carry_out(*order)
                pause = 0.0
            else:
                pause = self._beat()


def outcome(future: Future[_T], timeout: float | None = None) -> _T:
    """Wait for what an order returns.

    Raises
    ------
    UsageError
        The worker has ended.
    """
    try:
        return future.result(timeout)
    except CancelledError:
        raise UsageError("this session has ended") from None


def _carry_out(order: Callable[[], Any], future: Future[Any]) -> None:
    if not future.set_running_or_notify_cancel():
        return
    try:
        future.set_result(order())
    except BaseException as error:
        future.set_exception(error)
