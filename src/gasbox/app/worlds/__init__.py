"""What the page has for each kind of world: its controls, and charts of its own."""

from __future__ import annotations

from typing import Final

from gasbox.app.worlds.demon import DemonPanel
from gasbox.app.worlds.epidemic import EpidemicPanel
from gasbox.app.worlds.panel import MakePanel
from gasbox.app.worlds.pong import PongPanel

__all__ = ["PANELS"]

PANELS: Final[dict[str, MakePanel]] = {
    "demon": DemonPanel,
    "epidemic": EpidemicPanel,
    "pong": PongPanel,
}
"""Kind of world -> what makes its panel."""
