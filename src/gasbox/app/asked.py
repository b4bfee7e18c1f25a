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
        self._value: float | None = None
        self._until = 0.0

    def ask(self, value: float | None) -> None:
        """A value is wanted from now on."""
        self._value, self._until = value, self._clock() + _PATIENCE

    def is_old(self, value: float | None) -> bool:
        """Whether the gas has this value only because the wish is still on its way."""
        if value == self._value:
            self._until = 0.0
        return self._clock() < self._until
