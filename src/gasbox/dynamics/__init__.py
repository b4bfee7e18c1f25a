"""Rules of motion: each takes a state on in time and books the collisions that it executes."""

from gasbox.dynamics.changes import altered
from gasbox.dynamics.event_driven import EventDriven
from gasbox.dynamics.stepped import Stepped

__all__ = ["EventDriven", "Stepped", "altered"]
