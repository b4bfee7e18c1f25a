"""From a scenario to the gas at its start: places without overlap, and velocities."""

from gasbox.initial.overlaps import Overlap, separate, worst_overlap
from gasbox.initial.populate import populate

__all__ = ["Overlap", "populate", "separate", "worst_overlap"]
