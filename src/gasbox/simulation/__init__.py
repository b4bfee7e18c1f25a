"""The loop: a simulation, the frames of a run, snapshots, and the summary."""

from gasbox.simulation.loop import run
from gasbox.simulation.simulation import Simulation

__all__ = ["Simulation", "run"]
