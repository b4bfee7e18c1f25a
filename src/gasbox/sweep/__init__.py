"""Many runs of one kind, on all cores: one scenario with many seeds; the phase diagram of Lennard-Jones discs."""

from gasbox.sweep.crew import done_together
from gasbox.sweep.diary import Diary
from gasbox.sweep.gathered import Gathered, gathered
from gasbox.sweep.grid import FULL, QUICK, Recipe, grid_points
from gasbox.sweep.members import Failure, Member, Plan, ensemble, plan_for
from gasbox.sweep.point import Point, measure, measured, scenario_at
from gasbox.sweep.spread import QUANTILES, Spread, spread
from gasbox.sweep.verdict import MATTERS, Matter, verdict

__all__ = [
    "FULL",
    "MATTERS",
    "QUANTILES",
    "QUICK",
    "Diary",
    "Failure",
    "Gathered",
    "Matter",
    "Member",
    "Plan",
    "Point",
    "Recipe",
    "Spread",
    "done_together",
    "ensemble",
    "gathered",
    "grid_points",
    "measure",
    "measured",
    "plan_for",
    "scenario_at",
    "spread",
    "verdict",
]
