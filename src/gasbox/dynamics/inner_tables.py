"""What acts within flexible molecules, as the kernels of the forced rule take it."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels import forced
from gasbox.scenario import Kind
from gasbox.state import State

__all__ = ["inner_tables", "stiffest"]


def inner_tables(state: State, kinds: Sequence[Kind]) -> forced.Inner:
    """Bonds, angles and free pairs of all flexible molecules of a state, in its order. kinds : those of the scenario"""
    return forced.Inner(
        *_laid_out(
            state,
            [[bond.atoms for bond in kind.bonds] for kind in kinds],
            [[(bond.stiffness or 0.0, bond.length or 0.0) for bond in kind.bonds] for kind in kinds],
            2,
        ),
        *_laid_out(
            state,
            [[bend.atoms for bend in kind.angles] for kind in kinds],
            [[(bend.stiffness, math.radians(bend.angle or 0.0)) for bend in kind.angles] for kind in kinds],
            3,
        ),
        *_laid_out(state, [_free_pairs(kind) for kind in kinds], [[] for _ in kinds], 2)[:2],
    )


def _laid_out(
    state: State,
    members: list[list[tuple[int, ...]]],
    numbers: list[list[tuple[float, float]]],
    width: int,
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Where those of each particle begin (n + 1,), their discs (.., width), and two numbers of each (..,)."""
    assert state.sites is not None
    counts = np.array([len(of_kind) for of_kind in members] or [0], np.int64)
    many = np.where(state.sites.flexible, counts[state.species if members else 0], 0)
    rows = np.flatnonzero(many)
    tables = {k: np.array(members[k], np.int64) for k in set(state.species[rows].tolist())}
    values = {k: np.array(numbers[k], np.float64).reshape(-1, 2) for k in tables}
    discs = [
        tables[k] + state.sites.first[row] for row, k in zip(rows, state.species[rows].tolist(), strict=True)
    ]
    column = np.concatenate([np.zeros((0, 2)), *(values[k] for k in state.species[rows].tolist())])
    return (
        np.concatenate([[0], np.cumsum(many)]).astype(np.int64),
        np.concatenate([np.zeros((0, width), np.int64), *discs]),
        column[:, 0].copy(),
        column[:, 1].copy(),
    )


def _free_pairs(kind: Kind) -> list[tuple[int, ...]]:
    """Discs of a molecule that are neither bonded nor the ends of an angle."""
    tied = {frozenset(bond.atoms) for bond in kind.bonds}
    tied |= {frozenset((bend.atoms[0], bend.atoms[2])) for bend in kind.angles}
    if not kind.flexible:
        return []
    every = itertools.combinations(range(len(kind.sites)), 2)
    return [pair for pair in every if frozenset(pair) not in tied]


def stiffest(kind: Kind, mass: NDArray[np.float64]) -> float:
    """Highest frequency [1/time] at which a flexible molecule alone vibrates, about its shape at rest.

    mass : (sites,) of its discs
    """
    matrix = np.zeros((mass.size, 2, mass.size, 2))

    def add(stiffness: float, slope: dict[int, NDArray[np.float64]]) -> None:
        for one, other in itertools.product(slope, repeat=2):
            matrix[one, :, other, :] += stiffness * np.outer(slope[one], slope[other])

    for bond in kind.bonds:
        one, other = bond.atoms
        along = _unit(kind.place[one] - kind.place[other])
        add(bond.stiffness or 0.0, {one: along, other: -along})
    for bend in kind.angles:
        one, middle, other = bend.atoms
        first, second = (_across(kind.place[end] - kind.place[middle]) for end in (one, other))
        add(bend.stiffness, {one: -first, middle: first - second, other: second})
    weight = 1.0 / np.sqrt(np.repeat(mass, 2))
    whole = matrix.reshape(2 * mass.size, -1) * weight * weight[:, None]
    return math.sqrt(max(float(np.linalg.eigvalsh(whole).max()), 0.0)) if mass.size else 0.0


def _unit(arm: NDArray[np.float64]) -> NDArray[np.float64]:
    return arm / max(float(np.hypot(*arm)), 1e-300)


def _across(arm: NDArray[np.float64]) -> NDArray[np.float64]:
    """By how much the direction of an arm changes as its end is moved."""
    return np.array([-arm[1], arm[0]]) / max(float(arm @ arm), 1e-300)
