"""Who looks at a session: at most one browser at a time."""

from __future__ import annotations

import time

from gasbox.app.mailbox import Mailbox

__all__ = ["Audience"]


class Audience:
    """The mailbox of the browser that shows a session, or none. Any thread may call this.

    Attributes
    ----------
    detached : when the last browser was lost [s of the monotonic clock], or when this was made
    """

    def __init__(self) -> None:
        self.detached = time.monotonic()
        self._mailbox: Mailbox | None = None

    @property
    def attached(self) -> bool:
        """Whether a frame socket is connected, seen or not."""
        return self._mailbox is not None

    @property
    def watching(self) -> bool:
        """Whether frames are really looked at: connected, visible, acks arriving."""
        mailbox = self._mailbox
        return mailbox is not None and mailbox.is_watched()

    @property
    def shown_fps(self) -> float:
        """Frames that the browser draws per second, lately."""
        mailbox = self._mailbox
        return 0.0 if mailbox is None else mailbox.shown_fps()

    def attach(self, mailbox: Mailbox) -> None:
        """From now on this mailbox, and no longer an earlier one."""
        old, self._mailbox = self._mailbox, mailbox
        if old is not None:
            old.close()

    def detach(self, mailbox: Mailbox) -> None:
        """This mailbox is gone."""
        mailbox.close()
        if self._mailbox is mailbox:
            self._mailbox = None
            self.detached = time.monotonic()

    def tell(self, text: str, *, stale: bool = False) -> None:
        """A text message of the protocol; `stale` says that the frame before it is worth nothing now."""
        mailbox = self._mailbox
        if mailbox is not None:
            mailbox.put_text(text, stale=stale)

    def view(self, text: str) -> None:
        """What there is to show of the world, in place of what is still waiting."""
        mailbox = self._mailbox
        if mailbox is not None:
            mailbox.put_view(text)

    def wants_frames(self) -> bool:
        """Whether a frame would be of any use."""
        mailbox = self._mailbox
        return mailbox is not None and not mailbox.hidden

    def show(self, frame: bytes) -> None:
        """A frame, in place of one that is still waiting."""
        mailbox = self._mailbox
        if mailbox is not None:
            mailbox.put_frame(frame)

    def dismiss(self) -> None:
        """The session ends."""
        if self._mailbox is not None:
            self._mailbox.close()
