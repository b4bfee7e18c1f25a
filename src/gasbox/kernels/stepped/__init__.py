"""The classroom rule: drift, then the collisions of touching, approaching pairs, then the walls.

A team of threads drifts, files and looks for touching pairs, each thread on its share; what was found is executed by
one thread in the prescribed order. So the number of threads changes no bit.
"""

from gasbox.kernels.stepped.advance import GONE, GROW, LEFT, advance
from gasbox.kernels.stepped.bodies import Bodies, bodies, no_mishaps, site_gas
from gasbox.kernels.stepped.tables import Walls, grid, lists, room, walls

__all__ = [
    "GONE",
    "GROW",
    "LEFT",
    "Bodies",
    "Walls",
    "advance",
    "bodies",
    "grid",
    "lists",
    "no_mishaps",
    "room",
    "site_gas",
    "walls",
]
