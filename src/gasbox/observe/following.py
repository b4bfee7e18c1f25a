"""Observers that must know when gravity or a wall is changed."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from gasbox.geometry import Geometry
from gasbox.state import State

__all__ = ["FollowsChanges"]


@runtime_checkable
class FollowsChanges(Protocol):
    """What an observer has that measures by the geometry."""

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry; `state` as it is at that moment."""
        ...
