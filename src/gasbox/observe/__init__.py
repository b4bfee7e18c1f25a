"""What is measured on a gas: plain functions of state and tallies, and observers that follow a run.

Functions say None where a quantity does not exist (no particles, no walls, no time), never zero.
"""

from gasbox.observe.average import HistogramAverage
from gasbox.observe.balance import Balance, EnergyBalance
from gasbox.observe.blocks import block_error
from gasbox.observe.capacity import capacity_at_fixed_energy, capacity_at_fixed_temperature
from gasbox.observe.collisions import (
    CollisionRates,
    collision_rates,
    mean_free_path,
    species_mean_free_path,
)
from gasbox.observe.contact_log import ContactCounter, ContactLog
from gasbox.observe.diffusion import Displacements, MeanSquaredDisplacement, diffusion_coefficient
from gasbox.observe.energy import (
    angular_momentum,
    degrees_of_freedom,
    enthalpy,
    internal_energy,
    kinetic_energy,
    momentum,
    potential_energy,
    rotational_temperature,
    species_temperature,
    temperature,
    thermal_energy,
    thermal_velocity,
    translational_temperature,
    vibrational_temperature,
)
from gasbox.observe.following import FollowsChanges
from gasbox.observe.gauge import WallGauge, WallSeries
from gasbox.observe.heating import HeatingCourse, HeatingCurve
from gasbox.observe.histograms import (
    Histogram,
    automatic_maximum,
    bin_edges,
    energy_histogram,
    histogram,
    speed_histogram,
)
from gasbox.observe.indicator import Indicator, IndicatorSeries
from gasbox.observe.modes import ModeEnergies, Modes, ModeSeries, mode_energies
from gasbox.observe.motion import center_of_mass, mean_speed, rms_speed
from gasbox.observe.neighbours import Neighbours, coordination, hexatic, hexatic_order, neighbours
from gasbox.observe.orientation import (
    NematicOrder,
    OrientationCorrelation,
    OrientationPairs,
    Turning,
    TurningCorrelation,
    nematic_order,
)
from gasbox.observe.phases import Phase, phase_shares, phases
from gasbox.observe.pressure import (
    common_accessible_area,
    virial_pressure,
    virial_pressure_error,
    wall_pressure,
    wall_pressure_error,
)
from gasbox.observe.profiles import Profile, ProfileAverage, Profiles
from gasbox.observe.rotation import (
    degrees_of_rotation,
    degrees_of_vibration,
    rotational_energies,
    translational_energies,
    vibrational_energies,
)
from gasbox.observe.series import Series, TimeSeries
from gasbox.observe.sides import (
    Centers,
    CenterSeries,
    Line,
    Sides,
    SideSeries,
    greatest_mixing_entropy,
    mixing,
    mixing_entropy,
    side_counts,
)
from gasbox.observe.stretches import LatentHeat, Stretch, branches, latent_heats, stretches
from gasbox.observe.strips import Axis, extent, strip_areas
from gasbox.observe.structure import PairDistribution, RadialDistribution
from gasbox.observe.walls import (
    MeanDisplacement,
    between,
    gauge_lengths,
    passage_rates,
    wall_pressure_errors,
    wall_pressures,
)

__all__ = [
    "Axis",
    "Balance",
    "CenterSeries",
    "Centers",
    "CollisionRates",
    "ContactCounter",
    "ContactLog",
    "Displacements",
    "EnergyBalance",
    "FollowsChanges",
    "HeatingCourse",
    "HeatingCurve",
    "Histogram",
    "HistogramAverage",
    "Indicator",
    "IndicatorSeries",
    "LatentHeat",
    "Line",
    "MeanDisplacement",
    "MeanSquaredDisplacement",
    "ModeEnergies",
    "ModeSeries",
    "Modes",
    "Neighbours",
    "NematicOrder",
    "OrientationCorrelation",
    "OrientationPairs",
    "PairDistribution",
    "Phase",
    "Profile",
    "ProfileAverage",
    "Profiles",
    "RadialDistribution",
    "Series",
    "SideSeries",
    "Sides",
    "Stretch",
    "TimeSeries",
    "Turning",
    "TurningCorrelation",
    "WallGauge",
    "WallSeries",
    "angular_momentum",
    "automatic_maximum",
    "between",
    "bin_edges",
    "block_error",
    "branches",
    "capacity_at_fixed_energy",
    "capacity_at_fixed_temperature",
    "center_of_mass",
    "collision_rates",
    "common_accessible_area",
    "coordination",
    "degrees_of_freedom",
    "degrees_of_rotation",
    "degrees_of_vibration",
    "diffusion_coefficient",
    "energy_histogram",
    "enthalpy",
    "extent",
    "gauge_lengths",
    "greatest_mixing_entropy",
    "hexatic",
    "hexatic_order",
    "histogram",
    "internal_energy",
    "kinetic_energy",
    "latent_heats",
    "mean_free_path",
    "mean_speed",
    "mixing",
    "mixing_entropy",
    "mode_energies",
    "momentum",
    "neighbours",
    "nematic_order",
    "passage_rates",
    "phase_shares",
    "phases",
    "potential_energy",
    "rms_speed",
    "rotational_energies",
    "rotational_temperature",
    "side_counts",
    "species_mean_free_path",
    "species_temperature",
    "speed_histogram",
    "stretches",
    "strip_areas",
    "temperature",
    "thermal_energy",
    "thermal_velocity",
    "translational_energies",
    "translational_temperature",
    "vibrational_energies",
    "vibrational_temperature",
    "virial_pressure",
    "virial_pressure_error",
    "wall_pressure",
    "wall_pressure_error",
    "wall_pressure_errors",
    "wall_pressures",
]
