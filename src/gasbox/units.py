"""Reduced units: k_B = 1; mass, length and time are the scenario's own. Everything is two-dimensional.

The names of units stand here once; axes, tables and documentation take them from here.
"""

from __future__ import annotations

from typing import Final

__all__ = ["UNIT"]

UNIT: Final[dict[str, str]] = {
    "mass": "mass",
    "radius": "length",
    "position": "length",
    "velocity": "length/time",
    "speed": "length/time",
    "time": "time",
    "energy": "mass·length²/time²",
    "temperature": "mass·length²/time²",
    "momentum": "mass·length/time",
    "pressure": "mass/time²",
    "impulse": "mass·length/time",
    "rate": "1/time",
    "area": "length²",
    "angle": "rad",
    "angular_velocity": "rad/time",
    "inertia": "mass·length²",
}
"""Unit of each quantity. Temperature is an energy (k_B = 1); pressure is force per length."""
