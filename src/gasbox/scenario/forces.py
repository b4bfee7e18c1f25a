"""Forces between discs: the law of each pair of species, and charges."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from gasbox.scenario.values import NotNegative, Positive, Section

__all__ = ["Charges", "Forces", "LawName", "PairForces", "Truncation"]

LawName = Literal["lennard-jones", "wca", "soft-sphere", "square-well", "yukawa", "none"]
Truncation = Literal["shifted", "force-shifted"]
_Name = Annotated[str, Field(min_length=1, max_length=60)]


class PairForces(Section):
    """What is different for one pair of species; what is not said is as for all."""

    between: tuple[_Name, _Name]
    """Names of the two species; twice the same one for pairs within it."""
    law: LawName | None = None
    """Law of the force."""
    epsilon: NotNegative | None = None
    """Strength [energy]; without it, the geometric mean of the two species'."""
    sigma: Positive | None = None
    """Range [length]; without it, the arithmetic mean of the two species'."""
    cutoff: Positive | None = None
    """Distance, in units of sigma, beyond which there is no force."""
    truncation: Truncation | None = None
    """What is taken off at the cutoff: the energy there, or also the force."""
    reach: Positive | None = None
    """Width of a square well, in units of sigma."""
    screening_length: Positive | None = None
    """Decay length of a Yukawa force [length]."""


class Charges(Section):
    """A screened force between charges: energy strength q1 q2 exp(-r/screening_length)/r, force-shifted."""

    strength: Positive = 1.0
    """Energy of two unit charges at distance 1, without the screening [energy·length]."""
    screening_length: Positive = 1.0
    """Decay length [length]."""
    cutoff: Positive = 5.0
    """Distance beyond which there is no force [length]."""


class Forces(Section):
    """Forces between discs. Without this section, `forced` means Lennard-Jones with the values given here."""

    law: LawName = "lennard-jones"
    """Law of the force: lennard-jones; wca, its repulsive part; soft-sphere; square-well, smooth; yukawa; none."""
    cutoff: Positive | None = None
    """Distance, in units of the pair's sigma, beyond which there is no force; without it, 2.5 (lennard-jones,
    soft-sphere), 1.9 (square-well) or 6 (yukawa)."""
    truncation: Truncation = "shifted"
    """What is taken off at the cutoff: `shifted`, the energy there; `force-shifted`, also the force there."""
    reach: Positive | None = None
    """Width of a square well, in units of sigma; without it, 1.5."""
    screening_length: Positive | None = None
    """Decay length of a Yukawa force [length]; without it, the pair's sigma."""
    walls: Literal["reflecting", "repulsive"] = "reflecting"
    """Walls turn discs round one radius before them, or push them away smoothly."""
    pairs: Annotated[tuple[PairForces, ...], Field(max_length=10_000)] = ()
    """What is different for single pairs of species."""
    charges: Charges | None = None
    """Forces between the charges of the species; without it, charges do not act."""
