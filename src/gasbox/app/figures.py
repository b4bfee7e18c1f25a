"""The numbers that the page shows beside the box, from one sample and what happened lately."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gasbox.app.sample import Sample
from gasbox.app.window import Lately
from gasbox.observe import (
    kinetic_energy,
    temperature,
    translational_temperature,
    virial_pressure,
    wall_pressure,
)
from gasbox.theory import mixture

__all__ = ["Figures", "figures"]


@dataclass(frozen=True)
class Figures:
    """One moment in numbers; None where there is none (yet).

    Attributes
    ----------
    time : [time]
    particles : how many there are
    temperature, energy : [energy]
    pressure : measured lately [mass/time²], at the walls, or by the virial where there are none
    pressure_route : how it was measured, ``walls`` or ``virial``
    pressure_ideal, pressure_discs : what theory says, for points and for hard discs (not for molecules)
    collision_rate : pairs that collided per time, lately [1/time]
    potential : of the forces between discs [energy]
    density : discs per area [1/length²]
    """

    time: float
    particles: int
    temperature: float | None
    energy: float
    pressure: float | None
    pressure_route: str
    pressure_ideal: float | None
    pressure_discs: float | None
    collision_rate: float | None
    potential: float
    density: float | None


def figures(sample: Sample, lately: Lately | None) -> Figures:
    """All numbers of one moment."""
    warmth = temperature(sample.state, sample.geometry)
    ideal, discs = _theory(sample, warmth)
    moved = lately is not None and lately.duration > 0
    return Figures(
        time=sample.time,
        particles=sample.state.count,
        temperature=warmth,
        energy=kinetic_energy(sample.state),
        pressure=_pressure(sample, lately, warmth) if lately is not None and moved else None,
        pressure_route="walls" if sample.geometry.is_walled else "virial",
        pressure_ideal=ideal,
        pressure_discs=discs,
        collision_rate=float(lately.change.pair_collisions.sum()) / lately.duration
        if lately and moved
        else None,
        potential=sample.state.potential,
        density=_density(sample),
    )


def _density(sample: Sample) -> float | None:
    area = sample.geometry.at(sample.state.wall_displacement).area
    return sample.state.count / area if area > 0.0 else None


def _counts(sample: Sample) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    return np.bincount(sample.state.species, minlength=len(sample.scenario.kinds))


def _radii(sample: Sample) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.array([kind.half_width for kind in sample.scenario.kinds], dtype=np.float64)


def _pressure(sample: Sample, lately: Lately, warmth: float | None) -> float | None:
    geometry = sample.geometry.at(lately.displacement)
    if geometry.is_walled:
        return wall_pressure(lately.change, geometry, _radii(sample), lately.duration)
    return virial_pressure(
        lately.change,
        geometry,
        _radii(sample),
        _counts(sample),
        temperature=translational_temperature(sample.state, sample.geometry),
        duration=lately.duration,
    )


def _theory(sample: Sample, warmth: float | None) -> tuple[float | None, float | None]:
    if warmth is None:
        return None, None
    gas = mixture.Mixture.of(
        _counts(sample),
        [kind.mass for kind in sample.scenario.kinds],
        _radii(sample),
        sample.geometry.at(sample.state.wall_displacement).area,
    )
    # What is known of hard discs says nothing about molecules.
    discs = None if sample.scenario.molecules else mixture.pressure(gas, warmth)
    return mixture.ideal_pressure(gas, warmth), discs
