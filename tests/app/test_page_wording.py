import math

import pytest

from gasbox.app.wording import number, times, whole

pytestmark = pytest.mark.small


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (0.02, 3, "0.0200"),
        (0.99999, 3, "1.00"),
        (-1.5, 3, "\u22121.50"),
        (971.83, 4, "971.8"),
        (12345.6, 3, "12\u2009346"),
        (1.234e7, 3, "1.23×10⁷"),
        (9.999e-6, 3, "1.00×10⁻⁵"),
        (0.0, 3, "0"),
        (None, 3, "–"),
        (math.nan, 3, "–"),
        (math.inf, 3, "–"),
    ],
)
def test_number(value: float | None, digits: int, text: str) -> None:
    assert number(value, digits) == text


def test_the_width_of_a_readout_does_not_jump() -> None:
    assert {len(number(value)) for value in (0.1, 0.123456, 0.5, 0.99)} == {5}


def test_whole_and_times() -> None:
    assert whole(1234567) == "1\u2009234\u2009567"
    assert [times(speed) for speed in (0.1, 1.0, 12.345, 100.0)] == ["0.1×", "1×", "12.3×", "100×"]
