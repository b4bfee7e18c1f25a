"""Rigid bodies by velocity Verlet: centre and angle are kicked and drift, discs follow, forces and torques are summed.

In the plane a rotation is one angle, so that this is as reversible, and symplectic, as it is of discs. Flexible
molecules move as their discs do; here they are only brought together. Without molecules `bodies` is None, and nothing
of this is compiled.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.forced.bodies import FLEXIBLE, RIGID, SINGLE, Bodies
from gasbox.kernels.forced.motion import inside
from gasbox.kernels.forced.tables import Atoms

__all__ = [
    "arm",
    "drift_bodies",
    "face",
    "find",
    "gather",
    "kick_bodies",
    "place",
    "scale_bodies",
    "show_bodies",
    "spin",
    "take_arms",
    "unwrapped",
    "wrap_bodies",
]


@bare_kernel
def kick_bodies(bodies: Bodies | None, time: float, begin: int, end: int) -> None:
    """Change the velocities of particles `begin` to `end` by force and torque for a time."""
    if bodies is None:
        return
    for row in range(begin, end):
        if bodies.style[row] == RIGID:
            bodies.vx[row] += bodies.fx[row] * bodies.rate[row] * time
            bodies.vy[row] += bodies.fy[row] * bodies.rate[row] * time
            bodies.turning[row] += bodies.torque[row] * bodies.ease[row] * time


@bare_kernel
def drift_bodies(bodies: Bodies | None, time: float, begin: int, end: int) -> None:
    """Change centres and angles by velocity * time."""
    if bodies is None:
        return
    for row in range(begin, end):
        if bodies.style[row] == RIGID:
            bodies.x[row] += bodies.vx[row] * time
            bodies.y[row] += bodies.vy[row] * time
            bodies.angle[row] += bodies.turning[row] * time


@bare_kernel
def face(bodies: Bodies | None, begin: int, end: int) -> None:
    """Note the direction of each rigid body."""
    if bodies is None:
        return
    for row in range(begin, end):
        bodies.cos[row], bodies.sin[row] = math.cos(bodies.angle[row]), math.sin(bodies.angle[row])


@inlined_kernel
def arm(bodies: Bodies, row: int, site: int) -> tuple[float, float]:
    """From the centre of a rigid body to one of its discs."""
    px, py, cos, sin = bodies.px[site], bodies.py[site], bodies.cos[row], bodies.sin[row]
    return cos * px - sin * py, sin * px + cos * py


@bare_kernel
def place(bodies: Bodies, atoms: Atoms, box: Box, begin: int, end: int) -> None:
    """Put the discs of rigid bodies to where these are."""
    for row in range(begin, end):
        if bodies.style[row] != RIGID:
            continue
        bodies.cos[row], bodies.sin[row] = math.cos(bodies.angle[row]), math.sin(bodies.angle[row])
        for site in range(bodies.first[row], bodies.first[row + 1]):
            ax, ay = arm(bodies, row, site)
            k = bodies.where[site]
            atoms.x[k] = bodies.x[row] + ax - bodies.shift_x[site] * box.width
            atoms.y[k] = bodies.y[row] + ay - bodies.shift_y[site] * box.height


@bare_kernel
def gather(bodies: Bodies, atoms: Atoms, begin: int, end: int) -> None:
    """Sum up the forces on the discs of each rigid body, and their torque about its centre."""
    for row in range(begin, end):
        if bodies.style[row] != RIGID:
            continue
        fx, fy, torque = 0.0, 0.0, 0.0
        for site in range(bodies.first[row], bodies.first[row + 1]):
            ax, ay = arm(bodies, row, site)
            k = bodies.where[site]
            fx += atoms.fx[k]
            fy += atoms.fy[k]
            torque += ax * atoms.fy[k] - ay * atoms.fx[k]
        bodies.fx[row], bodies.fy[row], bodies.torque[row] = fx, fy, torque


@inlined_kernel
def unwrapped(bodies: Bodies, atoms: Atoms, box: Box, site: int) -> tuple[float, float]:
    """Where a disc is beside its molecule, also outside a periodic box."""
    k = bodies.where[site]
    x = atoms.x[k] + bodies.shift_x[site] * box.width
    return x, atoms.y[k] + bodies.shift_y[site] * box.height


@bare_kernel
def centre(bodies: Bodies, atoms: Atoms, box: Box, row: int) -> tuple[float, float]:
    """Centre of mass of a flexible molecule, or of a disc."""
    if bodies.style[row] == SINGLE:
        return unwrapped(bodies, atoms, box, bodies.first[row])
    x, y = 0.0, 0.0
    for site in range(bodies.first[row], bodies.first[row + 1]):
        mass = atoms.mass[bodies.where[site]]
        sx, sy = unwrapped(bodies, atoms, box, site)
        x += mass * sx
        y += mass * sy
    return x * bodies.rate[row], y * bodies.rate[row]


@bare_kernel
def take_arms(bodies: Bodies, atoms: Atoms, box: Box, begin: int, end: int) -> None:
    """Turn the virial of discs into that of molecules: less the force on each times its arm.

    Precondition: forces are those of pairs alone (and gravity, which adds up to nothing).
    """
    for row in range(begin, end):
        if bodies.style[row] == SINGLE:
            continue
        x, y = 0.0, 0.0
        if bodies.style[row] == FLEXIBLE:
            x, y = centre(bodies, atoms, box, row)
        for site in range(bodies.first[row], bodies.first[row + 1]):
            k = bodies.where[site]
            if bodies.style[row] == FLEXIBLE:
                ax, ay = unwrapped(bodies, atoms, box, site)
                ax, ay = ax - x, ay - y
            else:
                ax, ay = arm(bodies, row, site)
            atoms.w[k] -= atoms.fx[k] * ax + atoms.fy[k] * ay


@inlined_kernel
def _turns(place: float, length: float) -> tuple[float, float]:
    """A place brought into [0, length), and the number of lengths that it was away."""
    within = inside(place, length)
    return within, math.floor((place - within) / length + 0.5)


@bare_kernel
def wrap_bodies(bodies: Bodies, atoms: Atoms, box: Box) -> None:
    """Bring all discs into the box along its periodic directions, each by itself, and the centres of rigid bodies.

    Flexible molecules stand where the first of their discs does.
    """
    for row in range(bodies.style.shape[0]):
        first, last = bodies.first[row], bodies.first[row + 1]
        base_x, base_y = 0.0, 0.0
        if bodies.style[row] == RIGID:
            if box.periodic_x:
                bodies.x[row], base_x = _turns(bodies.x[row], box.width)
            if box.periodic_y:
                bodies.y[row], base_y = _turns(bodies.y[row], box.height)
        for site in range(first, last):
            k = bodies.where[site]
            if box.periodic_x:
                atoms.x[k], turns = _turns(atoms.x[k], box.width)
                bodies.shift_x[site] += turns
            if box.periodic_y:
                atoms.y[k], turns = _turns(atoms.y[k], box.height)
                bodies.shift_y[site] += turns
            atoms.bx[k], atoms.by[k] = atoms.x[k], atoms.y[k]
        if bodies.style[row] != RIGID:
            base_x, base_y = bodies.shift_x[first], bodies.shift_y[first]
        for site in range(first, last):
            bodies.shift_x[site] -= base_x
            bodies.shift_y[site] -= base_y


@bare_kernel
def find(bodies: Bodies | None, atoms: Atoms, n: int) -> None:
    """Note where each disc is among the atoms."""
    if bodies is None:
        return
    for k in range(n):
        bodies.where[atoms.row[k]] = k


@bare_kernel
def scale_bodies(bodies: Bodies, atoms: Atoms, box: Box, by: float, begin: int, end: int) -> None:
    """Multiply places of centres of mass by a factor and divide their velocities by it; molecules keep their shape.

    box : before that
    """
    width, height = box.width * by, box.height * by
    for row in range(begin, end):
        x, y, vx, vy = bodies.x[row], bodies.y[row], bodies.vx[row], bodies.vy[row]
        if bodies.style[row] != RIGID:
            x, y = centre(bodies, atoms, box, row)
            vx, vy = velocity_of_centre(bodies, atoms, row)
        for site in range(bodies.first[row], bodies.first[row + 1]):
            k = bodies.where[site]
            sx, sy = unwrapped(bodies, atoms, box, site)
            atoms.x[k] = x * by + (sx - x) - bodies.shift_x[site] * width
            atoms.y[k] = y * by + (sy - y) - bodies.shift_y[site] * height
            if bodies.style[row] != RIGID:
                atoms.vx[k] = vx / by + (atoms.vx[k] - vx)
                atoms.vy[k] = vy / by + (atoms.vy[k] - vy)
        bodies.x[row], bodies.y[row], bodies.vx[row], bodies.vy[row] = x * by, y * by, vx / by, vy / by


@bare_kernel
def velocity_of_centre(bodies: Bodies, atoms: Atoms, row: int) -> tuple[float, float]:
    """Velocity of the centre of mass of a flexible molecule, or of a disc."""
    if bodies.style[row] == SINGLE:
        k = bodies.where[bodies.first[row]]
        return atoms.vx[k], atoms.vy[k]
    vx, vy = 0.0, 0.0
    for site in range(bodies.first[row], bodies.first[row + 1]):
        k = bodies.where[site]
        vx += atoms.mass[k] * atoms.vx[k]
        vy += atoms.mass[k] * atoms.vy[k]
    return vx * bodies.rate[row], vy * bodies.rate[row]


@bare_kernel
def spin(bodies: Bodies, atoms: Atoms, box: Box, row: int) -> tuple[float, float, float]:
    """Of a flexible molecule: moment of inertia, angular momentum, and kinetic energy about its centre of mass."""
    x, y = centre(bodies, atoms, box, row)
    vx, vy = velocity_of_centre(bodies, atoms, row)
    inertia, momentum, energy = 0.0, 0.0, 0.0
    for site in range(bodies.first[row], bodies.first[row + 1]):
        k = bodies.where[site]
        sx, sy = unwrapped(bodies, atoms, box, site)
        ax, ay, dvx, dvy = sx - x, sy - y, atoms.vx[k] - vx, atoms.vy[k] - vy
        mass = atoms.mass[k]
        inertia += mass * (ax * ax + ay * ay)
        momentum += mass * (ax * dvy - ay * dvx)
        energy += 0.5 * mass * (dvx * dvx + dvy * dvy)
    return inertia, momentum, energy


@bare_kernel
def _turn_of(bodies: Bodies, atoms: Atoms, box: Box, row: int, x: float, y: float) -> float:
    """Angle by which a flexible molecule is turned: the one that fits its shape at rest best."""
    along, across = 0.0, 0.0
    for site in range(bodies.first[row], bodies.first[row + 1]):
        mass = atoms.mass[bodies.where[site]]
        sx, sy = unwrapped(bodies, atoms, box, site)
        along += mass * (bodies.px[site] * (sx - x) + bodies.py[site] * (sy - y))
        across += mass * (bodies.px[site] * (sy - y) - bodies.py[site] * (sx - x))
    return math.atan2(across, along)


@bare_kernel
def show_bodies(bodies: Bodies, atoms: Atoms, gas: Gas, box: Box, begin: int, end: int) -> None:
    """Write particles `begin` to `end`, inside a periodic box, and their discs beside them, into the state."""
    for row in range(begin, end):
        if bodies.style[row] != RIGID:
            bodies.x[row], bodies.y[row] = centre(bodies, atoms, box, row)
            bodies.vx[row], bodies.vy[row] = velocity_of_centre(bodies, atoms, row)
        if bodies.style[row] == FLEXIBLE:
            inertia, momentum, _ = spin(bodies, atoms, box, row)
            bodies.inertia[row] = inertia
            bodies.turning[row] = momentum / inertia if inertia > 0.0 else 0.0
            bodies.angle[row] = _turn_of(bodies, atoms, box, row, bodies.x[row], bodies.y[row])
        x = inside(bodies.x[row], box.width) if box.periodic_x else bodies.x[row]
        y = inside(bodies.y[row], box.height) if box.periodic_y else bodies.y[row]
        vx, vy, turning = bodies.vx[row], bodies.vy[row], bodies.turning[row]
        bodies.position[row, 0], bodies.position[row, 1] = x, y
        bodies.velocity[row, 0], bodies.velocity[row, 1] = vx, vy
        bodies.shown_angle[row], bodies.shown_turning[row] = bodies.angle[row], turning
        for site in range(bodies.first[row], bodies.first[row + 1]):
            k = bodies.where[site]
            if bodies.style[row] == RIGID:
                ax, ay = arm(bodies, row, site)
                gas.velocity[site, 0], gas.velocity[site, 1] = vx - turning * ay, vy + turning * ax
            else:
                sx, sy = unwrapped(bodies, atoms, box, site)
                ax, ay = sx - bodies.x[row], sy - bodies.y[row]
                gas.velocity[site, 0], gas.velocity[site, 1] = atoms.vx[k], atoms.vy[k]
            gas.position[site, 0], gas.position[site, 1] = x + ax, y + ay
