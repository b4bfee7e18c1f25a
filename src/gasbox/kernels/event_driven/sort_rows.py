"""Put particles that are neighbours in the box near each other in memory."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.tables import LABEL, LEVEL, SPECIES, T0, VX, Tables, X
from gasbox.kernels.hall import Hall
from gasbox.kernels.molecules.spin import Spin

__all__ = ["sort_rows"]


def _spread(value: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """The lowest 16 bits of each value, with a zero after each bit."""
    for shift, mask in ((8, 0x00FF00FF), (4, 0x0F0F0F0F), (2, 0x33333333), (1, 0x55555555)):
        value = (value | (value << np.uint64(shift))) & np.uint64(mask)
    return value


def sort_rows(tables: Tables, box: Box, hall: Hall | None, spin: Spin | None, now: float) -> None:
    """Sort the rows along a Z-shaped curve through the box, by the places at time `now` (since the epoch's start).

    Links between rows become invalid: a rebuild must follow.

    Source: G. M. Morton, A computer oriented geodetic data base (IBM, 1966).
    """
    flight = tables.flight
    elapsed = now - flight[:, T0 : T0 + 1]
    place = flight[:, X : X + 2] + flight[:, VX : VX + 2] * elapsed
    if hall is not None:
        place += 0.5 * elapsed**2 * (hall.gx, hall.gy)
    unit = place / (box.width, box.height)
    unit -= np.floor(unit) * (box.periodic_x, box.periodic_y)
    whole = (np.clip(unit, 0.0, 1.0) * 65535).astype(np.uint64)
    order = np.argsort(_spread(whole[:, 0]) | (_spread(whole[:, 1]) << np.uint64(1)), kind="stable")
    flight[:] = flight[order]
    tables.mass[:] = tables.mass[order]
    if spin is not None:
        spin.turn[:] = spin.turn[order]
    for column in (LEVEL, LABEL, SPECIES):
        tables.link[:, column] = tables.link[order, column]
