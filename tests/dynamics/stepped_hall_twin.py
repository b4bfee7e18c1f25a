"""A slow twin of the stepped rule in enclosures: all pairs, elements and images; it shares tables and `rebound`."""

from __future__ import annotations

import itertools
import math

import numpy as np
from circles_twin import enter, leave
from twins import SteppedTwin

from gasbox.dynamics.halls import start_walls
from gasbox.geometry import Path
from gasbox.kernels.hall import hall, set_motion
from gasbox.kernels.hall.approach import passes
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.rebound import rebound
from gasbox.kernels.hall.tables import LOWER, MASS, PUSH, S_PLACE, S_PUSH, S_SPEED, S_TIME, UNTIL, UPPER

SIDE, CORNER = 0, 1


class SteppedHallTwin(SteppedTwin):
    """One line of the rule after the other; see `docs/walls.md`."""

    def __init__(self, state, place, time_step, seed):
        super().__init__(state, place, time_step)
        self.hall = hall(place, 2, seed)
        start_walls(self.hall, place, state, 0.0, None)
        self.g = place.gravity
        self.steps = 0
        self.after = [displacement(self.hall, w, 0.0) for w in range(len(place.walls))]
        spread = [range(-2, 3) if periodic else range(1) for periodic in place.periodic]
        # In the order of elements, images up, images across.
        self.candidates = [
            (e, element, ix * place.size[0], iy * place.size[1])
            for e, element in enumerate(place.elements)
            for iy in spread[1]
            for ix in spread[0]
        ]

    def run(self, steps):
        for _ in range(steps):
            self.steps += 1
            self.time = self.steps * self.time_step
            self.move_walls()
            self.drift()
            self.pairs()
            self.gone = set()
            for i in range(self.state.count):
                self.cross(i)
                if i not in self.gone:
                    self.touch(i)
                    self.wrap(i)
            self.state.keep(np.array([i not in self.gone for i in range(self.state.count)], bool))

    def move_walls(self):
        self.before = list(self.after)
        for number, wall in enumerate(self.geometry.walls):
            row = self.hall.wall[number]
            if isinstance(wall.motion, Path) and row[UNTIL] <= self.time:
                set_motion(row, self.hall.rule[number], wall.motion, self.time, 0.0)
            if row[MASS] > 0.0:
                self.move_piston(row)
            self.after[number] = displacement(self.hall, number, self.time)

    def move_piston(self, row):
        dt = self.time_step
        row[S_PLACE] += row[S_SPEED] * dt + 0.5 * row[PUSH] * dt * dt
        row[S_SPEED] += row[PUSH] * dt
        row[S_PUSH], row[S_TIME] = row[PUSH], self.time
        for stop, inwards in ((row[LOWER], 1.0), (row[UPPER], -1.0)):
            if inwards * (row[S_PLACE] - stop) < 0.0:
                square = row[S_SPEED] ** 2 + 2.0 * row[PUSH] * (stop - row[S_PLACE])
                row[S_PLACE], row[S_SPEED] = stop, inwards * math.sqrt(max(square, 0.0))
                row[S_PUSH] = row[PUSH] if square > 0.0 else 0.0

    def drift(self):
        s, dt = self.state, self.time_step
        self.begin = s.position.copy()
        for axis in range(2):
            fall = 0.5 * self.g[axis] * dt * dt
            s.position[:, axis] = s.position[:, axis] + s.velocity[:, axis] * dt + fall
            s.velocity[:, axis] += self.g[axis] * dt
        for i in range(s.count):
            self.wrap(i)

    def wrap(self, i):
        for axis in range(2):
            length = self.geometry.size[axis]
            if self.geometry.periodic[axis] and not 0.0 <= self.state.position[i, axis] < length:
                shift = math.floor(self.state.position[i, axis] / length) * length
                self.state.position[i, axis] -= shift
                self.begin[i, axis] -= shift

    # -- pairs -----------------------------------------------------------------------------------------

    def pairs(self):
        s = self.state
        touching = []
        for i, j in itertools.combinations(range(s.count), 2):
            d, reach = self._difference(i, j), s.radius[i] + s.radius[j]
            if d[0] * d[0] + d[1] * d[1] <= reach * reach:
                touching.append((i, j))
        for i, j in touching:
            d = self._difference(i, j)
            if self.is_across(i) or self.is_across(j) or self.divided(i, j, d):
                continue
            self._collide(i, j, d)
            away = math.sqrt(d[0] * d[0] + d[1] * d[1])
            depth = s.radius[i] + s.radius[j] - away
            if any(self.g) and depth > 0.0:
                part = depth / away / (s.mass[i] + s.mass[j])
                s.position[i] += part * s.mass[j] * d
                s.position[j] -= part * s.mass[i] * d

    def is_across(self, i):
        return self.first_crossing(i, self.begin[i], self.state.position[i], self.before)[1] is not None

    def divided(self, i, j, d):
        kinds = self.state.species[[i, j]]
        start = self.state.position[i]
        for _, element, sx, sy in self.candidates:
            wall = self.geometry.walls[element.wall]
            if element.kind != SIDE or wall.open or self.hall.passes[element.wall, kinds].any():
                continue
            if self.line(element, sx, sy, start, start - d, 0.0, 0.0, self.after)[0] < math.inf:
                return True
        return False

    # -- geometry --------------------------------------------------------------------------------------

    def line(self, element, sx, sy, begin, end, skin, margin, before):
        """Part of the way at which it crosses a side; heights of begin and end; the face where it begins."""
        (nx, ny), (tx, ty) = element.normal, element.tangent
        px, py = element.place[0] + sx, element.place[1] + sy
        a = (begin[0] - px) * nx + (begin[1] - py) * ny - before[element.wall]
        b = (end[0] - px) * nx + (end[1] - py) * ny - self.after[element.wall]
        face = element.faces or (1 if a >= 0.0 else -1)
        a, b = face * a, face * b
        if not (a >= 0.0 and (b < skin or (face < 0 and b == skin)) and b < a):
            return math.inf, a, b, face
        foot_a = (begin[0] - px) * tx + (begin[1] - py) * ty
        foot_b = (end[0] - px) * tx + (end[1] - py) * ty
        part = min(a / (a - b), 1.0)
        foot = foot_a + part * (foot_b - foot_a)
        beyond = margin * (element.high - element.low)
        within = element.low - beyond <= foot <= element.high + beyond
        return (part if within else math.inf), a, b, face

    def crossing(self, element, sx, sy, begin, end, r, before):
        if element.kind == SIDE:
            return self.line(element, sx, sy, begin, end, 1e-9 * r, 1e-9, before)[0]
        px, py = element.place[0] + sx, element.place[1] + sy
        if element.kind == CORNER:
            a, d = self.to_post(element, (px, py), begin, end, before)
            if element.radius == 0.0 or a[0] ** 2 + a[1] ** 2 <= element.radius * element.radius:
                return math.inf
            return enter(d, a, element.radius)
        a, d = (begin[0] - px, begin[1] - py), (end[0] - begin[0], end[1] - begin[1])
        most = element.radius - 1e-9 * r
        if (end[0] - px) ** 2 + (end[1] - py) ** 2 < most * most:
            return math.inf
        return leave(d, a, element.radius)

    def to_post(self, element, place, begin, end, before):
        """Begin of a way as seen from a post, and how far it leads as seen from there."""
        number, normal = element.wall, np.array(element.normal)
        moved = self.after[number] - before[number]
        return begin - (np.array(place) + before[number] * normal), end - begin - moved * normal

    def first_crossing(self, i, begin, end, before):
        best = (math.inf, None)
        for candidate in self.candidates:
            _, element, sx, sy = candidate
            part = self.crossing(element, sx, sy, begin, end, self.state.radius[i], before)
            if part == math.inf or part >= best[0]:
                continue
            if self.geometry.walls[element.wall].open or not self.lets_pass(i, element):
                best = part, candidate
        return best

    def lets_pass(self, i, element):
        if not self.hall.passes[element.wall, self.state.species[i]]:
            return False
        rate = speed(self.hall, element.wall, self.time)
        ux = self.state.velocity[i, 0] - rate * element.normal[0]
        uy = self.state.velocity[i, 1] - rate * element.normal[1]
        along = ux * element.normal[0] + uy * element.normal[1] if element.kind == SIDE else 0.0
        return passes(self.hall, element.wall, int(self.state.species[i]), ux, uy, along)

    def put_back(self, i, element, sx, sy):
        """Where the way of disc i first touches an element, and the normal there."""
        begin, end, r = self.begin[i], self.state.position[i], self.state.radius[i]
        if element.kind == SIDE:
            _, a, b, face = self.line(element, sx, sy, begin, end, 1e-9 * r, 1e-9, self.before)
            part = max((a - r) / (a - b), 0.0)
            carried = (self.after[element.wall] - self.before[element.wall]) * (1.0 - part)
            normal = np.array(element.normal)
            return begin + part * (end - begin) + carried * normal, face * normal
        center = np.array((element.place[0] + sx, element.place[1] + sy))
        if element.kind == CORNER:
            a, d = self.to_post(element, center, begin, end, self.before)
            part, sign = enter(d, a, element.radius + r), 1.0
        else:
            part, sign = leave(end - begin, begin - center, element.radius - r), -1.0
        number, normal = element.wall, np.array(element.normal)
        carried = (self.after[number] - self.before[number]) * (1.0 - part)
        put = begin + part * (end - begin) + carried * normal
        away = put - (center + self.after[number] * normal)
        return put, sign * away / math.sqrt(away[0] ** 2 + away[1] ** 2)

    def overlap(self, i, element, sx, sy):
        """Depth (None for none) and normal."""
        nx, ny = element.normal
        move = self.after[element.wall]
        x = self.state.position[i, 0] - (element.place[0] + sx + move * nx)
        y = self.state.position[i, 1] - (element.place[1] + sy + move * ny)
        r = self.state.radius[i]
        if element.kind == SIDE:
            height = x * nx + y * ny
            face = element.faces or (1 if height >= 0.0 else -1)
            foot = x * element.tangent[0] + y * element.tangent[1]
            behind = face * height < 0.0 and element.high < math.inf
            if not element.low <= foot <= element.high or behind:
                return None, 0.0, 0.0
            depth, nx, ny = r - face * height, face * nx, face * ny
        else:
            away = math.sqrt(x * x + y * y)
            if element.kind == CORNER:
                depth, nx, ny = r + element.radius - away, x / away, y / away
            else:
                depth, nx, ny = away + r - element.radius, -x / away, -y / away
        return (None if depth < 0.0 else depth), nx, ny

    # -- what a wall does ------------------------------------------------------------------------------

    def cross(self, i):
        s = self.state
        for _ in range(8):
            _, found = self.first_crossing(i, self.begin[i], s.position[i], self.before)
            if found is None:
                return
            e, element, sx, sy = found
            if self.geometry.walls[element.wall].open:
                self.gone.add(i)
                return
            put, normal = self.put_back(i, element, sx, sy)
            self.bounce(i, e, element, normal[0], normal[1], put)
        s.position[i] = self.begin[i]

    def touch(self, i):
        for e, element, sx, sy in self.candidates:
            depth, nx, ny = self.overlap(i, element, sx, sy)
            if depth is None or self.geometry.walls[element.wall].open or self.lets_pass(i, element):
                continue
            vx, vy = self.state.velocity[i]
            u = speed(self.hall, element.wall, self.time) * (element.normal[0] * nx + element.normal[1] * ny)
            if vx * nx + vy * ny - u > 0.0:
                continue
            at = self.state.position[i].copy()
            put = at
            if any(self.g):
                way = np.array((depth * nx, depth * ny))
                part, other = self.first_crossing(i, at, at + way, self.after)
                free = 1.0 if other is None else 0.5 * part
                put = np.array((at[0] + free * depth * nx, at[1] + free * depth * ny))
            self.bounce(i, e, element, nx, ny, put)

    def bounce(self, i, e, element, nx, ny, put):
        s, number = self.state, element.wall
        m, heavy = s.mass[i], self.hall.wall[number, MASS]
        lift = self.g[0] * (put[0] - s.position[i, 0]) + self.g[1] * (put[1] - s.position[i, 1])
        s.position[i] = put
        along = element.normal[0] * nx + element.normal[1] * ny
        u = speed(self.hall, number, self.time) * along
        vx, vy = (float(part) for part in s.velocity[i])
        if vx * nx + vy * ny - u > 0.0:
            return
        if lift != 0.0:
            share = (m + heavy) / heavy if heavy > 0.0 else 1.0
            toward = vx * nx + vy * ny - u
            square = toward * toward + 2.0 * share * lift
            impulse = m / share * (-math.sqrt(max(square, 0.0)) - toward)
            vx, vy = vx + impulse / m * nx, vy + impulse / m * ny
            if heavy > 0.0:
                self.hall.wall[number, S_SPEED] -= impulse / heavy * along
        result = np.array([vx, vy, 0.0, 0.0, 0.0, 0.0])
        rebound(self.hall, e, nx, ny, vx, vy, m, s.radius[i], int(s.id[i]), self.time, float(e), result)
        s.velocity[i] = result[:2]
