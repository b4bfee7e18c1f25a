import pytest

from gasbox.app.ceiling import Ceiling, interval

pytestmark = pytest.mark.small


def test_it_grows_at_once_and_covers_what_it_is_shown() -> None:
    ceiling = Ceiling()
    assert ceiling.cover(0.0, 70.0) == 80.0
    assert ceiling.cover(0.1, 130.0) >= 130.0


def test_noise_does_not_move_it() -> None:
    ceiling = Ceiling()
    ends = [ceiling.cover(0.25 * i, 70.0 + (i * 7919) % 13 - 6) for i in range(400)]
    assert len(set(ends[20:])) == 1


def test_it_comes_down_only_when_it_was_long_too_high() -> None:
    ceiling = Ceiling()
    high = ceiling.cover(0.0, 1000.0)
    assert ceiling.cover(3.0, 80.0) == high
    assert ceiling.cover(10.0, 80.0) == 100.0


@pytest.mark.parametrize(
    "highest", [0.0, 1.0, 1.9, 2.3, 3.0, 7.0, 9.9, 11.0, 14.0, 24.0, 55.0, 99.0, 12345.0]
)
def test_marks_divide_the_axis_into_a_few_whole_parts(highest: float) -> None:
    end = Ceiling().cover(0.0, highest)
    parts = end / interval(end)
    assert parts == pytest.approx(round(parts))
    assert 2 <= parts <= 5
    assert interval(end) >= 1.0
