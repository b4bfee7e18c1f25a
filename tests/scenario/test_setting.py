"""Which values a setting of a world may have."""

import math

import pytest

from gasbox.scenario import Setting


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan, "high", True])
@pytest.mark.parametrize("setting", [Setting("any number"), Setting("some", 0.0, 5.0)])
def test_a_number_is_finite_and_in_its_range(setting, value):
    with pytest.raises(ValueError, match="number"):
        setting.check(value)
    assert setting.check(3) == 3


def test_words_and_switches():
    assert Setting("who", words=("human", "hard")).check("hard") == "hard"
    with pytest.raises(ValueError, match="one of human, hard"):
        Setting("who", words=("human", "hard")).check("soft")
    assert Setting("whether", is_switch=True).check(False) is False
    with pytest.raises(ValueError, match="true or false"):
        Setting("whether", is_switch=True).check(0)


def test_ends_of_a_range_belong_to_it():
    assert [Setting("some", 0.0, 5.0).check(value) for value in (0, 5)] == [0, 5]
    with pytest.raises(ValueError, match="from 0 to 5"):
        Setting("some", 0.0, 5.0).check(5.001)
