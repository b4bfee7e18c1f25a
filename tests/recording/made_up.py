"""Frames of a gas that no dynamics moved: arbitrary bits in every array."""

from __future__ import annotations

import numpy as np

from gasbox.scenario import Scenario, parse
from gasbox.state import Frame, State, Tallies

__all__ = ["SCENARIO", "frame", "same_bits"]

SCENARIO: Scenario = parse(
    {
        "title": "Made up, with an ü",
        "seed": 2**63 - 1,
        "container": {"shape": "rectangle", "width": 30.5, "height": 20, "periodic": ["y"]},
        "species": [
            {"name": "a", "mass": 1, "radius": 0.1, "count": 3, "temperature": 1},
            {"name": "b", "mass": 0.1, "radius": 0.2},
        ],
        "dynamics": {"kind": "event-driven"},
        "frame_interval": 0.1,
    }
)


def frame(number: int, count: int, seed: int = 1) -> Frame:
    """Frame `number` with `count` particles."""
    generator = np.random.default_rng([seed, number])
    species = generator.integers(0, 2, count).astype(np.int32)
    state = State(
        time=number / 3,
        id=np.arange(count),
        species=species,
        mass=np.array([1, 0.1])[species],
        radius=np.array([0.1, 0.2])[species],
        position=generator.uniform(1, 19, (count, 2)),
        velocity=generator.normal(size=(count, 2)) * 10.0 ** generator.integers(-300, 300, (count, 2)),
    )
    tallies = Tallies(
        generator.normal(size=1),
        generator.integers(0, 2**62, (2, 2)),
        np.abs(generator.normal(size=(4, 2))),
        generator.integers(0, 2**62, (4, 2)),
        generator.normal(size=(4, 2)),
        generator.normal(size=(4, 2)),
        generator.integers(0, 2**62, (4, 2, 2)),
        np.abs(generator.normal(size=(4, 2))),
        *(generator.normal(size=1) for _ in range(10)),
    )
    memory = {
        "epoch": int(generator.integers(-(2**62), 2**62)),
        "epoch_length": float(np.exp(generator.normal())),
        "position": generator.normal(size=(count, 2)),
        "velocity": generator.normal(size=(count, 2)),
        "time": generator.normal(size=count),
    }
    return Frame(number, state, tallies, memory)


def same_bits(first: object, second: object) -> bool:
    """Whether two frames, states, tallies, arrays or numbers have the same types, shapes and bits."""
    if isinstance(first, dict):
        assert isinstance(second, dict)
        return first.keys() == second.keys() and all(same_bits(first[key], second[key]) for key in first)
    if isinstance(first, np.ndarray):
        return (
            isinstance(second, np.ndarray)
            and first.dtype == second.dtype
            and first.shape == second.shape
            and first.tobytes() == second.tobytes()
        )
    if first is None or isinstance(first, int | float):
        return type(first) is type(second) and first == second
    return type(first) is type(second) and same_bits(vars(first), vars(second))
