"""Small gases made by hand."""

import numpy as np

from gasbox.geometry import Enclosure, Wall, side_names
from gasbox.state import State


def gas(velocity, mass=None, species=None, position=None, radius=None, time=0.0):
    """A state from velocities alone; the rest is one unless given."""
    velocity = np.atleast_2d(np.asarray(velocity, dtype=np.float64)).reshape(-1, 2)
    count = velocity.shape[0]

    def column(given, default, dtype=np.float64):
        return np.array(given, dtype=dtype) if given is not None else np.full(count, default, dtype=dtype)

    return State(
        time=time,
        id=np.arange(count, dtype=np.int64),
        species=column(species, 0, np.int32),
        mass=column(mass, 1.0),
        radius=column(radius, 1.0),
        position=np.array(position, dtype=np.float64) if position is not None else np.ones((count, 2)),
        velocity=velocity,
    )


def hall(container, *obstacles, gravity=(0.0, 0.0), names=None, **settings):
    """An enclosure with smooth walls, those of `names` first; settings give walls other properties, by name."""
    sides = side_names(container)
    names = [*sides, *(names or [f"obstacle_{k + 1}" for k in range(len(obstacles))])]
    walls = tuple(Wall(name, **settings.get(name, {})) for name in names)
    return Enclosure(container, obstacles, walls, gravity)


def moved(state, *displacement, velocity=None):
    """The same state with its walls displaced."""
    state.wall_displacement = np.array(displacement, dtype=np.float64)
    state.wall_velocity = np.zeros(len(displacement)) if velocity is None else np.array(velocity, float)
    return state
