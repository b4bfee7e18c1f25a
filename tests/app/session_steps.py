"""Steps that several tests of sessions take."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from gasbox.app import protocol
from gasbox.app.mailbox import Mailbox
from gasbox.app.session import Session


def until(condition: Callable[[], Any], seconds: float = 10.0) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it did not come true"
        time.sleep(0.005)


def open_mailbox(session: Session) -> Mailbox:
    mailbox = Mailbox(ring=lambda: None)
    session.attach(mailbox)
    session.settle()
    return mailbox


def frames(mailbox: Mailbox) -> list[protocol.WireFrame]:
    taken = iter(mailbox.take, None)
    return [protocol.decode_frame(message) for message in taken if isinstance(message, bytes)]
