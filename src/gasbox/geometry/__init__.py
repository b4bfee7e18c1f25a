"""Shapes: areas, accessible regions, walls."""

from gasbox.geometry.elements import Element, ElementKind, side_count, side_names
from gasbox.geometry.enclosure import Container, Enclosure
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import (
    Block,
    Circle,
    Obstacle,
    Point,
    Polygon,
    Post,
    Segment,
    regular_polygon,
    signed_area,
)
from gasbox.geometry.wall import Gate, Motion, Passage, Path, Piston, Sinusoid, Wall

Geometry = Rectangle | Enclosure
"""What engines and observers work with: a plain rectangle, or anything else."""

__all__ = [
    "Block",
    "Circle",
    "Container",
    "Element",
    "ElementKind",
    "Enclosure",
    "Gate",
    "Geometry",
    "Motion",
    "Obstacle",
    "Passage",
    "Path",
    "Piston",
    "Point",
    "Polygon",
    "Post",
    "Rectangle",
    "Segment",
    "Sinusoid",
    "Wall",
    "regular_polygon",
    "side_count",
    "side_names",
    "signed_area",
]
