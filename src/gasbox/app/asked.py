"""What a control has asked for last: until that is done, what the gas has is old news and must not move the control."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Final

__all__ = ["Asked"]

_PATIENCE: Final = 0.8
"""Seconds after which a change that was not made counts as refused."""


class Asked:
    """The newest wish for a value; None is a value as any other.

    Parameters
    ----------
    clock : in seconds
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._value: object = None
        self._until = 0.0

    def ask(self, value: object) -> None:
        """A value is wanted from now on."""
        self._value, self._until = value, self._clock() + _PATIENCE

    def is_old(self, value: object) -> bool:
        """Whether the gas has this value only because the wish is still on its way."""
        # The same value may be from before the last wishes: only time tells that none is left on its way.
        return value != self._value and self._clock() < self._until
