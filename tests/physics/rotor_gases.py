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


def dumbbells(count, crowding, **start):
    """As `molecules`, of dumbbells."""
    return molecules([RADIUS, RADIUS], PLACE, SECOND, count, crowding, **start)


def molecules(radius, place, second, count, crowding, *, flight=1.0, rotation=1.0, seed=1):
    """A periodic square in which B_2 N/A is `crowding`, with temperatures of flight and of rotation at the start.

    All discs together have the mass 1.
    """
    side = math.sqrt(second * count / crowding)
    discs = zip(place, radius, strict=True)
    atoms = [{"position": list(p), "radius": r, "mass": 1 / len(radius)} for p, r in discs]
    kind = {"name": "molecules", "atoms": atoms, "count": count}
    scenario = {
        "seed": seed,
        "container": {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"]},
        "molecules": [{**kind, "temperature": flight, "rotational_temperature": rotation}],
        "dynamics": {"kind": "event-driven"},
        "frame_interval": 1.0,
    }
    return Simulation(parse(scenario))


def collided(simulation, collisions):
    """(Z - 1)/(B_2 n) over so many collisions, and its standard error; `crowding` is that of the start.

    The finite number in a periodic box is corrected for: each meets N - 1 others. Of the error, half comes from the
    temperature of flight, which wanders.
    """
    before, begin = simulation.dynamics.tallies.copy(), simulation.time
    count = simulation.state.count
    while (met := int((simulation.dynamics.tallies - before).pair_collisions.sum())) < collisions:
        simulation.advance(until=simulation.time + (100.0 if met < 100 else (simulation.time - begin)))
    change, duration = simulation.dynamics.tallies - before, simulation.time - begin
    excess = float(change.pair_virial[0]) / (2 * duration) / ((count - 1) * simulation.temperature())
    kind = simulation.scenario.kinds[0]
    radii = [simulation.scenario.site_kinds[site].radius for site in kind.sites]
    crowding = hard_bodies.second_virial(radii, kind.place, 180) * count / simulation.geometry.area
    return excess / crowding, 1.4 * excess / crowding / math.sqrt(met)


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
