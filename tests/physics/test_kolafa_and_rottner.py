"""The pressure of long runs in bulk against the equation of state of Kolafa and Rottner."""

import math

import numpy as np
import pytest
from runs import measure, one_gas, settle

from gasbox.theory import hard_disc

BLOCKS = 24


def blocks(eta: float, count: int, collisions: int):
    """Compressibility of blocks of a run that has left its lattice."""
    simulation = one_gas(count, eta)
    # A crowd takes some hundred collisions a disc to forget the lattice; sound crosses the box meanwhile.
    settle(simulation, 400 if count <= 1000 else 150)
    return np.array([measure(simulation, collisions).compressibility for _ in range(BLOCKS)])


@pytest.mark.validate
@pytest.mark.parametrize("count", [1000, 10_000])
@pytest.mark.parametrize("eta", [0.05, 0.3, 0.6])
def test_within_three_standard_errors(eta, count):
    z = blocks(eta, count, 200_000 if count == 1000 else 400_000)
    # Blocks of 80 to 400 collisions a disc are independent if neighbours among them are: their correlation would be
    # 1/sqrt(24) by chance.
    off = z - z.mean()
    assert abs((off[1:] * off[:-1]).sum() / (off**2).sum()) < 3.5 / math.sqrt(BLOCKS)
    error = float(np.std(z, ddof=1)) / math.sqrt(BLOCKS)
    expected = hard_disc.finite_compressibility(eta, count)
    print(f"eta {eta:g}, N {count}: Z = {z.mean():.5f} +- {error:.5f}, expected {expected:.5f}")
    # Student's t with 23 degrees of freedom: 3.1 standard errors for what 3 are of a Gaussian.
    assert z.mean() == pytest.approx(expected, abs=3.1 * error)
    assert error < 0.002 * (expected - 1)
