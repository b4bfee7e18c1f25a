"""Rules of motion: each takes a state on in time and books the collisions that it executes."""

from gasbox.dynamics.changes import altered
from gasbox.dynamics.event_driven import EventDriven
from gasbox.dynamics.forced import Forced, ForcedSettings
from gasbox.dynamics.make_room import make_room
from gasbox.dynamics.pair_terms import pair_terms
from gasbox.dynamics.relax import relax, step_warning
from gasbox.dynamics.stepped import Stepped
from gasbox.dynamics.walk import Walk, WalkSettings, walk_settings

__all__ = [
    "EventDriven",
    "Forced",
    "ForcedSettings",
    "Stepped",
    "Walk",
    "WalkSettings",
    "altered",
    "make_room",
    "pair_terms",
    "relax",
    "step_warning",
    "walk_settings",
]
