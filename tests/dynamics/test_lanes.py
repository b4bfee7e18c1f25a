"""Lanes: eight numbers at a time, compiled and as NumPy arrays, do what single numbers do."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest

from gasbox.jit import is_compiling
from gasbox.kernels.lanes import (
    WIDTH,
    bits,
    choose,
    exponential,
    load,
    lowest,
    root,
    spread,
    store,
    take,
    total,
)

pytestmark = pytest.mark.small
compiled = numba.njit(error_model="numpy") if is_compiling() else lambda function: function


@compiled
def arithmetic(a, b, number, out):
    """A row of `out` for each operator."""
    x, y = load(a, 1), load(b, 3)
    store(out[0], 0, x + y)
    store(out[1], 0, x - y)
    store(out[2], 0, x * y)
    store(out[3], 0, x / y)
    store(out[4], 0, number + x)
    store(out[5], 0, x - number)
    store(out[6], 0, number / x)
    store(out[7], 0, x * 2)
    store(out[8], 0, root(x))
    store(out[9], 0, exponential(y))
    store(out[10], 0, choose(x < y, x, y))
    store(out[11], 0, choose((x > y) & (x > 2.0), x, spread(number)))


@compiled
def masks(a, b):
    x, y = load(a, 0), load(b, 0)
    return bits(x < y), bits(x > y), bits((x < y) & (y < 3.0))


@compiled
def gathered(table, kinds, place, out):
    store(out, 2, take(table, kinds, place))


@compiled
def summed(a):
    return total(load(a, 0))


@compiled
def first_of(number):
    return lowest(number)


def numbers(seed, size=16):
    return np.random.default_rng(seed).uniform(0.5, 4.0, size)


def test_arithmetic_is_that_of_single_numbers():
    a, b, out = numbers(1), numbers(2), np.zeros((12, WIDTH))
    arithmetic(a, b, 1.75, out)
    x, y = a[1:9], b[3:11]
    expected = [x + y, x - y, x * y, x / y, 1.75 + x, x - 1.75, 1.75 / x, 2 * x, np.sqrt(x)]
    for row, values in enumerate(expected):
        assert np.array_equal(out[row], values)
    assert out[9] == pytest.approx(np.exp(y), rel=1e-15 * 4)
    assert np.array_equal(out[10], np.minimum(x, y))
    assert np.array_equal(out[11], np.where((x > y) & (x > 2.0), x, 1.75))


def test_truth_values_as_bits():
    a, b = numbers(3), numbers(4)
    b[2] = a[2]
    b[5] = math.nan
    less, more, both = masks(a, b)
    for lane in range(WIDTH):
        assert less >> lane & 1 == (a[lane] < b[lane])
        assert more >> lane & 1 == (a[lane] > b[lane])
        assert both >> lane & 1 == (a[lane] < b[lane] < 3.0)
    assert 0 < less < 1 << WIDTH


@pytest.mark.parametrize("integer", [np.int32, np.int64])
def test_take(integer):
    table, out = numbers(5, 4), np.zeros(12)
    kinds = np.array([3, 0, 1, 2, 2, 1, 0, 3, 1, 1, 0, 2], integer)
    gathered(table, kinds, 3, out)
    assert np.array_equal(out[2:10], table[kinds[3:11]])
    assert not out[:2].any()
    assert not out[10:].any()


def test_the_order_of_a_sum():
    """Halves folded on each other: the same bits with and without the JIT, on any processor."""
    for seed in range(20):
        a = np.random.default_rng(seed).normal(size=WIDTH) * 10.0 ** np.arange(WIDTH)
        fold = a[:4] + a[4:]
        fold = fold[:2] + fold[2:]
        assert summed(a) == fold[0] + fold[1]


def test_the_lowest_bit():
    for number in (1, 2, 12, 0x80, 0x100, 0xA0):
        assert first_of(number) == (number & -number).bit_length() - 1
