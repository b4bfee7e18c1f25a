"""Through which stages people go: the numbers that stand for them, in kernels and above."""

from __future__ import annotations

__all__ = ["ASYMPTOMATIC", "DEAD", "EXPOSED", "INFECTIOUS", "RECOVERED", "SUSCEPTIBLE", "VACCINATED"]

SUSCEPTIBLE, EXPOSED, INFECTIOUS, ASYMPTOMATIC, RECOVERED, DEAD, VACCINATED = range(7)
