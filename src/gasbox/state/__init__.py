"""What the gas is at one moment, and what happened to it."""

from gasbox.state.change import Change, MoveWall, SetGravity, SetWall
from gasbox.state.contacts import ContactKind, Contacts
from gasbox.state.fields import FIELDS, Field
from gasbox.state.frame import Frame, Memory
from gasbox.state.state import State
from gasbox.state.tallies import Tallies

__all__ = [
    "FIELDS",
    "Change",
    "ContactKind",
    "Contacts",
    "Field",
    "Frame",
    "Memory",
    "MoveWall",
    "SetGravity",
    "SetWall",
    "State",
    "Tallies",
]
