"""Laws of the force between two discs: potential, force and virial as functions of their distance.

All are truncated at a cutoff: shifted by the energy there, or also by the force there. A cutoff of infinity leaves the
law whole.

Sources: M. P. Allen and D. J. Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), chapters 1 and 5,
doi:10.1093/oso/9780198803195.001.0001; J. D. Weeks, D. Chandler and H. C. Andersen, J. Chem. Phys. 54, 5237 (1971),
doi:10.1063/1.1674820, for WCA.
"""

from __future__ import annotations

import math
from typing import Any, Final, Protocol

import numpy as np

from gasbox.theory.real import Real, pick

__all__ = ["PairLaw", "cutoff_of", "force", "lowest", "potential", "virial"]

STEEPNESS: Final = 20.0
"""How steeply the edge of a square well rises, in units of 1/sigma."""
_WCA_CUTOFF: Final = 2.0 ** (1.0 / 6.0)


class PairLaw(Protocol):
    """What a law is made of: `gasbox.scenario.PairLaw` is one."""

    @property
    def law(self) -> str:
        """lennard-jones, wca, soft-sphere, square-well, yukawa or none."""

    @property
    def epsilon(self) -> float:
        """Strength [energy]."""

    @property
    def sigma(self) -> float:
        """Range [length]."""

    @property
    def cutoff(self) -> float:
        """Distance beyond which there is no force [length]."""

    @property
    def truncation(self) -> str:
        """What is zero at the cutoff: the energy (shifted), or the force as well (force-shifted)."""

    @property
    def reach(self) -> float:
        """Width of a square well, in units of sigma."""

    @property
    def screening_length(self) -> float:
        """Of a Yukawa law [length]."""


def potential(law: PairLaw, distance: Real) -> Real:
    """Energy of a pair [energy] at a distance > 0 [length]; zero from the cutoff on."""
    cutoff = cutoff_of(law)
    energy = _whole(law, distance)[0]
    if 0.0 < cutoff < math.inf:
        edge, pull = _whole(law, cutoff)
        energy = energy - edge
        if _shifts_force(law):
            energy = energy + pull * (distance - cutoff)
    shown: Real = pick(np.less(distance, cutoff), energy, 0.0)
    return shown


def force(law: PairLaw, distance: Real) -> Real:
    """Force between a pair, -u'(r) [energy/length], repulsive > 0; zero from the cutoff on."""
    cutoff = cutoff_of(law)
    push = _whole(law, distance)[1]
    if _shifts_force(law) and 0.0 < cutoff < math.inf:
        push = push - _whole(law, cutoff)[1]
    shown: Real = pick(np.less(distance, cutoff), push, 0.0)
    return shown


def virial(law: PairLaw, distance: Real) -> Real:
    """Force times distance, r F(r) [energy]."""
    result: Real = force(law, distance) * distance
    return result


def cutoff_of(law: PairLaw) -> float:
    """Where a law ends [length]: at its cutoff; WCA at the minimum of Lennard-Jones."""
    return _WCA_CUTOFF * law.sigma if law.law == "wca" else law.cutoff


def lowest(law: PairLaw) -> tuple[float, float]:
    """Distance [length] and energy [energy] of the minimum of a law; without one, the cutoff and 0."""
    if law.law not in ("lennard-jones", "square-well") or law.epsilon == 0.0:
        return cutoff_of(law), 0.0
    low, high = 0.8 * law.sigma, 1.6 * law.sigma
    for _ in range(200):
        middle = 0.5 * (low + high)
        # The force pushes below the minimum and pulls above it.
        low, high = (middle, high) if force(law, middle) > 0.0 else (low, middle)
    return low, potential(law, low)


def _shifts_force(law: PairLaw) -> bool:
    return law.truncation == "force-shifted" and law.law != "wca"


def _whole(law: PairLaw, distance: Any) -> tuple[Any, Any]:
    """Energy and force of the law without a cutoff."""
    if law.law == "none":
        return 0.0 * distance, 0.0 * distance
    share = law.sigma / distance
    match law.law:
        case "lennard-jones" | "wca":
            sixth = share**6
            return (
                4.0 * law.epsilon * sixth * (sixth - 1.0),
                24.0 * law.epsilon * sixth * (2.0 * sixth - 1.0) / distance,
            )
        case "soft-sphere":
            return law.epsilon * share**12, 12.0 * law.epsilon * share**12 / distance
        case "square-well":
            return _well(law, distance, share)
        case "yukawa":
            energy = law.epsilon * share * np.exp((law.sigma - distance) / law.screening_length)
            return energy, energy * (1.0 / distance + 1.0 / law.screening_length)
        case unknown:
            raise ValueError(f"there is no pair law {unknown!r}")


def _well(law: PairLaw, distance: Any, share: Any) -> tuple[Any, Any]:
    """A steep core, a flat well, and an edge: epsilon [s^36 - 1/(1 + exp(2 m (r/sigma - reach)))]."""
    # By tanh, which cannot overflow.
    inside = 0.5 - 0.5 * np.tanh(STEEPNESS * (distance / law.sigma - law.reach))
    slope = 2.0 * STEEPNESS / law.sigma * inside * (1.0 - inside)
    core = share**36
    return law.epsilon * (core - inside), law.epsilon * (36.0 * core / distance - slope)
