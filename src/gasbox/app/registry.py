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

    Parameters
    ----------
    max_sessions : how many gases there may be at a time
    prepare, simulate : passed on to each session
    """

    def __init__(
        self,
        max_sessions: int = 16,
        make: Callable[..., Session] = Session,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.max_sessions = max_sessions
        self.announcement: str | None = None
        """A text that also a browser gets that connects later."""
        self._make = make
        self._clock = clock
        self._lock = threading.Lock()
        self._sessions: dict[str, Session] = {}
        self._seated: set[str] = set()

    @property
    def seated(self) -> int:
        """How many sessions have a gas."""
        return len(self._seated)

    def open(self, scenario: Scenario) -> Session:
        """A new session for a page that is being built; it starts when its frame socket connects."""
        session = self._make(scenario, admit=self._admit)
        session.home = self
        with self._lock:
            self._sessions[session.id] = session
        return session

    def find(self, session_id: str) -> Session | None:
        """The session with this id, if it is still there."""
        with self._lock:
            return self._sessions.get(session_id)

    def inherit(self, heir: Session, previous_id: str) -> bool:
        """Give `heir` the gas of an earlier load of the same page; whether there was one to give. Waits.

        Only a session that no browser holds can be inherited: a duplicated tab gets a gas of its own.
        """
        with self._lock:
            previous = self._sessions.get(previous_id)
            if previous is None or previous is heir or heir.started:
                return False
            if previous.version == 0 or previous.audience.attached or previous.origin is not heir.origin:
                return False
            self._remove(previous)
        previous.hand_over(heir)
        return True

    def announce(self, text: str | None) -> None:
        """Tell every browser, also those that connect later, until None takes it back."""
        self.announcement = text
        if text is not None:
            with self._lock:
                sessions = list(self._sessions.values())
            for session in sessions:
                session.audience.tell(text)

    def sweep(self) -> None:
        """Remove what no browser has held for `KEEP` seconds. Waits for the threads of those."""
        limit = self._clock() - KEEP
        with self._lock:
            gone = [
                one
                for one in self._sessions.values()
                if not one.audience.attached and one.audience.detached < limit
            ]
            for session in gone:
                self._remove(session)
        for session in gone:
            session.close()

    def close(self) -> None:
        """End all sessions."""
        with self._lock:
            sessions = list(self._sessions.values())
            self._sessions.clear()
            self._seated.clear()
        for session in sessions:
            session.close()

    def dismiss(self, session: Session) -> None:
        """End a session, and free its place. Waits for the beat at hand."""
        with self._lock:
            if session.id in self._sessions:
                self._remove(session)
        session.close()

    def _admit(self, session: Session) -> None:
        with self._lock:
            if session.id not in self._sessions:
                raise BusyError("this page is no longer known to the lab")
            if session.id not in self._seated and len(self._seated) >= self.max_sessions:
                raise BusyError(f"all {self.max_sessions} places of this lab are taken")
            self._seated.add(session.id)

    def _remove(self, session: Session) -> None:
        del self._sessions[session.id]
        self._seated.discard(session.id)
