"""From a scenario to the gas at its start: places without overlap, and velocities."""

from gasbox.initial.overlaps import Overlap, separate, worst_overlap
from gasbox.initial.populate import populate
from gasbox.initial.remembered import recall_walls

__all__ = ["Overlap", "populate", "recall_walls", "separate", "worst_overlap"]
