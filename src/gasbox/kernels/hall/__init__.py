"""Enclosures of any shape, for every hard-disc dynamics: what can be touched, when, and what happens then."""

from gasbox.kernels.hall.near import with_cells
from gasbox.kernels.hall.tables import Hall, hall, set_motion

__all__ = ["Hall", "hall", "set_motion", "with_cells"]
