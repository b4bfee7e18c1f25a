"""Two sites that touch strike each other: an elastic impulse along the line of their centres turns both bodies."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_pair
from gasbox.kernels.collision import exchange, nearest
from gasbox.kernels.molecules.impulse import blow, closing_speed, lever, yielding
from gasbox.kernels.stepped.bodies import DEEP, DEEPEST, Bodies, is_single
from gasbox.kernels.stepped.tables import PUSHED, Slots, Walls

__all__ = [
    "GRAZING",
    "closing_at",
    "lever_of",
    "move_apart",
    "normal_speed",
    "push_body",
    "shift_body",
    "speed_scale",
    "strike",
    "take_over",
    "yielding_of",
]


GRAZING = 1e-12
"""Of the speeds at a contact: bodies that approach no faster graze, and are left alone."""


@inlined_kernel
def lever_of(bodies: Bodies, site: int, nx: float, ny: float) -> float:
    """Lever arm, about the centre of mass, of an impulse along n through the centre of a site [length]."""
    return lever(bodies.arm[site, 0], bodies.arm[site, 1], nx, ny)


@inlined_kernel
def yielding_of(bodies: Bodies, row: int, lever: float) -> float:
    """Change of the normal speed at a contact for each unit of impulse: one over the mass that is felt there."""
    return yielding(bodies.mass[row], bodies.inertia[row], lever)


@inlined_kernel
def push_body(bodies: Bodies, row: int, lever: float, nx: float, ny: float, impulse: float) -> None:
    """Give a body an impulse along n."""
    bodies.velocity[row, 0] += impulse / bodies.mass[row] * nx
    bodies.velocity[row, 1] += impulse / bodies.mass[row] * ny
    if bodies.inertia[row] > 0.0:
        bodies.spin[row] += impulse * lever / bodies.inertia[row]


@inlined_kernel
def normal_speed(bodies: Bodies, row: int, lever: float, nx: float, ny: float) -> float:
    """Speed along n of the point of a body at which an impulse with this lever arm acts [length/time]."""
    return bodies.velocity[row, 0] * nx + bodies.velocity[row, 1] * ny + bodies.spin[row] * lever


@inlined_kernel
def speed_scale(bodies: Bodies, row: int, lever: float) -> float:
    """The speeds whose rounding a normal speed carries [length/time]."""
    turning = abs(bodies.spin[row] * lever)
    return abs(bodies.velocity[row, 0]) + abs(bodies.velocity[row, 1]) + turning


@inlined_kernel
def closing_at(bodies: Bodies, row: int, site: int, nx: float, ny: float, u: float) -> float:
    """Speed along n of a site relative to a wall that moves at u, if it approaches; otherwise 0 [length/time]."""
    arm = lever_of(bodies, site, nx, ny)
    closing = normal_speed(bodies, row, arm, nx, ny) - u
    return closing if closing < -GRAZING * (speed_scale(bodies, row, arm) + abs(u)) else 0.0


@bare_kernel
def _exchange(
    a: int,
    b: int,
    dx: float,
    dy: float,
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    time: float,
    book: Ledger,
) -> bool:
    """Two single discs collide as they do in a gas of discs."""
    dvx = slots.vx[a] - slots.vx[b]
    dvy = slots.vy[a] - slots.vy[b]
    if dvx * dx + dvy * dy >= 0.0:
        return False
    p, q = slots.row[a], slots.row[b]
    change_p, change_q, impulse, virial = exchange(dx, dy, dvx, dvy, gas.mass[p], gas.mass[q])
    slots.vx[a] -= change_p * dx
    slots.vy[a] -= change_p * dy
    slots.vx[b] += change_q * dx
    slots.vy[b] += change_q * dy
    take_over(a, slots, bodies)
    take_over(b, slots, bodies)
    book_pair(book, gas.species[p], gas.species[q], p, q, time, -impulse * dx, -impulse * dy, virial)
    return True


@inlined_kernel
def take_over(slot: int, slots: Slots, bodies: Bodies) -> None:
    """The velocity of a single disc, as its slot has it."""
    row = bodies.owner[slots.row[slot]]
    bodies.velocity[row, 0], bodies.velocity[row, 1] = slots.vx[slot], slots.vy[slot]


@inlined_kernel
def _tell(slot: int, row: int, slots: Slots, bodies: Bodies) -> None:
    """The slot of a single disc has its velocity, too."""
    if is_single(bodies, row):
        slots.vx[slot], slots.vy[slot] = bodies.velocity[row, 0], bodies.velocity[row, 1]


@inlined_kernel
def _judge(reach_a: float, reach_b: float, away: float, bodies: Bodies) -> None:
    """Note how deep a contact is."""
    depth = (reach_a + reach_b - away) / min(reach_a, reach_b)
    if depth > bodies.worst[DEEPEST]:
        bodies.worst[DEEPEST] = depth
    if depth > 1.0:
        bodies.mishaps[DEEP] += 1


@bare_kernel
def strike(
    a: int, b: int, slots: Slots, gas: Gas, bodies: Bodies, box: Box, time: float, book: Ledger
) -> bool:
    """Execute the collision of the sites in slots `a` (of the lower row) and `b`; False if they do not approach."""
    dx = nearest(slots.x[a] - slots.x[b], box.width, box.periodic_x)
    dy = nearest(slots.y[a] - slots.y[b], box.height, box.periodic_y)
    p, q = slots.row[a], slots.row[b]
    i, j = bodies.owner[p], bodies.owner[q]
    if is_single(bodies, i) and is_single(bodies, j):
        return _exchange(a, b, dx, dy, slots, gas, bodies, time, book)
    away = math.sqrt(dx * dx + dy * dy)
    if away == 0.0:
        return False
    _judge(slots.reach[a], slots.reach[b], away, bodies)
    nx, ny = dx / away, dy / away
    lever_i, lever_j = lever_of(bodies, p, nx, ny), lever_of(bodies, q, nx, ny)
    dvx = bodies.velocity[i, 0] - bodies.velocity[j, 0]
    dvy = bodies.velocity[i, 1] - bodies.velocity[j, 1]
    closing = closing_speed(dvx, dvy, nx, ny, bodies.spin[i], lever_i, bodies.spin[j], lever_j)
    if not closing < -GRAZING * (speed_scale(bodies, i, lever_i) + speed_scale(bodies, j, lever_j)):
        return False
    impulse = blow(closing, yielding_of(bodies, i, lever_i), yielding_of(bodies, j, lever_j))
    push_body(bodies, i, lever_i, nx, ny, impulse)
    push_body(bodies, j, lever_j, nx, ny, -impulse)
    _tell(a, i, slots, bodies)
    _tell(b, j, slots, bodies)
    centres = (bodies.arm[q, 0] - bodies.arm[p, 0]) * nx + (bodies.arm[q, 1] - bodies.arm[p, 1]) * ny
    virial = impulse * (away + centres)
    book_pair(book, gas.species[p], gas.species[q], p, q, time, impulse * nx, impulse * ny, virial)
    return True


@bare_kernel
def move_apart(a: int, b: int, slots: Slots, bodies: Bodies, box: Box, walls: Walls) -> None:
    """Under gravity: move an overlapping pair apart about its centre of mass, which costs no energy."""
    if walls.hall.gx == 0.0 and walls.hall.gy == 0.0:
        return
    dx = nearest(slots.x[a] - slots.x[b], box.width, box.periodic_x)
    dy = nearest(slots.y[a] - slots.y[b], box.height, box.periodic_y)
    away = math.sqrt(dx * dx + dy * dy)
    depth = slots.reach[a] + slots.reach[b] - away
    if depth <= 0.0 or away == 0.0:
        return
    i, j = bodies.owner[slots.row[a]], bodies.owner[slots.row[b]]
    part = depth / away / (bodies.mass[i] + bodies.mass[j])
    shift_body(i, part * bodies.mass[j] * dx, part * bodies.mass[j] * dy, slots, bodies, walls)
    shift_body(j, -part * bodies.mass[i] * dx, -part * bodies.mass[i] * dy, slots, bodies, walls)


@inlined_kernel
def shift_body(row: int, dx: float, dy: float, slots: Slots, bodies: Bodies, walls: Walls) -> None:
    """Move a body and its sites without turning them; walls will have to be looked at."""
    bodies.position[row, 0] += dx
    bodies.position[row, 1] += dy
    for site in range(bodies.first[row], bodies.first[row + 1]):
        slot = walls.slot[site]
        slots.x[slot] += dx
        slots.y[slot] += dy
        walls.near[site] = walls.near[site] or PUSHED
