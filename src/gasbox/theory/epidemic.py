"""Epidemics in a well-mixed crowd, after Kermack and McKendrick.

Source: W. O. Kermack, A. G. McKendrick, Proc. R. Soc. A 115, 700 (1927), doi:10.1098/rspa.1927.0118; H. Andersson,
T. Britton, Stochastic Epidemic Models and Their Statistical Analysis, Springer (2000), doi:10.1007/978-1-4612-1158-7.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Curve",
    "contact_reproduction",
    "epidemic_curve",
    "epidemic_growth",
    "extinction_probability",
    "final_size",
    "final_size_deviation",
    "final_size_mean",
    "herd_threshold",
    "peak_infected",
    "share_within",
    "well_mixed_reproduction",
]

Law = Literal["fixed", "exponential", "gamma"]
_HALVINGS: Final = 100
_OF_FIXED: Final = 60
"""Stages in a row that stand for a fixed time."""


def well_mixed_reproduction(rate: float, density: float, radius: float, duration: float) -> float:
    """R0 = rate n pi r² duration: who is in the circle of an infectious person changes, but not how many.

    Parameters
    ----------
    rate : of infection of each person within the radius [1/time]
    density : people per area [1/length²]
    radius : [length]
    duration : mean infectious time, in the unit of time of the rate
    """
    return rate * density * math.pi * radius**2 * duration


def share_within(radius: float, width: float, height: float) -> float:
    """Part of the others who are within a radius, between walls: who stands at a wall has fewer nearby.

    The probability that two points, placed evenly in a rectangle, are not farther apart. R0 of n people who mix between
    walls is (n - 1) times this times rate times duration.

    Parameters
    ----------
    radius : [length], not above the shorter side
    width, height : [length]
    """
    if radius > min(width, height):
        raise ValueError(
            f"the radius is {radius:g}; it must not be above the shorter side, {min(width, height):g}"
        )
    area = width * height
    # Of all vectors up to the radius, the mean of (width - |x|)(height - |y|).
    return (math.pi * radius**2 * area - 4.0 / 3.0 * radius**3 * (width + height) + 0.5 * radius**4) / area**2


def contact_reproduction(probability: float, collisions: float, duration: float) -> float:
    """R0 where each collision infects with a probability: p omega duration, with omega collisions a time [1/time]."""
    return probability * collisions * duration


def herd_threshold(r0: float) -> float:
    """Part of the people who must be immune so that no epidemic grows: 1 - 1/R0, or none."""
    return max(1.0 - 1.0 / r0, 0.0)


def final_size(r0: float, susceptible: float = 1.0, seeds: float = 0.0) -> float:
    """Part of the people who are infected in the end, seeds not counted: z = s (1 - exp(-R0 (z + seeds))).

    It does not depend on the law of the infectious time. Without seeds, that of a major outbreak.

    Parameters
    ----------
    susceptible : part of the people who can be infected at the start, s
    seeds : part of the people who are infectious at the start
    """

    def excess(z: float) -> float:
        return susceptible * -math.expm1(-r0 * (z + seeds)) - z

    if seeds == 0.0 and r0 * susceptible <= 1.0:
        return 0.0
    # From a little above zero, which without seeds is a solution too, up to all.
    return _root(excess, 1e-12, susceptible)


def _root(falls: Callable[[float], float], low: float, high: float) -> float:
    """Where a function that is first positive, then negative, is zero."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if falls(middle) > 0.0 else (low, middle)
    return 0.5 * (low + high)


def peak_infected(r0: float, susceptible: float = 1.0) -> float:
    """Greatest part of the people infected at a time, without an exposed stage, exponential times: 1 - (1 + ln R0)/R0.

    With a part s susceptible and the rest immune, s - (1 + ln(s R0))/R0.
    """
    if r0 * susceptible <= 1.0:
        return 0.0
    return susceptible - (1.0 + math.log(r0 * susceptible)) / r0


def final_size_deviation(r0: float, people: int, variation: float = 1.0) -> float:
    """Standard deviation of the final size (a part) in a major outbreak.

    Parameters
    ----------
    people : how many there are
    variation : standard deviation of the infectious time over its mean: 1 exponential, 0 fixed
    """
    z = final_size(r0)
    spread = z * (1.0 - z) * (1.0 + (variation * r0) ** 2 * (1.0 - z))
    return math.sqrt(spread / people) / (1.0 - (1.0 - z) * r0)


def final_size_mean(r0: float, people: int, law: Law, seeds: int = 1, shape: float = 1.0) -> float:
    """Mean part of the people who are infected in a major outbreak, seeds not counted, to the order 1/people.

    After k infections with the infectious times D (over their mean), each of those who are left has escaped with the
    probability exp(-R0/people sum D). So those who are left, over E exp(-R0 D/people) to the power of all who were
    infectious, are a martingale: its mean in the end is `people`, as at the start. The logarithm, to the second order
    about the final size of the largest crowds, gives the mean; what small outbreaks take of it is left to large ones.

    Source: F. Ball, Adv. Appl. Probab. 18, 289 (1986), doi:10.2307/1427301, for the martingale.

    Parameters
    ----------
    r0 : people infected by each in a large crowd, above 1; each of `people` by R0/people
    people : susceptible people at the start, many
    law : of the infectious time; `shape` of a gamma distribution
    seeds : infectious people at the start besides, few
    """
    z, squared = final_size(r0), {"fixed": 0.0, "exponential": 1.0, "gamma": 1.0 / shape}[law]
    q = extinction_probability(r0, law, 1, shape)
    # Of small outbreaks: each infects so many on the average who infect no endless chain.
    k = 1.0 if law == "exponential" else shape
    few = r0 * (q if law == "fixed" else (1.0 + r0 * (1.0 - q) / k) ** (-k - 1.0))
    small = q**seeds / (1.0 - q**seeds) * seeds * ((r0 - 1.0) * few / (1.0 - few) + r0)
    slope = 1.0 - r0 * (1.0 - z)
    spread = (slope**2 - 1.0) * (final_size_deviation(r0, people, math.sqrt(squared)) / (1.0 - z)) ** 2 / 2.0
    return z + (1.0 - z) / slope * (spread + (r0 * seeds - r0**2 * squared * z / 2.0 + small) / people)


def extinction_probability(r0: float, law: Law, seeds: int = 1, shape: float = 1.0) -> float:
    """Probability that an outbreak stays small: q = E exp(-R0 (1 - q) D) for one seed, D the time over its mean.

    Parameters
    ----------
    law : of the infectious time; `shape` of a gamma distribution
    seeds : infectious people at the start
    """
    if r0 <= 1.0:
        return 1.0
    one = _root(lambda q: _laplace(r0 * (1.0 - q), law, shape) - q, 0.0, 1.0 - 1e-9)
    return one**seeds


def epidemic_growth(
    r0: float,
    duration: float,
    law: Law,
    shape: float = 1.0,
    exposed: tuple[float, Law, float] | None = None,
) -> float:
    """Rate at which the number of infected people grows at first [1/time]: Euler and Lotka's equation.

    Parameters
    ----------
    duration : mean infectious time [time]
    law, shape : of the infectious time
    exposed : mean [time], law and shape of the time before it; None without
    """
    if r0 <= 1.0:
        raise ValueError(f"R0 is {r0:g}; nothing grows unless it is above 1")

    def excess(rate: float) -> float:
        later = 1.0 if exposed is None else _laplace(rate * exposed[0], exposed[1], exposed[2])
        scaled = rate * duration
        return later * r0 * (1.0 - _laplace(scaled, law, shape)) / scaled - 1.0

    return _root(excess, 1e-12 / duration, 2.0 * r0 / duration)


def _laplace(s: float, law: Law, shape: float) -> float:
    """Mean of exp(-s D), D a time of mean 1."""
    if law == "fixed":
        return math.exp(-s)
    k = 1.0 if law == "exponential" else shape
    return float((1.0 + s / k) ** -k)


@dataclass(frozen=True)
class Curve:
    """An epidemic in time: (k,) float64 each, parts of the people; `time` in the unit of the durations."""

    time: NDArray[np.float64]
    susceptible: NDArray[np.float64]
    exposed: NDArray[np.float64]
    infectious: NDArray[np.float64]
    recovered: NDArray[np.float64]


def epidemic_curve(
    r0: float,
    duration: float,
    until: float,
    *,
    seeds: float = 0.001,
    law: Law = "exponential",
    exposed: float = 0.0,
    steps: int = 2000,
) -> Curve:
    """SIR or SEIR: Runge and Kutta's fourth order; a fixed time stands as many exponential stages in a row.

    Parameters
    ----------
    duration : mean infectious time [time]
    until : [time]
    seeds : part of the people who are infectious at the start
    law : of both times; "gamma" is not known here
    exposed : mean time before that [time]; 0 without
    steps : of equal length, at least; more where the stages are short
    """
    stages = 1 if law == "exponential" else _OF_FIXED
    waits = stages if exposed > 0.0 else 0
    leave_e, leave_i, beta = waits / (exposed or 1.0), stages / duration, r0 / duration

    steps = max(steps, math.ceil(until * max(leave_e, leave_i)))

    def slope(y: NDArray[np.float64]) -> NDArray[np.float64]:
        e, i = y[1 : 1 + waits], y[1 + waits : -1]
        new = beta * y[0] * i.sum()
        first = leave_e * e[-1] if waits else new
        return np.concatenate(
            [
                [-new],
                _through(e, leave_e, new),
                _through(i, leave_i, first),
                [leave_i * i[-1]],
            ]
        )

    y = np.zeros(2 + waits + stages)
    y[0], y[1 + waits] = 1.0 - seeds, seeds
    rows, step = [y], until / steps
    for _ in range(steps):
        k1 = slope(y)
        k2 = slope(y + 0.5 * step * k1)
        k3 = slope(y + 0.5 * step * k2)
        k4 = slope(y + step * k3)
        y = y + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        rows.append(y)
    table = np.array(rows)
    return Curve(
        np.linspace(0.0, until, steps + 1),
        table[:, 0],
        table[:, 1 : 1 + waits].sum(axis=1),
        table[:, 1 + waits : -1].sum(axis=1),
        table[:, -1],
    )


def _through(stages: NDArray[np.float64], leave: float, enter: float) -> NDArray[np.float64]:
    """Change of stages in a row that one passes at a rate."""
    return np.diff(leave * stages, prepend=enter) * -1.0 if stages.size else stages
