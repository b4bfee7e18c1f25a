"""Colours for species that bring none."""

from __future__ import annotations

from typing import Final

__all__ = ["PALETTE"]

PALETTE: Final[tuple[str, ...]] = (
    "#5b6cf0",
    "#e05a00",
    "#009e73",
    "#b85fd0",
    "#ae5c32",
    "#8084a1",
)
"""Mid-tones: at least 3:1 against a white and a near-black page, and apart for colour-blind eyes."""
