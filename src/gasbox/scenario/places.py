"""Where walkers can be: rooms, the central place of each, a box for quarantine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario.dynamics import Rooms
from gasbox.scenario.epidemic import Epidemic
from gasbox.scenario.rooms import ends_of, room_boxes
from gasbox.scenario.scenario import Scenario

__all__ = ["Places", "places_of"]


@dataclass(frozen=True)
class Places:
    """Boxes, each as left, lower, right and upper end [length].

    Attributes
    ----------
    rooms : (m, 4) float64 [length], row by row from below
    central : (m, 4) float64 [length], in the middle of each room
    quarantine : (4,) float64 [length], or None
    """

    rooms: NDArray[np.float64]
    central: NDArray[np.float64]
    quarantine: NDArray[np.float64] | None

    @property
    def table(self) -> NDArray[np.float64]:
        """(2 m or 2 m + 1, 4) float64 [length]: all of them, rooms first, then central places, then quarantine."""
        rest = [] if self.quarantine is None else [self.quarantine[None]]
        return np.concatenate([self.rooms, self.central, *rest])


def places_of(scenario: Scenario) -> Places:
    """The places of a scenario; of one without rooms, the whole container as the only room."""
    geometry = scenario.geometry()
    size = float(geometry.width), float(geometry.height)
    rooms = room_boxes(getattr(scenario.dynamics, "rooms", Rooms()), size)
    world = scenario.world if isinstance(scenario.world, Epidemic) else Epidemic()
    middle = (rooms[:, :2] + rooms[:, 2:]) / 2
    half = (rooms[:, 2:] - rooms[:, :2]) * world.central.size / 2
    box = world.quarantine.box
    return Places(
        rooms,
        np.concatenate([middle - half, middle + half], axis=1),
        None if box is None else ends_of(box, size),
    )
