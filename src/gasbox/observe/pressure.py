"""Pressure, measured twice: from impulses on the walls, and from the virial of the collisions, or forces, of pairs.

Both are force per length and both refer to the region that the *centres* of discs can reach, which ends one
radius before a wall. In a plain box the two are tied by the virial theorem and agree in the long run. Nothing
here knows an equation of state.

In a container of any shape the pressure at the walls is that of all walls together, each weighted by its length, and
the virial one is the mean over the area; in gravity, or where chambers differ, neither holds at every place
(`gasbox.observe.wall_pressures` has each wall by itself). Where walls move, give the geometry at their mean
displacement (`gasbox.observe.between`).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry, Rectangle
from gasbox.geometry.conserved import conserves_rotation
from gasbox.observe.energy import degrees_of_freedom
from gasbox.observe.walls import gauge_lengths
from gasbox.state import Tallies

__all__ = [
    "common_accessible_area",
    "virial_pressure",
    "virial_pressure_error",
    "wall_pressure",
    "wall_pressure_error",
]


def wall_pressure(
    change: Tallies, geometry: Geometry, radii: NDArray[np.float64], duration: float
) -> float | None:
    """Impulse on the walls per time and length [mass/time²].

    Sum over the species of (impulse on all walls)/(duration · length of these walls that its centres can
    touch). Walls that a species passes, all or in part, open walls and absent ones do not count.

    Parameters
    ----------
    change : what was added to the tallies meanwhile (later - earlier)
    radii : (species,) float64 [length]
    duration : [time]

    Returns
    -------
    None without walls or for a duration of zero.
    """
    partial = _partial_wall_pressures(change, geometry, radii, duration)
    return None if partial is None else float(np.sum(partial))


def wall_pressure_error(
    change: Tallies, geometry: Geometry, radii: NDArray[np.float64], duration: float
) -> float | None:
    """Standard error of `wall_pressure` [mass/time²].

    Hits taken as independent with Maxwell's law: P_s sqrt(4/(pi hits_s)) of each species, added in squares.
    True of a dilute gas; None without any hit.
    """
    partial = _partial_wall_pressures(change, geometry, radii, duration)
    if partial is None:
        return None
    hits = np.sum(change.wall_collisions, axis=0, where=gauge_lengths(geometry, radii) > 0.0)
    if not np.any(hits):
        return None
    met = hits > 0
    return math.sqrt(float(np.sum(4.0 / math.pi * partial[met] ** 2 / hits[met])))


def virial_pressure(
    change: Tallies,
    geometry: Geometry,
    radii: NDArray[np.float64],
    counts: NDArray[np.int64],
    *,
    temperature: float | None,
    duration: float,
) -> float | None:
    """Pressure from the collisions of pairs, (N T + sum |impulse| distance/(2 duration))/A [mass/time²].

    Under forces the sum is the time integral of the sum of force times distance.

    The ideal part is N T with T = 2K/f, not K. Between walls the two are the same. Where momentum is
    conserved N T is the larger, and the pressure is then the thermodynamic one, -dF/dA: the free place of the
    centre of mass contributes its T/A although it never moves. For two discs in a periodic box this gives the
    exact Z = (1/2) [1 + 1/(1 - 2 eta)]. In a smooth circle the ideal part is K, as the virial theorem has it; a gas
    that rotates there presses on its wall with more than this.

    A is `common_accessible_area`; in a periodic box the whole area.

    Under forces K is not conserved, and a barostat changes the area: where the tallies hold their time integrals, T is
    2/f times the mean kinetic energy (of the gas at rest as a whole: a drift is not taken off), and A the mean area.

    Of molecules the places, forces and velocities are those of their centres of mass, so that T is that of translation
    alone. It fluctuates then without forces too, by T sqrt((1 - 2/f)/N) with f degrees of freedom each; in equilibrium
    its mean is that of the whole gas.

    Parameters
    ----------
    change : what was added to the tallies meanwhile (later - earlier)
    radii, counts : (species,) [length], number of particles
    temperature : as `gasbox.observe.translational_temperature` gives it; of discs this is T
    duration : [time]

    Returns
    -------
    None for a duration of zero, without a temperature, or without an area.

    Source: B. J. Alder and T. E. Wainwright, J. Chem. Phys. 33, 1439 (1960), doi:10.1063/1.1731425, in two
    dimensions.
    """
    # Under forces sums go over whole spans between measurements.
    duration = float(change.measured_time[0]) or duration
    area = _mean_area(change, geometry, radii, counts, duration)
    if duration <= 0.0 or temperature is None or area is None:
        return None
    count = int(np.sum(counts))
    if change.kinetic_time[0] > 0.0:
        freedom = degrees_of_freedom(count, geometry)
        temperature = 2.0 * float(change.kinetic_time[0]) / (duration * freedom)
    ideal = count * temperature
    if conserves_rotation(geometry):
        ideal = 0.5 * degrees_of_freedom(count, geometry) * temperature
    return (ideal + float(change.pair_virial[0]) / (2.0 * duration)) / area


def virial_pressure_error(
    change: Tallies,
    geometry: Geometry,
    radii: NDArray[np.float64],
    counts: NDArray[np.int64],
    *,
    duration: float,
) -> float | None:
    """Standard error of `virial_pressure` [mass/time²]: its collision part/sqrt(collisions), +- 20 %.

    The ideal part has none, because T is conserved; of molecules that of translation fluctuates, and this is left out.
    Empirical, for area fractions of 0.05 to 0.65.
    """
    area = common_accessible_area(geometry, radii, counts)
    collisions = int(np.sum(change.pair_collisions))
    if duration <= 0.0 or area is None or collisions == 0:
        return None
    return float(change.pair_virial[0]) / (2.0 * duration) / area / math.sqrt(collisions)


def common_accessible_area(
    geometry: Geometry, radii: NDArray[np.float64], counts: NDArray[np.int64]
) -> float | None:
    """One area for species of several sizes [length²]: N/sum_s(N_s/A_s), A_s what centres of s can reach.

    This mean makes the ideal part N T/A the sum of the ideal partial pressures N_s T/A_s, so that both routes
    to the pressure agree exactly in the dilute limit. None without particles, or where one does not fit.
    """
    present = np.flatnonzero(counts)
    areas = np.array([geometry.accessible_area(float(radii[species])) for species in present])
    sizes = np.array([min(geometry.accessible_size(float(radii[species]))) for species in present])
    if present.size == 0 or np.any(sizes <= 0.0):
        return None
    return float(np.sum(counts[present]) / np.sum(counts[present] / areas))


def _mean_area(
    change: Tallies,
    geometry: Geometry,
    radii: NDArray[np.float64],
    counts: NDArray[np.int64],
    duration: float,
) -> float | None:
    """`common_accessible_area`, in a periodic box the mean over the time where that is tallied."""
    if (
        duration > 0.0
        and change.area_time[0] > 0.0
        and isinstance(geometry, Rectangle)
        and not geometry.is_walled
    ):
        return float(change.area_time[0]) / duration
    return common_accessible_area(geometry, radii, counts)


def _partial_wall_pressures(
    change: Tallies, geometry: Geometry, radii: NDArray[np.float64], duration: float
) -> NDArray[np.float64] | None:
    """(species,) float64 [mass/time²]: what each species contributes; None without walls or time."""
    lengths = gauge_lengths(geometry, radii)
    if duration <= 0.0 or not np.any(lengths):
        return None
    impulse = np.sum(change.wall_impulse, axis=0, where=lengths > 0.0)
    whole = np.sum(lengths, axis=0)
    # A species too large for the box has no length to touch, and no impulse either.
    partial = np.zeros(whole.shape)
    np.divide(impulse, duration * whole, out=partial, where=whole > 0.0)
    return partial
