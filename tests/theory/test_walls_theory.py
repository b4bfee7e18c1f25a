"""What walls and slits see, against free flights of sampled particles, quadrature and equations of motion."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad, solve_ivp
from scipy.stats import maxwell as maxwell_in_space
from scipy.stats import norm

from gasbox.theory import maxwell, walls

MASS, TEMPERATURE = 2.5, 0.7


def distance(sample, law):
    """Kolmogorov and Smirnov's distance of a sample from a law, in units of 1/sqrt(n)."""
    values = np.sort(sample)
    rank, below = np.arange(1, values.size + 1) / values.size, law(values)
    gap = np.max(np.maximum(np.abs(rank - below), np.abs(rank - 1 / values.size - below)))
    return gap * math.sqrt(values.size)


@pytest.fixture(scope="module")
def crossers():
    """Velocities (n, 2) of the particles of a Maxwell gas that cross a line within a time, and their expected n.

    A strip 0 < x < 8 s is filled evenly; those cross x = 0 within a unit of time that are nearer than they fly.
    """
    rng = np.random.default_rng(3)
    number, spread = 1_000_000, math.sqrt(TEMPERATURE / MASS)
    x = 8 * spread * rng.random(number)
    velocity = rng.normal(scale=spread, size=(number, 2))
    rate = walls.effusion_rate(number, MASS, TEMPERATURE, area=8 * spread, slit=1.0)
    return velocity[x < velocity[:, 0]], rate


@pytest.mark.small
def test_what_crosses_a_line(crossers):
    velocity, rate = crossers
    count = len(velocity)
    assert count > 45_000
    # Poisson: five standard errors, 2.2 %.
    assert count == pytest.approx(rate, abs=5 * math.sqrt(rate))
    speed, angle = np.hypot(*velocity.T), np.arctan2(velocity[:, 1], velocity[:, 0])
    # 1.95 is the 0.1 % level of Kolmogorov and Smirnov.
    assert distance(velocity[:, 0], lambda v: walls.normal_speed_cdf(v, MASS, TEMPERATURE)) < 1.95
    assert distance(velocity[:, 1], lambda v: walls.tangential_velocity_cdf(v, MASS, TEMPERATURE)) < 1.95
    assert distance(speed, lambda v: walls.effusing_speed_cdf(v, MASS, TEMPERATURE)) < 1.95
    assert distance(angle, walls.effusing_angle_cdf) < 1.95
    energy = 0.5 * MASS * speed**2
    for sample, mean in (
        (energy, walls.effusing_energy(TEMPERATURE)),
        (speed, walls.effusing_mean_speed(MASS, TEMPERATURE)),
    ):
        assert sample.mean() == pytest.approx(mean, abs=5 * sample.std() / math.sqrt(count))


@pytest.mark.small
def test_the_laws_inside_are_not_those_at_the_wall(crossers):
    velocity, _ = crossers
    speed = np.hypot(*velocity.T)
    assert distance(speed, lambda v: maxwell.speed_cdf(v, MASS, TEMPERATURE)) > 20
    assert distance(np.arctan2(velocity[:, 1], velocity[:, 0]), lambda a: 0.5 + a / math.pi) > 20


def chord_hits(position, velocity, duration):
    """Hits on a unit circle of points that fly freely and are reflected."""
    speed = np.hypot(*velocity.T)
    direction = velocity / speed[:, None]
    along = np.sum(position * direction, axis=1)
    half = np.sqrt(1.0 - np.sum(position**2, axis=1) + along**2)
    path = speed * duration - (half - along)
    return np.where(path >= 0.0, np.floor(path / (2 * half)) + 1, 0.0)


def rectangle_hits(position, velocity, duration, sides):
    """Hits on the sides of a rectangle: boundaries of its mirror images that the straight path crosses."""
    images = np.floor((position + velocity * duration) / sides) - np.floor(position / sides)
    return np.abs(images).sum(axis=1)


@pytest.mark.small
@pytest.mark.parametrize("shape", ["circle", "rectangle"])
def test_hits_in_any_shape(shape):
    rng, number, duration, sides = np.random.default_rng(8), 100_000, 3.0, np.array([0.5, 4.0])
    velocity = rng.normal(scale=math.sqrt(TEMPERATURE / MASS), size=(number, 2))
    if shape == "circle":
        radius, angle = np.sqrt(rng.random(number)), 2 * math.pi * rng.random(number)
        place = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        hits, perimeter, area = chord_hits(place, velocity, duration), 2 * math.pi, math.pi
    else:
        hits = rectangle_hits(sides * rng.random((number, 2)), velocity, duration, sides)
        perimeter, area = 9.0, 2.0
    expected = walls.wall_hit_rate(number, MASS, TEMPERATURE, perimeter, area) * duration
    assert hits.sum() == pytest.approx(expected, abs=5 * hits.std() * math.sqrt(number))
    assert 5 * hits.std() * math.sqrt(number) < 0.02 * expected


@given(st.floats(0.01, 100.0), st.floats(0.01, 100.0))
def test_speeds_through_a_slit(mass, temperature):
    spread = math.sqrt(temperature / mass)
    law = maxwell_in_space(scale=spread)
    speeds = spread * np.linspace(0.0, 6.0, 40)
    np.testing.assert_allclose(
        walls.effusing_speed_cdf(speeds, mass, temperature), law.cdf(speeds), atol=1e-14
    )
    np.testing.assert_allclose(
        walls.effusing_speed_pdf(speeds, mass, temperature), law.pdf(speeds), rtol=1e-12
    )
    assert walls.effusing_mean_speed(mass, temperature) == pytest.approx(law.mean(), rel=1e-12)
    along = spread * np.linspace(-5.0, 5.0, 30)
    np.testing.assert_allclose(
        walls.tangential_velocity_cdf(along, mass, temperature), norm.cdf(along / spread), atol=1e-15
    )
    energy = quad(
        lambda v: 0.5 * mass * v * v * walls.effusing_speed_pdf(v, mass, temperature), 0, 30 * spread
    )
    assert walls.effusing_energy(temperature) == pytest.approx(energy[0], rel=1e-7)
    # Weighted with how often they come, the speeds inside are those that pass: v f(v)/vbar.
    inside = speeds * maxwell.speed_pdf(speeds, mass, temperature) / maxwell.mean_speed(mass, temperature)
    np.testing.assert_allclose(walls.effusing_speed_pdf(speeds, mass, temperature), inside, rtol=1e-12)


@pytest.mark.small
def test_rates_in_numbers():
    # n vbar/pi with vbar = 1.25331: 100 points of mass 1 at T = 1 in an area of 50, slit of 3, discs of 0.5.
    assert walls.effusion_rate(100, 1.0, 1.0, 50.0, 3.0) == pytest.approx(
        2 * 1.253314 / math.pi * 3, rel=1e-6
    )
    assert walls.effusion_rate(100, 1.0, 1.0, 50.0, 3.0, 0.5) == pytest.approx(
        2 * 1.253314 / math.pi * 2, rel=1e-6
    )
    assert walls.effusion_rate(100, 1.0, 1.0, 50.0, 0.9, 0.5) == walls.effective_slit(0.9, 0.5) == 0.0
    assert walls.graham_ratio(1.0, 4.0) == 2.0
    light, heavy = (walls.effusion_rate(10, mass, 2.0, 9.0, 1.0) for mass in (1.0, 7.0))
    assert light / heavy == pytest.approx(walls.graham_ratio(1.0, 7.0), rel=1e-14)
    assert walls.effusing_energy(2.0) == 3.0
    assert walls.effusing_energy(2.0, freedom=3.0) == 4.0


@pytest.mark.small
def test_two_vessels_become_alike():
    # dN/dt of each by the rates of both, solved numerically; the difference of the densities decays.
    area, other, slit, radius = 40.0, 10.0, 1.5, 0.25

    def flow(_, number):
        out, back = (
            walls.effusion_rate(n, MASS, TEMPERATURE, a, slit, radius)
            for n, a in zip(number, (area, other), strict=True)
        )
        return [back - out, out - back]

    tau = walls.relaxation_time(MASS, TEMPERATURE, area, other, slit, radius)
    end = solve_ivp(flow, (0.0, tau), [300.0, 0.0], rtol=1e-10, atol=1e-9).y[:, -1]
    assert end[0] / area - end[1] / other == pytest.approx(300.0 / area / math.e, rel=1e-8)
    vacuum = walls.decay_time(MASS, TEMPERATURE, area, slit, radius)
    assert vacuum == pytest.approx(300.0 / walls.effusion_rate(300, MASS, TEMPERATURE, area, slit, radius))
    assert vacuum == pytest.approx(walls.relaxation_time(MASS, TEMPERATURE, area, 1e15, slit, radius))
    assert walls.decay_time(MASS, TEMPERATURE, area, 0.4, radius) == math.inf


@pytest.mark.small
@pytest.mark.parametrize("freedom", [2.0, 3.0])
def test_a_leaking_vessel_cools(freedom):
    # One particle after another leaves with (f + 1)/2 T; the rest shares what is left.
    count, start, energy, time, tau = 20_000, 1.3, 0.5 * freedom * 20_000 * 1.3, 0.0, 4.0
    for left in range(count, count // 4, -1):
        temperature = energy / (0.5 * freedom * left)
        time += tau / left / math.sqrt(temperature / start)
        energy -= walls.effusing_energy(temperature, freedom)
    left = count // 4
    assert energy / (0.5 * freedom * left) == pytest.approx(
        walls.cooling_temperature(left, start, count, freedom), rel=3 / left
    )
    assert walls.cooling_count(time, count, tau, freedom) == pytest.approx(left, rel=3 / left)


@pytest.mark.small
def test_ends_and_arrays():
    assert walls.effusing_speed_cdf(-1.0, 1.0, 1.0) == walls.effusing_speed_pdf(-1.0, 1.0, 1.0) == 0.0
    assert walls.effusing_speed_cdf(40.0, 1.0, 1.0) == 1.0
    assert isinstance(walls.effusing_speed_cdf(1.0, 1.0, 1.0), float)
    assert isinstance(walls.tangential_velocity_cdf(1.0, 1.0, 1.0), float)
    assert walls.tangential_velocity_cdf(0.0, 1.0, 1.0) == 0.5
    assert walls.effusing_angle_cdf(-3.0) == 0.0
    assert walls.effusing_angle_cdf(3.0) == 1.0
    assert walls.effusing_angle_cdf(math.pi / 6) == pytest.approx(0.75)
    assert walls.effusing_speed_cdf(np.ones((2, 3)), 1.0, 1.0).shape == (2, 3)
    np.testing.assert_allclose(walls.cooling_temperature(np.array([100.0, 25.0]), 2.0, 100), [2.0, 1.0])
    assert walls.cooling_count(0.0, 100.0, 1.0) == 100.0
