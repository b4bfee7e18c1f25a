"""Shapes of containers: areas, walls and what centres of discs can reach."""

from gasbox.geometry.rectangle import Rectangle

__all__ = ["Rectangle"]
