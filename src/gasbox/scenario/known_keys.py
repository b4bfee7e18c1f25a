"""Which keys are known where, for messages about those that are not."""

from __future__ import annotations

from typing import Final

from gasbox.scenario.baths import Barostat, BarostatAim, Heating, Langevin, ThermostatAim, VelocityRescaling
from gasbox.scenario.container import SHAPES
from gasbox.scenario.dynamics import KINDS, Rooms
from gasbox.scenario.epidemic import (
    ByCloseness,
    ByContact,
    Central,
    Distancing,
    Duration,
    Quarantine,
    Travel,
    Vaccination,
)
from gasbox.scenario.forces import Charges, Forces, PairForces
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.molecules import Atom, Bend, Bond, Molecule
from gasbox.scenario.motions import ConstantMotion, PathMotion, PistonMotion, SinusoidMotion
from gasbox.scenario.obstacles import STANDING
from gasbox.scenario.pong import Players
from gasbox.scenario.problems import KnownKeys
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Region, Species
from gasbox.scenario.units import Units
from gasbox.scenario.values import Section
from gasbox.scenario.walls import Passes, WallSettings, Way
from gasbox.scenario.world import WORLDS

__all__ = ["KNOWN_KEYS", "keys_of"]


def keys_of(*sections: type[Section]) -> tuple[str, ...]:
    """Keys of one or several sections as they stand in a file, each once."""
    fields = (entry for section in sections for entry in section.model_fields.items())
    return tuple(dict.fromkeys(field.alias or name for name, field in fields))


_MOTION_KEYS: Final = keys_of(ConstantMotion, PathMotion, SinusoidMotion, PistonMotion)

KNOWN_KEYS: Final[KnownKeys] = {
    ("container",): keys_of(*SHAPES.values()),
    ("walls",): keys_of(WallSettings),
    ("walls", "passes"): keys_of(Passes),
    ("walls", "passes", "forward"): keys_of(Way),
    ("walls", "passes", "backward"): keys_of(Way),
    ("walls", "motion"): _MOTION_KEYS,
    ("obstacles",): keys_of(*STANDING.values()),
    ("obstacles", "passes"): keys_of(Passes),
    ("obstacles", "passes", "forward"): keys_of(Way),
    ("obstacles", "passes", "backward"): keys_of(Way),
    ("obstacles", "motion"): _MOTION_KEYS,
    ("schedule",): keys_of(ScheduledChange),
    ("schedule", "thermostat"): keys_of(ThermostatAim),
    ("schedule", "barostat"): keys_of(BarostatAim),
    ("schedule", "heating"): keys_of(Heating),
    ("species",): keys_of(Species),
    ("species", "region"): keys_of(Region),
    ("molecules",): keys_of(Molecule),
    ("molecules", "atoms"): keys_of(Atom),
    ("molecules", "bonds"): keys_of(Bond),
    ("molecules", "angles"): keys_of(Bend),
    ("molecules", "region"): keys_of(Region),
    ("dynamics",): keys_of(*KINDS.values()),
    ("dynamics", "rooms"): keys_of(Rooms),
    ("dynamics", "rooms", "region"): keys_of(Region),
    ("forces",): keys_of(Forces),
    ("forces", "pairs"): keys_of(PairForces),
    ("forces", "charges"): keys_of(Charges),
    ("thermostat",): keys_of(Langevin, VelocityRescaling),
    ("barostat",): keys_of(Barostat),
    ("heating",): keys_of(Heating),
    ("world",): keys_of(*WORLDS.values()),
    ("world", "transmission"): keys_of(ByCloseness, ByContact),
    ("world", "exposed"): keys_of(Duration),
    ("world", "infectious"): keys_of(Duration),
    ("world", "distancing"): keys_of(Distancing),
    ("world", "quarantine"): keys_of(Quarantine),
    ("world", "quarantine", "box"): keys_of(Region),
    ("world", "travel"): keys_of(Travel),
    ("world", "central"): keys_of(Central),
    ("world", "vaccination"): keys_of(Vaccination),
    ("world", "players"): keys_of(Players),
    ("units",): keys_of(Units),
    ("histograms",): keys_of(Histograms),
    ("snapshot",): keys_of(Snapshot),
}
"""All but those of the scenario itself."""
