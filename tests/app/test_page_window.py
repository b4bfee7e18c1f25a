import numpy as np
import pytest

from gasbox.app.window import SlidingWindow
from gasbox.state import Tallies

pytestmark = pytest.mark.small


def tallies(collisions: int) -> Tallies:
    zero = Tallies.zero(1, 4)
    zero.pair_collisions[0, 0] = collisions
    return zero


def test_nothing_is_known_before_something_has_happened() -> None:
    window = SlidingWindow(10.0)
    assert window.take(0.0, 1, 5.0, tallies(7)) is None
    assert window.take(0.2, 1, 5.0, tallies(7)) is None


def test_it_gives_what_was_added_lately() -> None:
    window = SlidingWindow(1.0)
    for i in range(50):
        lately = window.take(0.25 * i, 1, 10.0 * i, tallies(3 * i))
    assert lately is not None
    assert lately.change.pair_collisions[0, 0] / lately.duration == pytest.approx(0.3)
    assert lately.duration == pytest.approx(40.0)


def test_a_pause_forgets_nothing() -> None:
    window = SlidingWindow(1.0)
    for i in range(5):
        before = window.take(0.25 * i, 1, 10.0 * i, tallies(i))
    for i in range(100):
        after = window.take(1.0 + 0.25 * i, 1, 40.0, tallies(4))
    assert before is not None
    assert after is not None
    assert after.duration == before.duration


def test_another_gas_starts_anew() -> None:
    window = SlidingWindow()
    window.take(0.0, 1, 0.0, tallies(0))
    assert window.take(0.25, 1, 1.0, tallies(5)) is not None
    assert window.take(0.5, 2, 0.0, tallies(0)) is None
    lately = window.take(0.75, 2, 2.0, tallies(8))
    assert lately is not None
    assert np.array_equal(lately.change.pair_collisions, [[8]])


def test_another_gas_that_is_older_starts_anew_too() -> None:
    window = SlidingWindow()
    window.take(0.0, 1, 0.0, tallies(0))
    assert window.take(0.25, 2, 500.0, tallies(9)) is None
