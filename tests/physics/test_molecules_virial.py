"""The second virial coefficient of hard molecules, from runs at three densities; it is printed with `-s`."""

import numpy as np
import pytest
from rotor_gases import collided, molecules

from gasbox.theory import hard_bodies

pytestmark = pytest.mark.validate

SHAPES = {
    "touching dumbbell": ([0.5, 0.5], [[-0.5, 0], [0.5, 0]]),
    "dumbbell of length 1/2": ([0.5, 0.5], [[-0.25, 0], [0.25, 0]]),
    "bent": ([0.6, 0.4, 0.4], [[0, 0], [0.8, 0.4], [-0.8, 0.4]]),
    "rod of five": ([0.5] * 5, [[k - 2.0, 0] for k in range(5)]),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_second_virial_coefficient(shape):
    # A straight line through (Z - 1)/(B_2 n) at three densities, as B_3 makes it; what lies beyond is of the order of
    # crowding², 0.004 in the middle of the line.
    radius, place = SHAPES[shape]
    second = hard_bodies.second_virial(radius, place, 180)
    crowding, found = np.array([0.03, 0.06, 0.12]), []
    for one in crowding:
        simulation = molecules(radius, place, second, 100, one, seed=11)
        simulation.advance(until=200.0)
        found.append(collided(simulation, 120_000))
    values, errors = np.array(found).T
    (slope, intercept), covariance = np.polyfit(crowding, values, 1, w=1 / errors, cov="unscaled")
    error = float(np.sqrt(covariance[1, 1]))
    print(
        f"{shape}: B_2 {second:.4f}, measured over it {intercept:.3f}({1000 * error:.0f}), B_3/B_2² {slope:.2f}"
    )
    assert intercept == pytest.approx(1.0, abs=3.5 * error + 0.004)
    assert error < 0.01
    # The convex hull would be 0.5 to 4 % larger.
    assert 0.4 < slope < 1.0
