"""A gas in a smooth circle keeps its angular momentum, and comes to rotate like a rigid body."""

from __future__ import annotations

import math

import numpy as np
import pytest
from vessels import agrees, gas, run, vessel

from gasbox.geometry import Circle

RIM, RADIUS, COUNT = 12.0, 0.03, 300
ROOM = (RIM - RADIUS) ** 2


def spin(state) -> float:
    arm = state.position - RIM
    return float(state.mass @ (arm[:, 0] * state.velocity[:, 1] - arm[:, 1] * state.velocity[:, 0]))


def test_a_gas_with_angular_momentum_rotates_like_a_body():
    # n(r) ~ exp(a r²), a = m Omega²/2T, Omega = L/<I>, and velocities along the circle Omega r on average, from a start
    # at which all turn equally fast, not with equal rates. Discs: area fraction 0.002, of which each percent would take
    # four from what the density rises; and at fixed L instead of Omega, a part in N: together 2e-3 of a density.
    place = vessel(Circle(RIM))
    state = gas(place, [COUNT], [RADIUS])
    arm = state.position - RIM
    state.velocity += 1.2 * np.stack([-arm[:, 1], arm[:, 0]], axis=1) / np.hypot(*arm.T)[:, None]
    at = run(place, state)
    before = spin(state)
    at.advance(1000.0)
    rings = np.linspace(0.0, ROOM, 6)
    density, turning = [], []
    for _ in range(16):
        squares, rates, energies = [], [], []
        for _ in range(20):
            at.advance(20.0)
            arm = state.position - RIM
            squares.append(np.sum(arm**2, axis=1))
            rates.append(arm[:, 0] * state.velocity[:, 1] - arm[:, 1] * state.velocity[:, 0])
            energies.append(0.5 * np.sum(state.velocity**2))
        square, rate = np.concatenate(squares), np.concatenate(rates)
        omega = before / (COUNT * square.mean())
        temperature = (np.mean(energies) - 0.5 * omega * before) / (COUNT - 0.5)
        a = 0.5 * omega**2 / temperature
        expected = np.diff(np.expm1(a * rings)) / math.expm1(a * ROOM)
        density.append(np.histogram(square, rings)[0] / square.size / expected)
        ring = np.digitize(square, rings[1:-1])
        turning.append([rate[ring == k].sum() / square[ring == k].sum() / omega for k in range(5)])
    assert a * ROOM > 0.5  # pressed outwards: at the rim 1.6 times as dense as in the middle, or more
    agrees(density, 1.0, bias=2e-3, least=0.01)
    agrees(turning, 1.0, bias=2e-3, least=0.1)
    assert spin(state) == pytest.approx(before, rel=1e-12)
