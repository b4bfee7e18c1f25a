"""Reads a heating curve: where the gas is solid, melting, liquid, boiling or gas, and the latent heats between."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from gasbox.observe.heating import HeatingCourse
from gasbox.observe.phases import Phase

__all__ = ["LatentHeat", "Stretch", "StretchName", "branches", "latent_heats", "smoothed", "stretches"]

StretchName = Literal["solid", "melting", "liquid", "boiling", "gas", "subliming"]

TRANSITIONS: Final = ("melting", "boiling", "subliming")
"""Stretches in which two phases coexist."""
PURE: Final = 0.8
"""Share of a phase, of the two that may coexist, from which it counts as alone. A liquid holds up to a fifth of its
discs in crystalline patches, a dense gas as many in drops, and a crystal with a surface as many at its surface."""
_SMOOTH: Final = 40
"""Shares are averaged over one frame in so many of the whole curve on either side; a shorter stretch is an accident."""
_TURNED: Final = 0.05
"""Share of all heat added that must be taken back before a curve counts as having turned to cooling."""
_NEAR: Final = 0.5
"""Of a stretch beside a transition and clear of it, the share next to it to which a line is fitted."""
_LEAST_FRAMES: Final = 4
"""For such a line."""
_UNSURE: Final = 0.5
"""Of a latent heat: an error as large as that says that there is none to be read."""


@dataclass(frozen=True)
class Stretch:
    """A run of frames in which the gas is one thing, `begin` to `end` (not included)."""

    name: StretchName
    begin: int
    end: int


@dataclass(frozen=True)
class LatentHeat:
    """Heat that a transition takes at its temperature.

    Attributes
    ----------
    name : melting, boiling or subliming
    temperature : mean over the transition [energy]
    heat : for each disc [energy]
    error : standard error, from the scatter about the lines on both sides [energy]; that of the method comes on top
    begin, end : heat added where the stretch begins and ends [energy]
    """

    name: StretchName
    temperature: float
    heat: float
    error: float
    begin: float
    end: float


def branches(curve: HeatingCourse) -> tuple[slice, slice]:
    """Frames while heat is added, and those after, while it is taken back; the second may be empty."""
    frames = curve.heat.size
    if frames < 3:
        return slice(0, frames), slice(frames, frames)
    top = int(np.argmax(curve.heat))
    back = float(curve.heat[top] - np.min(curve.heat[top:]))
    if back < _TURNED * float(np.ptp(curve.heat)):
        return slice(0, frames), slice(frames, frames)
    return slice(0, top + 1), slice(top, frames)


def stretches(curve: HeatingCourse) -> list[Stretch]:
    """Stretches of a curve, or of one of its branches, from the shares of phases; neighbours always differ.

    With a share of at least `PURE` in the gas it is gas. Of what is condensed otherwise, a share of at least `PURE` in
    the solid makes it solid, and one of at most 1 - `PURE` liquid; in between it is melting. Liquid with more than
    1 - `PURE` in the gas is boiling, solid with as much is subliming.
    """
    width = _width(curve.time.size)
    shares = np.stack([smoothed(column, width) for column in curve.shares.T], axis=1)
    names = [_name(row) for row in shares]
    found: list[Stretch] = []
    for name, run in itertools.groupby(range(len(names)), key=names.__getitem__):
        frames = list(run)
        found.append(Stretch(name, frames[0], frames[-1] + 1))
    return _without_accidents(found, 2 * width + 1)


def latent_heats(curve: HeatingCourse) -> list[LatentHeat]:
    """Latent heats of the transitions of a curve, or of one of its branches.

    Enthalpy against temperature is nearly a straight line on both sides; the latent heat is the distance of the two
    lines at the temperature of the transition. So neither the thresholds that mark stretches nor the tilt of the
    plateau of a finite gas enter much. A transition without enough frames on both sides is left out, and so is one
    whose error is as large as half of it: at constant area, the lines on both sides may say nothing.
    """
    marked = stretches(curve)
    found = []
    for place in range(1, len(marked) - 1):
        here = marked[place]
        if here.name not in TRANSITIONS:
            continue
        one, other = _pure(marked, place - 1, last=True), _pure(marked, place + 1, last=False)
        if min(one.stop - one.start, other.stop - other.start) < _LEAST_FRAMES:
            continue
        warmth = float(np.mean(curve.temperature[here.begin : here.end]))
        (low, low_error), (high, high_error) = (_heat_at(curve, side, warmth) for side in (one, other))
        heat, error = abs(high - low), float(np.hypot(low_error, high_error))
        if not error <= _UNSURE * heat:
            continue
        ends = curve.heat[[here.begin, here.end - 1]]
        found.append(
            LatentHeat(
                here.name,
                warmth,
                heat,
                error,
                float(np.min(ends)),
                float(np.max(ends)),
            )
        )
    return found


def smoothed(values: NDArray[np.float64], width: int) -> NDArray[np.float64]:
    """(n,) float64: mean over `width` values on either side and the value itself, fewer at the ends."""
    sums = np.concatenate([[0.0], np.cumsum(values)])
    place = np.arange(values.size)
    low, high = np.maximum(place - width, 0), np.minimum(place + width + 1, values.size)
    mean: NDArray[np.float64] = (sums[high] - sums[low]) / (high - low)
    return mean


def _width(frames: int) -> int:
    return max(frames // (2 * _SMOOTH), 1) if frames > 4 else 0


def _name(shares: NDArray[np.float64]) -> StretchName:
    gas = float(shares[Phase.GAS])
    if gas >= PURE:
        return "gas"
    solid = float(shares[Phase.SOLID]) / (1.0 - gas)
    if solid >= PURE:
        return "subliming" if gas > 1.0 - PURE else "solid"
    if solid > 1.0 - PURE:
        return "melting"
    return "boiling" if gas > 1.0 - PURE else "liquid"


def _without_accidents(found: list[Stretch], least: int) -> list[Stretch]:
    """Give stretches shorter than `least` frames to the longer neighbour, the shortest first."""
    while len(found) > 1:
        lengths = [one.end - one.begin for one in found]
        place = int(np.argmin(lengths))
        if lengths[place] >= least:
            break
        beside = [k for k in (place - 1, place + 1) if 0 <= k < len(found)]
        name = found[max(beside, key=lambda k: lengths[k])].name
        found[place] = Stretch(name, found[place].begin, found[place].end)
        found = [_whole(list(run)) for _, run in itertools.groupby(found, key=lambda one: one.name)]
    return found


def _whole(run: list[Stretch]) -> Stretch:
    return Stretch(run[0].name, run[0].begin, run[-1].end)


def _pure(marked: list[Stretch], place: int, last: bool) -> slice:
    """Frames of a stretch that are clear of the transitions around it, those next to the one after it (last) or before.

    A transition is marked from a share of 1 - `PURE` to `PURE`, so it reaches further by the same part on either side.
    """
    further = (1.0 - PURE) / (2.0 * PURE - 1.0)
    gaps = [
        round(further * (marked[k].end - marked[k].begin))
        if 0 <= k < len(marked) and marked[k].name in TRANSITIONS
        else 0
        for k in (place - 1, place + 1)
    ]
    begin, end = marked[place].begin + gaps[0], marked[place].end - gaps[1]
    if end - begin < _LEAST_FRAMES:
        # So short that transitions nearly meet: the middle is the best there is.
        begin, end = marked[place].begin, marked[place].end
        spare = max(end - begin - _LEAST_FRAMES, 0) // 2
        begin, end = begin + spare, end - spare
    count = max(round(_NEAR * (end - begin)), min(_LEAST_FRAMES, end - begin))
    return slice(end - count, end) if last else slice(begin, begin + count)


def _heat_at(curve: HeatingCourse, side: slice, warmth: float) -> tuple[float, float]:
    """Heat added at a temperature by straight lines through some frames, and its standard error [energy].

    Both are drawn against time, which alone has no scatter of its own, whether heat or temperature is what is driven.
    """
    time = curve.time[side] - curve.time[side][0]
    (warm, warming), warm_error = _line(time, curve.temperature[side])
    (level, rise), level_error = _line(time, curve.heat[side])
    if warming == 0.0:
        return level, float("inf")
    when = (warmth - warm) / warming
    return level + rise * when, float(np.hypot(level_error(when), rise / warming * warm_error(when)))


def _line(
    time: NDArray[np.float64], values: NDArray[np.float64]
) -> tuple[tuple[float, float], Callable[[float], float]]:
    """Level at time zero and slope of a straight line, and its standard error as a function of time."""
    middle = float(np.mean(time))
    away = time - middle
    spread = float(away @ away)
    slope = float(away @ values) / spread
    level = float(np.mean(values)) - slope * middle
    scatter = float(np.sum((values - level - slope * time) ** 2)) / max(time.size - 2, 1)
    return (level, slope), lambda when: math.sqrt(scatter * (1.0 / time.size + (when - middle) ** 2 / spread))
