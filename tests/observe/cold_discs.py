"""Small gases of Lennard-Jones discs at some density and temperature, by plain Metropolis moves."""

import math

import numpy as np

from gasbox.geometry import Rectangle
from gasbox.state import State
from gasbox.theory.pair_laws import potential


class _Law:
    law = "lennard-jones"
    epsilon = sigma = screening_length = 1.0
    cutoff = 2.5
    truncation = "shifted"
    reach = 1.5


def discs(position, box):
    """Discs at rest in a box, and the box."""
    count = len(position)
    nothing = np.zeros((count, 2))
    state = State(
        0.0,
        np.arange(count),
        np.zeros(count, np.int32),
        np.ones(count),
        np.full(count, 0.5),
        position,
        nothing,
    )
    return state, box


def lattice(columns, rows, density):
    """A triangular lattice that fills a periodic box."""
    spacing = math.sqrt(2.0 / (math.sqrt(3.0) * density))
    place = np.array([[i + 0.5 * (j % 2), j * math.sqrt(0.75)] for j in range(rows) for i in range(columns)])
    box = Rectangle(columns * spacing, rows * spacing * math.sqrt(0.75), True, True)
    return discs((place + 0.25) * spacing, box)


def equilibrated(state, box, temperature, sweeps, step=0.12, seed=1):
    """The same after some sweeps of single moves."""
    rng = np.random.default_rng(seed)
    place, size = state.position.copy(), box.size
    for _ in range(sweeps):
        for row in rng.permutation(len(place)):
            trial = place[row] + rng.uniform(-step, step, 2)
            change = _energy(place, row, trial, size) - _energy(place, row, place[row], size)
            if change <= 0.0 or rng.random() < math.exp(-change / temperature):
                place[row] = trial
    return discs(box.wrap(place), box)


def _energy(place, row, at, size):
    way = np.delete(place, row, axis=0) - at
    way -= np.round(way / size) * size
    distance = np.maximum(np.sqrt(np.sum(way**2, axis=1)), 0.3)
    near = distance < 2.5
    return float(np.sum(potential(_Law, distance[near])))
