"""What may be asked for: the scenario file, validated."""

from gasbox.scenario.container import (
    CircleContainer,
    Container,
    PolygonContainer,
    RectangleContainer,
    RegularPolygonContainer,
)
from gasbox.scenario.density import MIXTURE_LIMIT, ONE_SIZE_LIMIT, Crowd, centre_bounds, crowds
from gasbox.scenario.dynamics import EventDriven, Stepped
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.json_schema import schema
from gasbox.scenario.obstacles import BlockObstacle, Obstacle, PostObstacle, SegmentObstacle
from gasbox.scenario.particles import Particles
from gasbox.scenario.reading import load, parse, shipped
from gasbox.scenario.scenario import Scenario
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.settings import with_settings
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Region, Species
from gasbox.scenario.walls import WallSettings

__all__ = [
    "MIXTURE_LIMIT",
    "ONE_SIZE_LIMIT",
    "BlockObstacle",
    "CircleContainer",
    "Container",
    "Crowd",
    "EventDriven",
    "Histograms",
    "Obstacle",
    "Particles",
    "PolygonContainer",
    "PostObstacle",
    "RectangleContainer",
    "Region",
    "RegularPolygonContainer",
    "Scenario",
    "ScheduledChange",
    "SegmentObstacle",
    "Snapshot",
    "Species",
    "Stepped",
    "WallSettings",
    "centre_bounds",
    "crowds",
    "load",
    "parse",
    "schema",
    "shipped",
    "with_settings",
]
