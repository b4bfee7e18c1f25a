"""Gases of hard dumbbells for the tests of the physics: two discs of mass 1/2 and radius 1/2 that touch."""

import math

import numpy as np

from gasbox import observe
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.theory import hard_bodies, rotors

RADIUS, LENGTH = 0.5, 1.0
PLACE = [[-0.5 * LENGTH, 0.0], [0.5 * LENGTH, 0.0]]
INERTIA = rotors.dumbbell_inertia(1.0, RADIUS, LENGTH)
SECOND = hard_bodies.second_virial([RADIUS, RADIUS], PLACE)
"""B_2 [length²]."""


def dumbbells(count, crowding, *, flight=1.0, rotation=1.0, dynamics="event-driven", seed=1, **more):
    """A periodic square in which B_2 N/A is `crowding`, with temperatures of flight and of rotation at the start."""
    side = math.sqrt(SECOND * count / crowding)
    atoms = [{"position": place, "radius": RADIUS, "mass": 0.5} for place in PLACE]
    scenario = {
        "seed": seed,
        "container": {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"]},
        "molecules": [
            {
                "name": "dumbbells",
                "atoms": atoms,
                "count": count,
                "temperature": flight,
                "rotational_temperature": rotation,
            }
        ],
        "dynamics": {"kind": dynamics} | ({"time_step": 0.02} if dynamics == "stepped" else {}),
        "frame_interval": 1.0,
        **more,
    }
    return Simulation(parse(scenario))


def between_collisions(simulation, duration=20.0):
    """Mean time between two collisions of one molecule, measured [time]."""
    before, begin = int(simulation.dynamics.tallies.pair_collisions.sum()), simulation.time
    simulation.advance(until=begin + duration)
    met = int(simulation.dynamics.tallies.pair_collisions.sum()) - before
    return 0.5 * simulation.state.count * duration / max(met, 1)


def looks(simulation, number, apart):
    """The simulation at times so far apart."""
    for _ in range(number):
        simulation.advance(until=simulation.time + apart)
        yield simulation


def modes(simulation):
    """(3,) mean energies of flight along x and y and of rotation, of each degree of freedom."""
    found = observe.mode_energies(simulation.state, simulation.geometry)
    return np.array([found.x, found.y, found.rotation])
