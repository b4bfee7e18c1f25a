"""Pair laws made by hand, for tests."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Law:
    """As the scenario's own, with defaults."""

    law: str = "lennard-jones"
    epsilon: float = 1.0
    sigma: float = 1.0
    cutoff: float = 2.5
    truncation: str = "shifted"
    reach: float = 1.5
    screening_length: float = 1.0


FULL = Law(cutoff=float("inf"))
TRUNCATED = Law()
ALL = [
    Law(name, epsilon, sigma, cutoff, truncation)
    for name, cutoff in (
        ("lennard-jones", 2.5),
        ("wca", 2.5),
        ("soft-sphere", 2.5),
        ("square-well", 1.9),
        ("yukawa", 6.0),
        ("none", 2.5),
    )
    for truncation in ("shifted", "force-shifted")
    for epsilon, sigma in ((1.0, 1.0),)
]
