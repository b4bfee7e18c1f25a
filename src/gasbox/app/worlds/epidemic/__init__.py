"""The page of an epidemic: measures under the box, curves beside it, and two runs side by side."""

from gasbox.app.worlds.epidemic.panel import EpidemicPanel

__all__ = ["EpidemicPanel"]
