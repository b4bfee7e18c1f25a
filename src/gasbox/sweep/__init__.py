"""Many runs of one kind, on all cores: the phase diagram of Lennard-Jones discs."""

from gasbox.sweep.crew import measured
from gasbox.sweep.diary import Diary
from gasbox.sweep.grid import FULL, QUICK, Recipe, grid_points
from gasbox.sweep.point import Point, measure, scenario_at
from gasbox.sweep.verdict import MATTERS, Matter, verdict

__all__ = [
    "FULL",
    "MATTERS",
    "QUICK",
    "Diary",
    "Matter",
    "Point",
    "Recipe",
    "grid_points",
    "measure",
    "measured",
    "scenario_at",
    "verdict",
]
