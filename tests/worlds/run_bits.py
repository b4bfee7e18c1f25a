"""What must not differ between two runs of a world, for tests."""

import dataclasses

import numpy as np


def bits(simulation):
    """The whole state, its walls too, and all that world and dynamics remember (`World.memory`), to the bit."""
    state, memory = simulation.state, simulation.frame_view().memory
    kept = {entry.name: getattr(state, entry.name) for entry in dataclasses.fields(state)} | memory
    return {
        name: (value.dtype.str, value.tobytes()) if isinstance(value, np.ndarray) else value
        for name, value in kept.items()
    }
