"""What may be asked for: the scenario file, validated."""

from gasbox.scenario.baths import (
    Barostat,
    Heating,
    Langevin,
    Thermostat,
    VelocityRescaling,
    starting_temperature,
)
from gasbox.scenario.container import (
    CircleContainer,
    Container,
    PolygonContainer,
    RectangleContainer,
    RegularPolygonContainer,
)
from gasbox.scenario.demon import Demon
from gasbox.scenario.density import MIXTURE_LIMIT, ONE_SIZE_LIMIT, Crowd, centre_bounds
from gasbox.scenario.dynamics import EventDriven, Forced, Rooms, Stepped, Walk
from gasbox.scenario.epidemic import Epidemic
from gasbox.scenario.epidemic_rules import STAGES, lacking, reason_against
from gasbox.scenario.forces import Charges, Forces, PairForces
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.json_schema import schema
from gasbox.scenario.kinds import Kind
from gasbox.scenario.molecules import Bend, Bond, Molecule
from gasbox.scenario.obstacles import BlockObstacle, Obstacle, PostObstacle, SegmentObstacle
from gasbox.scenario.pair_laws import PairLaw, pair_laws
from gasbox.scenario.particles import Particles
from gasbox.scenario.placement import Placement
from gasbox.scenario.places import Places, places_of
from gasbox.scenario.pong import Pong
from gasbox.scenario.reading import load, parse, shipped
from gasbox.scenario.scenario import Scenario
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.setting import Setting
from gasbox.scenario.settings import with_settings
from gasbox.scenario.sites import sites_of
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Region, Species
from gasbox.scenario.units import Units
from gasbox.scenario.walls import WallSettings

__all__ = [
    "MIXTURE_LIMIT",
    "ONE_SIZE_LIMIT",
    "STAGES",
    "Barostat",
    "Bend",
    "BlockObstacle",
    "Bond",
    "Charges",
    "CircleContainer",
    "Container",
    "Crowd",
    "Demon",
    "Epidemic",
    "EventDriven",
    "Forced",
    "Forces",
    "Heating",
    "Histograms",
    "Kind",
    "Langevin",
    "Molecule",
    "Obstacle",
    "PairForces",
    "PairLaw",
    "Particles",
    "Placement",
    "Places",
    "PolygonContainer",
    "Pong",
    "PostObstacle",
    "RectangleContainer",
    "Region",
    "RegularPolygonContainer",
    "Rooms",
    "Scenario",
    "ScheduledChange",
    "SegmentObstacle",
    "Setting",
    "Snapshot",
    "Species",
    "Stepped",
    "Thermostat",
    "Units",
    "VelocityRescaling",
    "Walk",
    "WallSettings",
    "centre_bounds",
    "lacking",
    "load",
    "pair_laws",
    "parse",
    "places_of",
    "reason_against",
    "schema",
    "shipped",
    "sites_of",
    "starting_temperature",
    "with_settings",
]
