"""What is measured on a gas: plain functions of state and tallies, and observers that follow a run.

Functions say None where a quantity does not exist (no particles, no walls, no time), never zero.
"""

from gasbox.observe.average import HistogramAverage
from gasbox.observe.collisions import (
    CollisionRates,
    collision_rates,
    mean_free_path,
    species_mean_free_path,
)
from gasbox.observe.contact_log import ContactCounter, ContactLog
from gasbox.observe.energy import (
    degrees_of_freedom,
    kinetic_energy,
    momentum,
    species_temperature,
    temperature,
    thermal_energy,
)
from gasbox.observe.histograms import (
    Histogram,
    automatic_maximum,
    bin_edges,
    energy_histogram,
    histogram,
    speed_histogram,
)
from gasbox.observe.motion import center_of_mass, mean_speed, rms_speed
from gasbox.observe.pressure import (
    common_accessible_area,
    virial_pressure,
    virial_pressure_error,
    wall_pressure,
    wall_pressure_error,
)
from gasbox.observe.series import Series, TimeSeries

__all__ = [
    "CollisionRates",
    "ContactCounter",
    "ContactLog",
    "Histogram",
    "HistogramAverage",
    "Series",
    "TimeSeries",
    "automatic_maximum",
    "bin_edges",
    "center_of_mass",
    "collision_rates",
    "common_accessible_area",
    "degrees_of_freedom",
    "energy_histogram",
    "histogram",
    "kinetic_energy",
    "mean_free_path",
    "mean_speed",
    "momentum",
    "rms_speed",
    "species_mean_free_path",
    "species_temperature",
    "speed_histogram",
    "temperature",
    "thermal_energy",
    "virial_pressure",
    "virial_pressure_error",
    "wall_pressure",
    "wall_pressure_error",
]
