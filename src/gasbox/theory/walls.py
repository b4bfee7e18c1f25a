"""What walls, thermal walls and slits see of a dilute gas.

Faster particles come to a wall more often, so that what crosses a line is not distributed as what is inside:
the component across it as v exp(-m v²/2T), that along it as the Gaussian it is everywhere, and so the speed
as v² exp(-m v²/2T) and the angle as its cosine. A thermal wall sends back just that. Both components
together carry (3/2) T, half as much again as the half T each that particles carry on average inside.

Lengths and areas are those that centres can reach: perimeters and areas shrunk by a radius, slits shortened
by a diameter. Rates hold where the gas is dilute, and for slits where it is also evenly spread: a slit
shorter than the mean free path and than the vessel. Laws take a float or an array first and return the
same; mass and temperature are floats > 0.

Source: M. Knudsen, Ann. Phys. 333, 75 and 999 (1909), doi:10.1002/andp.19093330106 and
doi:10.1002/andp.19093330505; R. K. Pathria and P. D. Beale, Statistical Mechanics, 3rd ed. (Academic Press,
2011), sec. 6.4, with two velocity components in place of three.
"""

from __future__ import annotations

import math

import numpy as np

from gasbox.theory.kinetic import wall_flux
from gasbox.theory.maxwell import mean_speed, speed_cdf
from gasbox.theory.real import Real, pick

__all__ = [
    "cooling_count",
    "cooling_temperature",
    "decay_time",
    "effective_slit",
    "effusing_angle_cdf",
    "effusing_energy",
    "effusing_mean_speed",
    "effusing_speed_cdf",
    "effusing_speed_pdf",
    "effusion_rate",
    "graham_ratio",
    "normal_speed_cdf",
    "relaxation_time",
    "tangential_velocity_cdf",
    "wall_hit_rate",
]


def wall_hit_rate(count: float, mass: float, temperature: float, perimeter: float, area: float) -> float:
    """Hits of all particles on all walls per time, N vbar P/(pi A) [1/time], whatever the shape.

    Parameters
    ----------
    count, mass, temperature : of the gas; of several species each has its own rate
    perimeter, area : that centres can reach [length], [length²]
    """
    return perimeter * wall_flux(count, mass, area, temperature)


def effective_slit(slit: float, radius: float = 0.0) -> float:
    """Length of a slit that a centre can pass, slit - 2R [length]; 0 if the disc is too large."""
    return max(slit - 2.0 * radius, 0.0)


def effusion_rate(
    count: float, mass: float, temperature: float, area: float, slit: float, radius: float = 0.0
) -> float:
    """Particles that pass a slit one way per time, n vbar/pi (slit - 2R) [1/time].

    Parameters
    ----------
    count, mass, temperature, radius : of the species on that side
    area : of the vessel, that centres can reach [length²]
    slit : length of the slit [length]
    """
    return effective_slit(slit, radius) * wall_flux(count, mass, area, temperature)


def graham_ratio(mass: float, other_mass: float) -> float:
    """Effusion rate of a species over that of another, equally dense and hot, sqrt(m'/m)."""
    return math.sqrt(other_mass / mass)


def effusing_energy(temperature: float, freedom: float = 2.0) -> float:
    """Mean energy of a particle that passes a slit or leaves a thermal wall, (f + 1)/2 T [energy].

    (3/2) T for discs without spin; spin, which does not change how often they come, adds its T/2 as it is.

    Parameters
    ----------
    temperature : [energy]
    freedom : f, quadratic degrees of freedom of one particle (2, with rotation 3)
    """
    return 0.5 * (freedom + 1.0) * temperature


def effusing_mean_speed(mass: float, temperature: float) -> float:
    """Mean speed of a particle that passes a slit or leaves a thermal wall, sqrt(8T/(pi m)) [length/time]."""
    return math.sqrt(8.0 * temperature / (math.pi * mass))


def normal_speed_cdf(speed: Real, mass: float, temperature: float) -> Real:
    """Probability that a particle crosses the line with a speed across it below `speed`, 1 - exp(-m v²/2T).

    In two dimensions that is also the law of the whole speed inside the gas.
    """
    return speed_cdf(speed, mass, temperature)


def tangential_velocity_cdf(velocity: Real, mass: float, temperature: float) -> Real:
    """Probability of a velocity along the wall below `velocity` (of either sign): Gaussian, variance T/m."""
    below: Real = 0.5 + 0.5 * _error_function(velocity * math.sqrt(0.5 * mass / temperature))
    return below


def effusing_speed_pdf(speed: Real, mass: float, temperature: float) -> Real:
    """Probability density of the speed across a line, sqrt(2/pi) (m/T)^(3/2) v² exp(-m v²/2T)."""
    x: Real = np.maximum(speed, 0.0) * math.sqrt(mass / temperature)
    density: Real = math.sqrt(2.0 / math.pi * mass / temperature) * x * x * np.exp(-0.5 * x * x)
    return density


def effusing_speed_cdf(speed: Real, mass: float, temperature: float) -> Real:
    """Probability of a speed below `speed` among particles that pass a slit or leave a thermal wall.

    erf(x/sqrt 2) - sqrt(2/pi) x exp(-x²/2), x = v sqrt(m/T): as of all speeds in three dimensions.
    """
    x: Real = np.maximum(speed, 0.0) * math.sqrt(mass / temperature)
    gauss = _error_function(x * math.sqrt(0.5))
    below: Real = gauss - math.sqrt(2.0 / math.pi) * x * np.exp(-0.5 * x * x)
    return below


def effusing_angle_cdf(angle: Real) -> Real:
    """Probability of an angle from the normal below `angle` [radian]: (1 + sin a)/2 from -pi/2 to pi/2."""
    within = np.clip(angle, -0.5 * math.pi, 0.5 * math.pi)
    below: Real = 0.5 + 0.5 * np.sin(within)
    return below


def decay_time(mass: float, temperature: float, area: float, slit: float, radius: float = 0.0) -> float:
    """Time in which a vessel kept at its temperature empties to 1/e into vacuum, pi A/(L vbar) [time].

    Parameters
    ----------
    area, slit, radius : as for `effusion_rate`; infinite if the slit is too narrow
    """
    return relaxation_time(mass, temperature, area, math.inf, slit, radius)


def relaxation_time(
    mass: float, temperature: float, area: float, other_area: float, slit: float, radius: float = 0.0
) -> float:
    """Time in which the density difference of two vessels falls to 1/e, equally hot throughout [time].

    1/tau = (L vbar/pi)(1/A + 1/A'), L = slit - 2R; parameters as for `decay_time`.
    """
    rate = effective_slit(slit, radius) * mean_speed(mass, temperature) / math.pi
    return 1.0 / (rate * (1.0 / area + 1.0 / other_area)) if rate > 0.0 else math.inf


def cooling_temperature(remaining: Real, temperature: float, count: float, freedom: float = 2.0) -> Real:
    """Temperature of what is left in an isolated vessel that leaks into vacuum, T (N/N_0)^(1/f) [energy].

    Each leaver takes (f + 1)/2 T where the others have f/2 T, while collisions keep those Maxwellian.

    Parameters
    ----------
    remaining : N, particles left
    temperature, count : T and N_0 at the start
    freedom : f, as for `effusing_energy`
    """
    left: Real = temperature * (remaining / count) ** (1.0 / freedom)
    return left


def cooling_count(time: Real, count: float, decay: float, freedom: float = 2.0) -> Real:
    """Particles left in an isolated vessel that leaks and cools, N_0 (1 + t/(2 f tau))^(-2f).

    The rate goes as N sqrt(T), T by `cooling_temperature`; at a kept temperature it is N_0 exp(-t/tau).

    Parameters
    ----------
    time : since the slit was opened [time]
    count : N_0
    decay : tau, the `decay_time` at the temperature of the start [time]
    freedom : f, as for `effusing_energy`
    """
    left: Real = count * (1.0 + time / (2.0 * freedom * decay)) ** (-2.0 * freedom)
    return left


def _error_function(x: Real) -> Real:
    """erf, element by element."""
    values: Real = pick(True, np.vectorize(math.erf, otypes=[np.float64])(x), 0.0)
    return values
