"""What the gas is at one moment, and what happened to it."""

from gasbox.state.change import (
    Change,
    Control,
    MoveWall,
    ParticleChange,
    RemoveParticles,
    Reply,
    SetBarostat,
    SetGate,
    SetGravity,
    SetHeating,
    SetParticles,
    SetThermostat,
    SetWalkers,
    SetWall,
    SetWorld,
    Surrounding,
    Way,
)
from gasbox.state.contacts import ContactKind, Contacts
from gasbox.state.fields import FIELDS, ROTATION, Field
from gasbox.state.frame import Frame, Memory
from gasbox.state.sites import Sites
from gasbox.state.state import State
from gasbox.state.tallies import Tallies

__all__ = [
    "FIELDS",
    "ROTATION",
    "Change",
    "ContactKind",
    "Contacts",
    "Control",
    "Field",
    "Frame",
    "Memory",
    "MoveWall",
    "ParticleChange",
    "RemoveParticles",
    "Reply",
    "SetBarostat",
    "SetGate",
    "SetGravity",
    "SetHeating",
    "SetParticles",
    "SetThermostat",
    "SetWalkers",
    "SetWall",
    "SetWorld",
    "Sites",
    "State",
    "Surrounding",
    "Tallies",
    "Way",
]
