"""All sessions by their secret id: how many there may be, and how long one outlives its browser."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Final

from gasbox.app.session import Session
from gasbox.errors import GasboxError
from gasbox.scenario import Scenario

__all__ = ["KEEP", "BusyError", "Registry"]

KEEP: Final = 60.0
"""Seconds that a session is kept without a browser."""


class BusyError(GasboxError):
    """All places are taken."""


class Registry:
    """The sessions of one server.

    A page that was asked for but never opened its frame socket holds an entry without a thread or a gas; it
    takes no place, and is forgotten like any other after `KEEP` seconds.
    """

    def __init__(
        self,
        max_sessions: int = 16,
        *,
        make: Callable[[Scenario], Session] = Session,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.max_sessions = max_sessions
        self._make = make
        self._clock = clock
        self._sessions: dict[str, Session] = {}
        self._lock = threading.RLock()
        self.announcement: str | None = None
        """A text that also a browser gets that connects later."""

    def open(self, scenario: Scenario) -> Session:
        """A new session for a page that is being built; it starts when its frame socket connects."""
        self.sweep()
        session = self._make(scenario)
        with self._lock:
            self._sessions[session.id] = session
        return session

    def find(self, session_id: str) -> Session | None:
        """The session with this id, if it is still there."""
        with self._lock:
            return self._sessions.get(session_id)

    def admit(self, session: Session) -> None:
        """Start a session if there is room.

        Raises
        ------
        BusyError
            `max_sessions` gases exist already.
        """
        self.sweep()
        with self._lock:
            if session.started:
                return
            if self.running() >= self.max_sessions:
                raise BusyError(f"all {self.max_sessions} places of this lab are taken")
            session.start()

    def inherit(self, session: Session, previous_id: str) -> bool:
        """Give `session` the gas of an earlier load of the same page; whether there was one to give.

        Only a session that no browser holds can be inherited: a duplicated tab gets a gas of its own.
        """
        with self._lock:
            previous = self._sessions.get(previous_id)
            if previous is None or previous is session or session.started:
                return False
            if not previous.started or previous.attached or previous.origin is not session.origin:
                return False
            del self._sessions[previous_id]
        previous.hand_over(session)
        return True

    def announce(self, text: str | None) -> None:
        """Tell every browser, also those that connect later, until None takes it back."""
        self.announcement = text
        if text is None:
            return
        with self._lock:
            sessions = list(self._sessions.values())
        for session in sessions:
            session.tell(text)

    def running(self) -> int:
        """How many sessions have a gas."""
        with self._lock:
            return sum(session.started for session in self._sessions.values())

    def sweep(self) -> None:
        """Remove what no browser has held for `KEEP` seconds."""
        limit = self._clock() - KEEP
        with self._lock:
            gone = [one for one in self._sessions.values() if not one.attached and one.detached < limit]
            for session in gone:
                del self._sessions[session.id]
        for session in gone:
            session.close()

    def close(self) -> None:
        """End all sessions."""
        with self._lock:
            sessions, self._sessions = list(self._sessions.values()), {}
        for session in sessions:
            session.close()
