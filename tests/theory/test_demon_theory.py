"""The books of a demon: entropy of parts, information of a record, the heat of forgetting."""

import math
from itertools import product

import numpy as np
import pytest

from gasbox.theory import demon

pytestmark = pytest.mark.small


def entropy(count, area, temperature):
    return demon.entropy_of_parts(np.array(count), np.array(area, float), np.array(temperature, float))


def test_a_gas_that_moves_to_one_side_loses_ln_2_a_disc():
    even = entropy([[50, 50]], [[30, 30]], [1, 1])
    assert even - entropy([[0, 100]], [[30, 30]], [0, 1]) == pytest.approx(100 * math.log(2))


def test_a_mixture_that_is_sorted_loses_its_entropy_of_mixing():
    mixed = entropy([[20, 20], [30, 30]], [[10, 10], [10, 10]], [2, 2])
    assert mixed - entropy([[40, 0], [0, 60]], [[10, 10], [10, 10]], [2, 2]) == pytest.approx(
        100 * math.log(2)
    )


def test_heat_that_flows_gives_its_entropy_at_each_temperature():
    # dS = dQ (1/T_right - 1/T_left) with E = N T.
    flow = 1e-4
    before, after = (
        entropy([[100, 100]], [[30, 30]], [2.0 - q / 100, 1.0 + q / 100]) for q in (-flow / 2, flow / 2)
    )
    assert (after - before) / flow == pytest.approx(1.0 - 0.5, rel=1e-6)


def test_balance_has_the_greatest_entropy():
    area = [[30, 30]]
    most = entropy([[50, 50]], area, [1, 1])
    for moved, heated in product((-3, 0, 4), (-0.1, 0.0, 0.2)):
        left, right = 50 - moved, 50 + moved
        warm = (100 - left * (1 + heated)) / right
        assert entropy([[left, right]], area, [1 + heated, warm]) <= most


def test_the_information_of_a_record_is_that_of_all_records_like_it():
    for decisions, let in [(0, 0), (1, 0), (7, 7), (40, 11), (1000, 300)]:
        records = math.lgamma(decisions + 1) - math.lgamma(let + 1) - math.lgamma(decisions - let + 1)
        found = demon.record_information(decisions, let)
        # n H(k/n) is the logarithm of the number of records by Stirling: never less, by half a logarithm at most.
        assert records - 1e-12 <= found <= records + 0.5 * math.log(math.pi / 2 * max(decisions, 1)) + 1e-12
        assert found <= decisions * demon.BIT + 1e-12
    assert demon.record_information(64, 32) == pytest.approx(64 * math.log(2))


def test_no_decision_makes_a_record_shorter():
    for decisions in range(30):
        for let in range(decisions + 1):
            now = demon.record_information(decisions, let)
            assert demon.record_information(decisions + 1, let) >= now - 1e-12
            assert demon.record_information(decisions + 1, let + 1) >= now - 1e-12


def test_landauers_bound():
    assert demon.landauer_heat(3, 0.5) == pytest.approx(1.5 * math.log(2))
    # Szilard's engine: what one bit wins at most is just what forgetting it costs.
    szilard = entropy([[0, 1]], [[1, 1]], [0, 1]) - entropy([[1]], [[2]], [1])
    assert demon.work_stored(szilard, 0.5) == pytest.approx(demon.landauer_heat(1, 0.5))
