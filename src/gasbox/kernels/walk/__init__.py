"""People who walk about: tables, cells, steps."""

from gasbox.kernels.walk.advance import advance
from gasbox.kernels.walk.tables import Files, Ground, Manner, Walkers, files, ground

__all__ = ["Files", "Ground", "Manner", "Walkers", "advance", "files", "ground"]
