"""Both pressures from tallies made by hand."""

import math

import numpy as np
import pytest

from gasbox import observe
from gasbox.geometry import Rectangle
from gasbox.state import Tallies

WALLS = Rectangle(10.0, 20.0)
CHANNEL = Rectangle(10.0, 20.0, periodic_x=True)
TORUS = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)

pytestmark = pytest.mark.small


def change(species=1, **sums):
    tallies = Tallies.zero(species, 4)
    for name, value in sums.items():
        getattr(tallies, name)[...] = value
    return tallies


def test_one_wall_hit():
    # One hit of impulse 6 in 2 time units; centres of radius 1 reach 2 (8 + 18) = 52 of wall.
    tallies = change(wall_impulse=[[0.0], [6.0], [0.0], [0.0]])
    assert observe.wall_pressure(tallies, WALLS, np.array([1.0]), 2.0) == pytest.approx(6 / (2 * 52))


def test_species_are_added_with_the_length_that_each_can_reach():
    tallies = change(2, wall_impulse=[[1.0, 0.0], [0.0, 2.0], [3.0, 0.0], [0.0, 4.0]])
    pressure = observe.wall_pressure(tallies, WALLS, np.array([0.0, 2.0]), 1.0)
    assert pressure == pytest.approx(4 / 60 + 6 / (2 * (6 + 16)))


def test_only_walls_that_exist_have_length():
    tallies = change(wall_impulse=[[0.0], [0.0], [5.0], [5.0]])
    assert observe.wall_pressure(tallies, CHANNEL, np.array([1.0]), 1.0) == pytest.approx(10 / 20)
    assert observe.wall_pressure(tallies, TORUS, np.array([1.0]), 1.0) is None
    assert observe.wall_pressure(tallies, WALLS, np.array([1.0]), 0.0) is None


def test_a_species_too_large_for_the_box_contributes_nothing():
    tallies = change(2, wall_impulse=[[1.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 0.0]])
    assert observe.wall_pressure(tallies, WALLS, np.array([0.0, 50.0]), 1.0) == pytest.approx(4 / 60)


def test_a_bouncing_particle_has_the_pressure_of_the_ideal_gas():
    # One point of mass 2 with velocity (3, 4) hits each side wall 3/20 times per time with impulse 12, and bottom and
    # top 4/40 times with 16. Weighted by length the mean is P_x 2/3 + P_y 1/3.
    duration = 1000.0
    push = np.array([[3 / 20 * 12], [3 / 20 * 12], [4 / 40 * 16], [4 / 40 * 16]]) * duration
    pressure = observe.wall_pressure(change(wall_impulse=push), WALLS, np.array([0.0]), duration)
    assert pressure == pytest.approx((2 * 3**2 * 2 + 2 * 4**2) / 3 / 200)


def test_error_of_the_wall_pressure():
    tallies = change(2, wall_impulse=[[60.0, 44.0], [0, 0], [0, 0], [0, 0]])
    tallies.wall_collisions[0] = [100, 25]
    error = observe.wall_pressure_error(tallies, WALLS, np.array([0.0, 2.0]), 1.0)
    assert error == pytest.approx(math.sqrt(4 / math.pi * (1.0 / 100 + 1.0 / 25)))
    assert observe.wall_pressure_error(change(), WALLS, np.array([1.0]), 1.0) is None
    assert observe.wall_pressure_error(change(), TORUS, np.array([1.0]), 1.0) is None


def test_error_of_the_wall_pressure_is_the_scatter_of_independent_hits():
    # Hits of a dilute gas: Poisson in number, v_n with density v exp(-v²/2). 4000 runs know the scatter to 1.1 %.
    rng = np.random.default_rng(3)
    hits = rng.poisson(400, size=4000)
    sums = np.array([np.sum(2 * np.sqrt(-2 * np.log1p(-rng.random(n)))) for n in hits])
    tallies = change(wall_impulse=[[sums.mean()], [0], [0], [0]])
    tallies.wall_collisions[0, 0] = 400
    expected = observe.wall_pressure_error(tallies, WALLS, np.array([0.0]), 1.0) * 60
    assert sums.std() == pytest.approx(expected, rel=3 * 0.011)


def test_virial_pressure():
    tallies = change(pair_virial=[36.0])
    counts, radii = np.array([4]), np.array([1.0])
    # (N T + 36/(2 * 3))/A
    assert observe.virial_pressure(tallies, TORUS, radii, counts, temperature=2.0, duration=3.0) == 14 / 200
    walled = observe.virial_pressure(tallies, WALLS, radii, counts, temperature=2.0, duration=3.0)
    assert walled == pytest.approx(14 / (8 * 18))
    channel = observe.virial_pressure(tallies, CHANNEL, radii, counts, temperature=2.0, duration=3.0)
    assert channel == pytest.approx(14 / (10 * 18))
    assert observe.virial_pressure(tallies, TORUS, radii, counts, temperature=2.0, duration=0.0) is None
    assert observe.virial_pressure(tallies, TORUS, radii, counts, temperature=None, duration=1.0) is None


@pytest.mark.parametrize("eta", [0.05, 0.10, 0.15])
def test_two_discs_in_a_periodic_box(eta):
    # Exact mechanics: the relative motion is a Sinai billiard. With relative speed g, collisions come at the rate
    # 2 sigma g/(L² - pi sigma²), and the mean of |impulse| = mu g 2 cos is mu g pi/2. Exact thermodynamics:
    # Z = (1/2) [1 + 1/(1 - 2 eta)], from the free area of two discs.
    area, g, duration = 200.0, 1.7, 5.0
    sigma = math.sqrt(4 * eta * area / (2 * math.pi))
    rate = 2 * sigma * g / (area - math.pi * sigma**2)
    tallies = change(pair_virial=[rate * duration * sigma * 0.5 * g * math.pi / 2])
    kinetic = 0.5 * 0.5 * g**2
    temperature = 2 * kinetic / observe.degrees_of_freedom(2, TORUS)
    pressure = observe.virial_pressure(
        tallies, TORUS, np.array([sigma / 2]), np.array([2]), temperature=temperature, duration=duration
    )
    exact = 0.5 * (1 + 1 / (1 - 2 * eta))
    assert exact == pytest.approx({0.05: 1.05556, 0.10: 1.125, 0.15: 1.21429}[eta], abs=5e-6)
    assert pressure * area / (2 * temperature) == pytest.approx(exact, rel=1e-12)


def test_error_of_the_virial_pressure():
    tallies = change(pair_virial=[40.0])
    tallies.pair_collisions[0, 0] = 100
    error = observe.virial_pressure_error(tallies, TORUS, np.array([1.0]), np.array([4]), duration=2.0)
    assert error == pytest.approx(40 / 4 / 200 / 10)
    assert (
        observe.virial_pressure_error(change(), TORUS, np.array([1.0]), np.array([4]), duration=2.0) is None
    )


def test_common_area_makes_both_routes_agree_on_the_ideal_gas():
    radii, counts = np.array([1.0, 3.0, 99.0]), np.array([300, 100, 0])
    area = observe.common_accessible_area(WALLS, radii, counts)
    partial = 300 / (8 * 18) + 100 / (4 * 14)
    assert 400 / area == pytest.approx(partial)
    assert observe.common_accessible_area(WALLS, radii[:1], counts[:1]) == pytest.approx(8 * 18)
    assert observe.common_accessible_area(TORUS, radii, counts) == pytest.approx(200.0)
    assert observe.common_accessible_area(WALLS, radii, np.array([1, 1, 1])) is None
    assert observe.common_accessible_area(WALLS, radii, np.array([0, 0, 0])) is None


def test_forces_are_measured_by_means_over_time():
    torus = Rectangle(10.0, 20.0, True, True)
    sums = change(pair_virial=6.0, kinetic_time=36.0, area_time=4.0 * 210.0, measured_time=4.0)
    counts = np.array([10])
    # K = 9 on average, so T = 2·9/18 = 1, whatever it is now; 6/(2·4) of the virial, over the mean area.
    found = observe.virial_pressure(sums, torus, np.ones(1), counts, temperature=3.0, duration=4.2)
    assert found == pytest.approx((10 * 1.0 + 6.0 / 8.0) / 210.0)
    # Between walls nothing changes the area: centres reach 8 x 18, and T = 2·9/20.
    walled = observe.virial_pressure(
        sums, Rectangle(10.0, 20.0), np.ones(1), counts, temperature=3.0, duration=4.2
    )
    assert walled == pytest.approx((10 * 0.9 + 6.0 / 8.0) / (8.0 * 18.0))
