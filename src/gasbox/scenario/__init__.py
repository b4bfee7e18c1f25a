"""What may be asked for: the scenario file, validated."""

from gasbox.scenario.container import RectangleContainer
from gasbox.scenario.density import MIXTURE_LIMIT, ONE_SIZE_LIMIT, Crowd, crowds
from gasbox.scenario.dynamics import EventDriven, Stepped
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.json_schema import schema
from gasbox.scenario.particles import Particles
from gasbox.scenario.reading import load, parse, shipped
from gasbox.scenario.scenario import Scenario
from gasbox.scenario.settings import with_settings
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Region, Species

__all__ = [
    "MIXTURE_LIMIT",
    "ONE_SIZE_LIMIT",
    "Crowd",
    "EventDriven",
    "Histograms",
    "Particles",
    "RectangleContainer",
    "Region",
    "Scenario",
    "Snapshot",
    "Species",
    "Stepped",
    "crowds",
    "load",
    "parse",
    "schema",
    "shipped",
    "with_settings",
]
