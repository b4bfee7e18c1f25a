"""What else a Python user would take for a stepped gas: a game engine, and NumPy with a k-d tree."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gasbox.bench.contest import Contender
from gasbox.initial import populate
from gasbox.scenario import Scenario
from gasbox.state import State

__all__ = ["ArrayGas", "PymunkGas", "stepped_peers"]


def stepped_peers(scenario: Scenario) -> Iterator[Contender]:
    """The peers that are installed, each with the same gas at the start."""
    for peer in (PymunkGas, ArrayGas):
        try:
            yield peer(scenario)
        except ImportError:
            continue


class PymunkGas:
    """Rigid circles in pymunk (Chipmunk): elastic, without friction or slop, ten iterations."""

    name = "pymunk"

    def __init__(self, scenario: Scenario) -> None:
        import pymunk

        self._space = space = pymunk.Space()
        space.iterations, space.collision_slop, space.damping = 10, 0.0, 1.0
        state, box = populate(scenario), scenario.container.geometry()
        corners = [(0, 0), (box.width, 0), (box.width, box.height), (0, box.height)]
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            _add(space, pymunk.Segment(space.static_body, start, end, 0.0))
        for position, velocity in zip(state.position.tolist(), state.velocity.tolist(), strict=True):
            body = pymunk.Body(1.0, float("inf"))
            body.position, body.velocity = tuple(position), tuple(velocity)
            space.add(body)
            _add(space, pymunk.Circle(body, 1.0))
        self._particles = state.count

    def work(self, portions: int) -> float:
        """Steps times particles."""
        for _ in range(portions):
            self._space.step(1.0)
        return float(portions * self._particles)


def _add(space: Any, shape: Any) -> None:
    shape.elasticity, shape.friction = 1.0, 0.0
    space.add(shape)


class ArrayGas:
    """NumPy arrays, and the pairs of each step from SciPy's k-d tree, as a student writes it."""

    name = "NumPy + k-d tree"

    def __init__(self, scenario: Scenario) -> None:
        from scipy.spatial import cKDTree  # type: ignore[import-untyped]

        self._tree = cKDTree
        self._state: State = populate(scenario)
        self._size: NDArray[np.float64] = scenario.container.geometry().size

    def work(self, portions: int) -> float:
        """Steps times particles."""
        for _ in range(portions):
            self._step()
        return float(portions * self._state.count)

    def _step(self) -> None:
        position, velocity = self._state.position, self._state.velocity
        position += velocity
        first, second = self._tree(position).query_pairs(2.0, output_type="ndarray").T
        apart = position[first] - position[second]
        along = np.einsum("ij,ij->i", velocity[first] - velocity[second], apart)
        meet = along < 0
        first, second, apart, along = first[meet], second[meet], apart[meet], along[meet]
        change = (along / np.einsum("ij,ij->i", apart, apart))[:, None] * apart
        np.subtract.at(velocity, first, change)
        np.add.at(velocity, second, change)
        outward = ((position <= 1) & (velocity < 0)) | ((position >= self._size - 1) & (velocity > 0))
        velocity[outward] *= -1
