"""Where the computer expects the ball, against a flight in small steps."""

import numpy as np
import pytest

from gasbox.worlds.pong.player import arrival

pytestmark = pytest.mark.small


def flown(place, velocity, x, room, gravity, steps=20_000):
    (px, y), (vx, v), (low, high) = place, velocity, room
    dt = (x - px) / vx / steps
    for _ in range(steps):
        y += v * dt + 0.5 * gravity * dt * dt
        v += gravity * dt
        if y < low:
            y, v = 2 * low - y, -v
        elif y > high:
            y, v = 2 * high - y, -v
    return y


@pytest.mark.parametrize("gravity", [0.0, -40.0, 25.0])
@pytest.mark.parametrize("seed", range(4))
def test_arrival(gravity, seed):
    rng = np.random.default_rng(seed)
    place, velocity = (float(rng.uniform(20, 140)), float(rng.uniform(5, 95))), rng.normal(0, 90, 2).tolist()
    x = 11.0 if velocity[0] < 0 else 149.0
    time, height = arrival(place, velocity, x, (3.0, 97.0), gravity)
    assert time == pytest.approx((x - place[0]) / velocity[0])
    assert height == pytest.approx(flown(place, velocity, x, (3.0, 97.0), gravity), abs=0.3)


def test_a_ball_that_flies_away_does_not_arrive():
    assert arrival((50.0, 50.0), (10.0, 0.0), 11.0, (3.0, 97.0)) is None
    assert arrival((50.0, 50.0), (0.0, 5.0), 11.0, (3.0, 97.0)) is None
