"""Exact flight from collision to collision.

Each disc has a reference (position, velocity, time) from its last change of velocity, and one next event with a mutual
partner. Cells and the queue only find events; the time of an event is a pure function of the references.
"""

from gasbox.kernels.event_driven.advance import SORT, TURN, advance
from gasbox.kernels.event_driven.rebuild import project, rebuild, shift
from gasbox.kernels.event_driven.search import meet_moved
from gasbox.kernels.event_driven.sort_rows import sort_rows
from gasbox.kernels.event_driven.tables import Tables, tables

__all__ = [
    "SORT",
    "TURN",
    "Tables",
    "advance",
    "meet_moved",
    "project",
    "rebuild",
    "shift",
    "sort_rows",
    "tables",
]
