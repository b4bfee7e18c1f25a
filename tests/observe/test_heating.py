"""Heating curves: rows from states made by hand, stretches and latent heats of made-up curves."""

import itertools

import numpy as np
import pytest
from cold_discs import lattice
from hand_made import moved

from gasbox import observe
from gasbox.observe.heating import HeatingCourse
from gasbox.observe.stretches import smoothed
from gasbox.protocols import Observer
from gasbox.state import Tallies

pytestmark = pytest.mark.small


def test_rows_of_a_heating_curve():
    state, box = lattice(8, 6, 0.93)
    state.velocity[:, 0] = np.where(np.arange(48) % 2, 1.0, -1.0)
    state.potential = -48.0
    curve: Observer = observe.HeatingCurve(box, pressure=0.5)
    tallies = Tallies.zero(1, 4)
    tallies.kinetic_time[0] = 100.0  # before this run
    tallies.measured_time[0] = 7.0
    curve.start(state, tallies)
    later = moved(state.copy(), 0.0, 1.0, 0.0, 0.0)
    later.time, later.potential = 2.0, -24.0
    tallies.kinetic_time[0] += 2.0 * 30.0
    tallies.measured_time[0] += 2.0
    for _ in range(2):
        curve.observe(later, tallies)
    found = curve.value()
    assert found.time.tolist() == [0.0, 2.0]
    # 48 halves of kinetic energy each time; half a unit of potential each, and the area that was pushed away.
    assert found.heat == pytest.approx([0.0, 0.5 + 0.5 * box.height / 48])
    assert found.enthalpy[0] == pytest.approx(0.5 - 1.0 + 0.5 / 0.93)
    # Two of 96 degrees of freedom belong to the centre of mass.
    assert found.temperature == pytest.approx([2 * 24.0 / 94, 2 * 30.0 / 94])
    assert found.density == pytest.approx([0.93, 48 / (box.area + box.height)])
    assert found.shares[0].tolist() == [0.0, 0.0, 1.0]


def test_heat_while_the_pressure_changes():
    state, box = lattice(8, 6, 0.93)
    curve = observe.HeatingCurve(box, pressure=lambda time: 0.1 * time)
    curve.start(state, Tallies.zero(1, 4))
    for time, way in ((1.0, 1.0), (2.0, 3.0)):
        later = moved(state.copy(), 0.0, way, 0.0, 0.0)
        later.time = time
        curve.observe(later, Tallies.zero(1, 4))
    # P dA: 0.05 over 1, then 0.15 over 2.
    assert curve.value().heat * 48 == pytest.approx(np.array([0.0, 0.05, 0.35]) * box.height)


def made_up(noise=0.0, frames=400, melting=0.3, boiling=0.8):
    """A curve heated at a constant rate: heat capacities 2, 2.5 and 2, transitions at 0.40 and 0.45."""
    ends = np.cumsum([0.0, 2.0 * 0.20, melting, 2.5 * 0.05, boiling, 2.0 * 0.25])
    warm = np.array([0.20, 0.40, 0.40, 0.45, 0.45, 0.70])
    heat = np.linspace(0.0, ends[-1], frames)
    rng = np.random.default_rng(1)
    molten = np.interp(heat, ends[1:3], [0.0, 1.0])
    gone = np.interp(heat, ends[3:5], [0.0, 1.0])
    # Liquids hold crystalline patches, dense gases drops.
    solid = 0.98 * (1.0 - molten) + 0.10 * molten * (1.0 - gone)
    gas = 0.92 * gone + rng.normal(0.0, noise, frames) * (gone > 0.0)
    solid = np.clip(solid + rng.normal(0.0, noise, frames) * (gone == 0.0), 0.0, 1.0 - np.clip(gas, 0.0, 1.0))
    shares = np.stack([np.clip(gas, 0.0, 1.0), 1.0 - solid - np.clip(gas, 0.0, 1.0), solid], axis=1)
    temperature = np.interp(heat, ends, warm) + rng.normal(0.0, 0.1 * noise, frames)
    return HeatingCourse(
        np.arange(frames) * 2.0, heat, heat - 3.0, temperature, np.ones(frames), shares
    ), ends


@pytest.mark.parametrize("noise", [0.0, 0.05])
def test_stretches_of_a_made_up_curve(noise):
    curve, ends = made_up(noise)
    marked = observe.stretches(curve)
    assert [one.name for one in marked] == ["solid", "melting", "liquid", "boiling", "gas"]
    assert marked[0].begin == 0
    assert marked[-1].end == 400
    assert all(one.end == other.begin for one, other in itertools.pairwise(marked))
    # With thresholds of a fifth, a transition is marked a fifth of its width late at either end, or less.
    for one, begin, end in zip(marked[1::2], ends[1:5:2], ends[2:5:2], strict=True):
        assert begin - 0.05 < curve.heat[one.begin] < begin + 0.3 * (end - begin)
        assert end - 0.3 * (end - begin) < curve.heat[one.end - 1] < end + 0.05


@pytest.mark.parametrize("noise", [0.0, 0.03])
def test_latent_heats_of_a_made_up_curve(noise):
    curve, _ = made_up(noise, frames=800)
    melting, boiling = observe.latent_heats(curve)
    assert (melting.name, boiling.name) == ("melting", "boiling")
    for found, heat, warmth in ((melting, 0.3, 0.40), (boiling, 0.8, 0.45)):
        assert found.heat == pytest.approx(heat, abs=4 * found.error + 1e-9)
        assert found.temperature == pytest.approx(warmth, abs=0.003)
        assert found.begin < found.end
        assert found.error < 0.02


def test_cooling_back_is_a_branch_of_its_own():
    up, _ = made_up()
    back = HeatingCourse(
        up.time + 800.0,
        up.heat[::-1],
        up.enthalpy[::-1],
        up.temperature[::-1] - 0.02,
        up.density,
        up.shares[::-1],
    )
    both = HeatingCourse(
        *(np.concatenate(pair) for pair in zip(vars(up).values(), vars(back).values(), strict=True))
    )
    heating, cooling = observe.branches(both)
    assert (heating, cooling) == (slice(0, 400), slice(399, 800))
    names = [one.name for one in observe.stretches(both.rows(cooling))]
    assert names == ["gas", "boiling", "liquid", "melting", "solid"]
    taken = observe.latent_heats(both.rows(cooling))
    assert [one.heat for one in taken] == pytest.approx([0.8, 0.3], abs=0.03)
    assert observe.branches(up) == (slice(0, 400), slice(400, 400))


@pytest.mark.parametrize(
    ("shares", "name"),
    [
        ((0.0, 0.02, 0.98), "solid"),
        ((0.05, 0.15, 0.80), "solid"),
        ((0.0, 0.5, 0.5), "melting"),
        ((0.1, 0.85, 0.05), "liquid"),
        ((0.5, 0.5, 0.0), "boiling"),
        ((0.95, 0.05, 0.0), "gas"),
        ((0.5, 0.05, 0.45), "subliming"),
    ],
)
def test_what_shares_of_phases_are_called(shares, name):
    frames = np.arange(5.0)
    curve = HeatingCourse(frames, frames, frames, frames, frames, np.tile(shares, (5, 1)))
    assert [(one.name, one.begin, one.end) for one in observe.stretches(curve)] == [(name, 0, 5)]
    assert observe.latent_heats(curve) == []


def test_accidents_are_no_stretches():
    frames = np.arange(400.0)
    shares = np.tile([0.0, 0.05, 0.95], (400, 1))
    shares[200] = [0.0, 0.9, 0.1]
    shares[300:304] = [0.0, 0.6, 0.4]
    curve = HeatingCourse(frames, frames, frames, frames, frames, shares)
    assert [one.name for one in observe.stretches(curve)] == ["solid"]


def test_an_empty_curve():
    nothing = observe.HeatingCurve(lattice(4, 4, 0.9)[1]).value()
    assert nothing.shares.shape == (0, 3)
    assert observe.stretches(nothing) == observe.latent_heats(nothing) == []
    assert observe.branches(nothing) == (slice(0, 0), slice(0, 0))


def test_smoothing_takes_fewer_at_the_ends():
    assert smoothed(np.array([1.0, 2.0, 6.0, 3.0]), 1).tolist() == pytest.approx([1.5, 3.0, 11 / 3, 4.5])
    assert smoothed(np.array([1.0, 2.0]), 0).tolist() == [1.0, 2.0]
