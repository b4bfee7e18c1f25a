import math

import numpy as np
import pytest

from gasbox.app.smoothing import CHOICES, Smoothing

pytestmark = pytest.mark.small


def counts(value: float) -> np.ndarray:
    return np.array([value, 2 * value])


def test_without_smoothing_each_moment_stands_alone() -> None:
    smoothing = Smoothing(0.0)
    assert smoothing.mean(0.0, counts(4.0)).tolist() == [4.0, 8.0]
    assert smoothing.mean(0.1, counts(6.0)).tolist() == [6.0, 12.0]


def test_a_window_forgets_what_is_older() -> None:
    smoothing = Smoothing(1.0)
    values = [smoothing.mean(0.5 * i, counts(float(i)))[0] for i in range(6)]
    assert values == [0.0, 0.5, 1.5, 2.5, 3.5, 4.5]


def test_since_start_is_the_mean_of_all() -> None:
    smoothing = Smoothing(math.inf)
    for i in range(101):
        mean = smoothing.mean(float(i), counts(float(i)))
    assert mean.tolist() == [50.0, 100.0]


def test_another_window_or_another_gas_starts_anew() -> None:
    smoothing = Smoothing(math.inf)
    smoothing.mean(0.0, counts(100.0))
    smoothing.choose(5.0)
    assert smoothing.mean(1.0, counts(2.0)).tolist() == [2.0, 4.0]
    smoothing.forget()
    assert smoothing.mean(2.0, np.array([1.0])).tolist() == [1.0]


def test_choices_have_names() -> None:
    assert 0.0 in CHOICES
    assert math.inf in CHOICES
