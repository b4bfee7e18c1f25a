"""Density and temperature along an axis, averaged over frames, with error bars.

Density is the number of discs per area that centres can reach: the count in a strip over the accessible area of the
strip, so that walls, corners and obstacles leave no dents of their own. Temperature is the mean kinetic energy per
disc, in the frame of `gasbox.observe.temperature`. Error bars are from blocks of frames (`gasbox.observe.blocks`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.blocks import block_error
from gasbox.observe.energy import thermal_velocity
from gasbox.observe.strips import Axis, direction_of, extent, strip_areas
from gasbox.state import Contacts, State, Tallies

__all__ = ["Axis", "Profile", "ProfileAverage", "Profiles"]

_SLIVER: Final = 1e-3
"""Of the largest strip."""


@dataclass(frozen=True)
class Profile:
    """One quantity in each strip; not-a-number where nothing can be said.

    Attributes
    ----------
    mean : (bins,) float64
    error : (bins,) float64, standard error of the mean
    """

    mean: NDArray[np.float64]
    error: NDArray[np.float64]


@dataclass(frozen=True)
class Profiles:
    """Profiles along an axis.

    Attributes
    ----------
    axis : x, y or an angle [radian]
    edges : (bins+1,) float64 [length], along the axis from the origin
    frames : how many were averaged
    density : one for each species [1/length²]
    temperature : one for each species [energy]
    whole_density, whole_temperature : of all discs
    """

    axis: Axis
    edges: NDArray[np.float64]
    frames: int
    density: tuple[Profile, ...]
    temperature: tuple[Profile, ...]
    whole_density: Profile
    whole_temperature: Profile

    @property
    def middles(self) -> NDArray[np.float64]:
        """(bins,) float64 [length]: middles of the strips."""
        return 0.5 * (self.edges[1:] + self.edges[:-1])


class ProfileAverage:
    """Averages profiles over the frames since a time.

    Parameters
    ----------
    geometry : what the gas is in
    radii : (species,) float64 [length]
    axis : x, y, or an angle [radian]
    bins : number of strips of the same width across the whole box, or their (bins+1,) edges [length]
    since : frames before are left out, so that a transient can pass [time]
    """

    reads_contacts = False

    def __init__(
        self,
        geometry: Geometry,
        radii: NDArray[np.float64],
        axis: Axis = "y",
        bins: int | Sequence[float] | NDArray[np.float64] = 30,
        since: float = -np.inf,
    ) -> None:
        self._geometry, self._axis, self._since = geometry, axis, since
        self._radii = np.asarray(radii, np.float64)
        self._edges = (
            np.linspace(*extent(geometry, axis), bins + 1)
            if isinstance(bins, int)
            else np.asarray(bins, np.float64)
        )
        self._last = -np.inf
        self._rows: list[tuple[NDArray[np.float64], ...]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all frames."""
        self._last, self._rows = -np.inf, []

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add a frame, unless it is too early or was seen already."""
        if state.time < self._since or state.time <= self._last:
            return
        self._last = state.time
        species, bins = self._radii.size, self._edges.size - 1
        along = state.position @ direction_of(self._axis)
        place = np.searchsorted(self._edges, along, side="right") - 1
        # The last strip holds its upper edge too.
        place[along == self._edges[-1]] = bins - 1
        inside = (place >= 0) & (place < bins)
        cell = (state.species * bins + place)[inside]
        energy = 0.5 * state.mass * np.sum(thermal_velocity(state, self._geometry) ** 2, axis=1)
        shape = (species, bins)
        counts = np.bincount(cell, minlength=species * bins).reshape(shape).astype(np.float64)
        heat = np.bincount(cell, energy[inside], minlength=species * bins).reshape(shape).astype(np.float64)
        here = self._geometry.at(state.wall_displacement)
        areas = np.array([strip_areas(here, radius, self._axis, self._edges) for radius in self._radii])
        self._rows.append((counts, heat, areas))

    def profiles(self) -> Profiles:
        """The mean over all frames so far."""
        shape = (-1, self._radii.size, self._edges.size - 1)
        counts, heat, areas = (np.array([row[k] for row in self._rows]).reshape(shape) for k in range(3))
        # A strip of which centres reach a sliver has no density to speak of.
        areas = np.where(areas > _SLIVER * np.max(areas, initial=0.0), areas, 0.0)
        return Profiles(
            self._axis,
            self._edges,
            len(self._rows),
            tuple(_ratio(counts[:, k], areas[:, k]) for k in range(shape[1])),
            tuple(_ratio(heat[:, k], counts[:, k]) for k in range(shape[1])),
            _sum_of(counts, areas),
            _ratio(np.sum(heat, axis=1), np.sum(counts, axis=1)),
        )


def _ratio(amount: NDArray[np.float64], per: NDArray[np.float64]) -> Profile:
    """Mean amount over mean per, (frames, bins) each; its error by that of what the ratio leaves unexplained."""
    if not amount.shape[0]:
        nothing = np.full(amount.shape[1], np.nan)
        return Profile(nothing, nothing)
    base = np.mean(per, axis=0)
    base = np.where(base > 0.0, base, np.nan)
    mean = np.mean(amount, axis=0) / base
    return Profile(mean, block_error(amount - mean * per) / base)


def _sum_of(counts: NDArray[np.float64], areas: NDArray[np.float64]) -> Profile:
    """Sum of the densities of all species; a species that cannot be there adds nothing."""
    if not counts.shape[0]:
        nothing = np.full(counts.shape[2], np.nan)
        return Profile(nothing, nothing)
    room = np.mean(areas, axis=0)
    share = np.divide(1.0, room, out=np.zeros(room.shape), where=room > 0.0)
    density = np.sum(counts * share, axis=1)
    reachable = np.any(room > 0.0, axis=0)
    return Profile(
        np.where(reachable, np.mean(density, axis=0), np.nan),
        np.where(reachable, block_error(density), np.nan),
    )
