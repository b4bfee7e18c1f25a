"""Between the worker that makes frames and the socket that sends them: only the newest frame and view wait."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Final

__all__ = ["NO_ACK_LIMIT", "WINDOW", "Mailbox"]

WINDOW: Final = 2
"""Frames that may be on their way without having been acknowledged."""
NO_ACK_LIMIT: Final = 2.0
"""Seconds without an ack after which nobody is assumed to look."""


class Mailbox:
    """One browser's box: texts in order and never dropped, the newest view of a world, and the newest frame.

    Its memory is bounded however slow the reader is: a view and a frame wait here, `WINDOW` are on their way.
    Every method may be called from any thread; `ring` wakes the sender up.
    """

    def __init__(self, ring: Callable[[], None], clock: Callable[[], float] = time.monotonic) -> None:
        self._ring = ring
        self._clock = clock
        self._lock = threading.Lock()
        self._texts: deque[str] = deque()
        self._view: str | None = None
        self._frame: bytes | None = None
        self._sent = 0
        self._acked = 0
        self._last_sign = clock()
        self._drawn: deque[tuple[float, int]] = deque()
        self.hidden = False
        self.closed = False
        self.dropped = 0
        """Frames that were replaced by a newer one before they were sent."""

    def put_text(self, text: str, *, stale: bool = False) -> None:
        """Queue a text; `stale` says that the waiting frame relies on an older one."""
        with self._lock:
            self._texts.append(text)
            if stale:
                self._frame = None
        self._ring()

    def put_view(self, text: str) -> None:
        """Replace the view of a world that waits by a newer one; it goes out before the frame that belongs to it."""
        with self._lock:
            self._view = text
        self._ring()

    def put_frame(self, frame: bytes) -> None:
        """Replace the waiting frame by a newer one."""
        with self._lock:
            self.dropped += self._frame is not None
            self._frame = frame
        self._ring()

    def take(self) -> str | bytes | None:
        """What to send next: texts first; if the window is open, the view, then the frame; else None."""
        with self._lock:
            if self._texts:
                return self._texts.popleft()
            if self._sent - self._acked >= WINDOW:
                return None
            if self._view is not None:
                view, self._view = self._view, None
                return view
            if self._frame is None:
                return None
            frame, self._frame = self._frame, None
            if self._sent == self._acked:
                self._last_sign = self._clock()
            self._sent += 1
            return frame

    def ack(self, received: int, drawn: int) -> None:
        """The browser has received so many frames in all (cumulative), and drawn so many of them."""
        with self._lock:
            now = self._clock()
            self._acked = min(max(self._acked, received), self._sent)
            self._last_sign = now
            self._drawn.append((now, drawn))
            while len(self._drawn) > 2 and self._drawn[0][0] < now - 2.0:
                self._drawn.popleft()
        self._ring()

    def is_watched(self) -> bool:
        """Whether somebody looks: visible, connected, and acks arrive."""
        with self._lock:
            overdue = self._sent > self._acked and self._clock() - self._last_sign > NO_ACK_LIMIT
            return not (self.closed or self.hidden or overdue)

    def shown_fps(self) -> float:
        """Frames drawn per second over the last two seconds."""
        with self._lock:
            now = self._clock()
            rows = [row for row in self._drawn if row[0] >= now - 2.0]
            if len(rows) < 2:
                return 0.0
            span = max(now - rows[0][0], 1e-3)
            return (rows[-1][1] - rows[0][1]) / span

    def close(self) -> None:
        """Nobody reads any more."""
        self.closed = True
        self._ring()
