"""g(r) and mean squared displacement, of random points and of patterns that can be reckoned."""

import math

import numpy as np
import pytest
from hand_made import gas, hall, moved

from gasbox import observe
from gasbox.geometry import Circle, Rectangle
from gasbox.observe.structure import shell_shares
from gasbox.protocols import Observer
from gasbox.state import Tallies

NOTHING = Tallies.zero(1, 4)
TORUS = Rectangle(12.0, 9.0, True, True)

pytestmark = pytest.mark.small


def at(position, time=0.0, **columns):
    position = np.asarray(position, float)
    return gas(np.zeros_like(position), position=position, time=time, **columns)


def random_places(geometry, rng, count, radius):
    """Anywhere in the geometry where a centre of this radius can be."""
    place = rng.uniform(0.0, 1.0, (20 * count, 2)) * geometry.size
    return place[geometry.holds(place, np.full(len(place), radius))][:count]


@pytest.mark.parametrize(
    "geometry",
    [TORUS, Rectangle(12.0, 9.0, periodic_x=True), Rectangle(12.0, 9.0), hall(Circle(6.0))],
    ids=["periodic", "channel", "box", "circle"],
)
def test_independent_points_have_g_of_one_in_any_box(geometry):
    rng = np.random.default_rng(11)
    found: Observer = observe.RadialDistribution(geometry, 1, 8, 8.0)
    frames, count = 80, 40
    for frame in range(frames):
        state = at(random_places(geometry, rng, count, 1.0), float(frame), radius=np.full(count, 1.0))
        if frame == 0:
            found.start(state, NOTHING)
        found.observe(state, NOTHING)
    result = found.value()
    assert result.frames == frames
    share = shell_shares(geometry, 1.0, 1.0, np.linspace(0.0, 8.0, 9))
    # Unordered pairs, nearly independent: 4.5 errors, plus what is known of the shape of the circle.
    error = 1.0 / np.sqrt(0.5 * frames * count * (count - 1) * share)
    assert np.all(np.abs(result.g[0, 0] - 1.0) < 4.5 * error + 2e-3)
    assert result.whole.tolist() == result.g[0, 0].tolist()


def test_shares_of_pairs_in_a_box_are_known():
    box, edges = Rectangle(12.0, 9.0), np.linspace(0.0, 5.0, 201)
    middle = 0.5 * (edges[1:] + edges[:-1])
    # Isotropised set covariance of a rectangle of 10 x 7: a b - 2 r (a + b)/pi + r²/pi.
    exact = 70.0 - 2.0 * middle * 17.0 / math.pi + middle**2 / math.pi
    share = shell_shares(box, 1.0, 1.0, edges)
    np.testing.assert_allclose(share, math.pi * np.diff(edges**2) * exact / 70.0**2, rtol=1e-4)
    whole = shell_shares(box, 1.0, 0.5, np.linspace(0.0, 15.0, 500))
    assert np.sum(whole) == pytest.approx(1.0, abs=1e-3)
    circle = shell_shares(hall(Circle(6.0)), 1.0, 1.0, np.linspace(0.0, 10.0, 500))
    assert np.sum(circle) == pytest.approx(1.0, abs=5e-3)


def test_a_mixture_has_one_function_for_each_pair():
    state = at([[1.0, 1.0], [2.0, 1.0], [1.0, 4.0]], species=[0, 0, 1])
    found = observe.RadialDistribution(TORUS, 3, 4, 4.0)
    found.start(state, NOTHING)
    g = found.value().g
    # One pair of like discs, at 1.0: in the second bin, of pi (4 - 1) of area 108.
    assert g[0, 0].tolist() == pytest.approx([0.0, 108.0 / (3 * math.pi), 0.0, 0.0])
    # Two unlike ones, at 3 and sqrt(10), in the last bin.
    assert g[0, 1].tolist() == g[1, 0].tolist() == pytest.approx([0.0, 0.0, 0.0, 108.0 / (7 * math.pi)])
    assert np.all(np.isnan(g[1, 1]))
    assert np.all(np.isnan(g[2]))


def test_g_counts_each_moment_once_and_waits():
    found = observe.RadialDistribution(TORUS, 1, 4, 4.0, since=1.0)
    state = at([[1.0, 1.0], [2.0, 1.0]])
    found.start(state, NOTHING)
    assert found.value().frames == 0
    assert np.all(np.isnan(found.value().whole))
    state.time = 1.0
    for _ in range(2):
        found.observe(state, NOTHING)
    assert found.value().frames == 1


def test_displacements_go_round_periodic_edges():
    state = at([[11.5, 1.0], [3.0, 8.5]])
    found: Observer = observe.MeanSquaredDisplacement(TORUS)
    found.start(state, NOTHING)
    for step in range(1, 31):
        place = TORUS.wrap(np.array([[11.5, 1.0], [3.0, 8.5]]) + step * np.array([[1.0, 0.0], [0.0, 2.0]]))
        found.observe(at(place, 0.5 * step), NOTHING)
        found.observe(at(place, 0.5 * step), NOTHING)
    result = found.value()
    assert result.times.tolist() == [0.5 * step for step in range(31)]
    np.testing.assert_allclose(result.msd, [0.5 * (step**2 + 4 * step**2) for step in range(31)])


def test_stretching_the_box_is_no_displacement():
    place = np.array([[3.0, 3.0], [11.9, 0.1]])
    found = observe.MeanSquaredDisplacement(TORUS)
    found.start(at(place), NOTHING)
    found.observe(moved(at(place * [1.1, 1.0], 1.0), 0.0, 1.2, 0.0, 0.0), NOTHING)
    np.testing.assert_allclose(found.value().msd, 0.0, atol=1e-24)


def test_those_that_leave_are_not_followed():
    found = observe.MeanSquaredDisplacement(Rectangle(12.0, 9.0))
    state = at([[1.0, 1.0], [2.0, 2.0]])
    found.start(state, NOTHING)
    rest = at([[1.0, 2.0], [5.0, 2.0]], 1.0)
    rest.keep(np.array([False, True]))
    found.observe(rest, NOTHING)
    assert found.value().msd.tolist() == [0.0, 9.0]


def test_diffusion_of_random_walks():
    rng = np.random.default_rng(3)
    count, frames, step = 4000, 60, 0.3
    found = observe.MeanSquaredDisplacement(TORUS)
    place = rng.uniform(0.0, 9.0, (count, 2))
    found.start(at(place), NOTHING)
    for frame in range(1, frames + 1):
        place = place + rng.normal(0.0, step, (count, 2))
        found.observe(at(TORUS.wrap(place), float(frame)), NOTHING)
    result = found.value()
    # <r²> = 2 step² t = 4 D t. The end of msd alone is known to 1/sqrt(count), the slope of a half to some twice that.
    expected = 0.5 * step**2
    assert observe.diffusion_coefficient(result) == pytest.approx(expected, rel=4 * 2 / math.sqrt(count))
    assert observe.diffusion_coefficient(result, 5.0, 55.0) == pytest.approx(
        expected, rel=4 * 2 / math.sqrt(count)
    )
    assert observe.diffusion_coefficient(result, 58.5) is None
