"""A slow twin of the stepped rule for molecules: all pairs of sites, all elements, in plain numbers.

It knows no cells, slots, marks or threads, and nothing of walls that move, are warm or let pass.
"""

from __future__ import annotations

import math

import numpy as np

from gasbox.geometry import Enclosure

SIDE, CORNER = 0, 1
GRAZING = 1e-12


class MoleculesTwin:
    def __init__(self, state, geometry, time_step):
        self.state, self.geometry, self.time_step = state, geometry, time_step
        self.enclosed = isinstance(geometry, Enclosure)
        self.g = geometry.gravity if self.enclosed else (0.0, 0.0)
        sites = state.sites
        self.owner = sites.owner.tolist()
        self.mine = [range(int(a), int(b)) for a, b in zip(sites.first[:-1], sites.first[1:], strict=True)]
        self.x = np.zeros((sites.count, 2))
        self.arm = np.zeros((sites.count, 2))
        self.sweeps = 0

    def run(self, steps):
        for _ in range(steps):
            for row in range(self.state.count):
                self.move(row)
            self.pairs()
            for row in range(self.state.count):
                self.walls(row)
        self.state.turn_sites()

    def move(self, row):
        s, dt = self.state, self.time_step
        for axis in range(2):
            fall = 0.5 * self.g[axis] * dt * dt
            s.position[row, axis] += s.velocity[row, axis] * dt
            s.position[row, axis] += fall
            s.velocity[row, axis] += self.g[axis] * dt
        s.position[row] = self.wrap(s.position[row])
        angle = s.angle[row] + s.angular_velocity[row] * dt
        if abs(angle) > math.pi:
            angle -= 2.0 * math.pi * math.floor(angle / (2.0 * math.pi) + 0.5)
        s.angle[row] = angle
        cos, sin = math.cos(angle), math.sin(angle)
        for site in self.mine[row]:
            px, py = s.sites.place[site]
            self.arm[site] = cos * px - sin * py, sin * px + cos * py
            self.x[site] = self.wrap(s.position[row] + self.arm[site])

    def wrap(self, x):
        for axis in range(2):
            if self.geometry.periodic[axis]:
                x[axis] -= math.floor(x[axis] / self.geometry.size[axis]) * self.geometry.size[axis]
        return x

    def away(self, p, q):
        d = self.x[p] - self.x[q]
        for axis in range(2):
            if self.geometry.periodic[axis]:
                length = self.geometry.size[axis]
                d[axis] += length if d[axis] < -length / 2 else -length if d[axis] > length / 2 else 0.0
        return float(d[0]), float(d[1])

    def pairs(self):
        r, touching = self.state.sites.radius, []
        for p in range(len(self.owner)):
            for q in range(p + 1, len(self.owner)):
                dx, dy = self.away(p, q)
                if self.owner[p] != self.owner[q] and dx * dx + dy * dy <= (r[p] + r[q]) ** 2:
                    touching.append((p, q))
        for sweep in range(8):
            met = [self.meet(p, q, sweep) for p, q in touching]
            if not any(met):
                return
            self.sweeps = max(self.sweeps, sweep + 1)

    def meet(self, p, q, sweep):
        i, j = self.owner[p], self.owner[q]
        discs = len(self.mine[i]) == len(self.mine[j]) == 1
        if discs and sweep > 0:
            return False
        dx, dy = self.away(p, q)
        met = self.exchange(i, j, dx, dy) if discs else self.strike(p, q, i, j, dx, dy)
        if sweep == 0 and any(self.g):
            self.part(p, q, i, j, dx, dy)
        return met

    def exchange(self, i, j, dx, dy):
        s = self.state
        dvx, dvy = s.velocity[i] - s.velocity[j]
        approach = dvx * dx + dvy * dy
        if approach >= 0.0:
            return False
        along, total = approach / (dx * dx + dy * dy), s.mass[i] + s.mass[j]
        s.velocity[i] -= 2.0 * s.mass[j] / total * along * np.array([dx, dy])
        s.velocity[j] += 2.0 * s.mass[i] / total * along * np.array([dx, dy])
        return True

    def strike(self, p, q, i, j, dx, dy):
        away = math.sqrt(dx * dx + dy * dy)
        nx, ny = dx / away, dy / away
        one, other = self.contact(p, nx, ny), self.contact(q, nx, ny)
        approach = self.closing(p, q, one[0], other[0], nx, ny)
        if approach >= -GRAZING * (one[2] + other[2]):
            return False
        impulse = -2.0 * approach / (one[3] + other[3])
        self.push(i, one[0], nx, ny, impulse)
        self.push(j, other[0], nx, ny, -impulse)
        return True

    def closing(self, p, q, lever_p, lever_q, nx, ny):
        s, i, j = self.state, self.owner[p], self.owner[q]
        dvx, dvy = s.velocity[i] - s.velocity[j]
        return dvx * nx + dvy * ny + s.angular_velocity[i] * lever_p - s.angular_velocity[j] * lever_q

    def contact(self, site, nx, ny):
        """Lever arm, normal speed, the speeds in it, and change of the speed for each unit of impulse."""
        s, row = self.state, self.owner[site]
        lever = self.arm[site, 0] * ny - self.arm[site, 1] * nx
        (vx, vy), spin = s.velocity[row], s.angular_velocity[row]
        turning = lever * lever / s.inertia[row] if s.inertia[row] > 0.0 else 0.0
        scale = abs(vx) + abs(vy) + abs(spin * lever)
        return lever, vx * nx + vy * ny + spin * lever, scale, 1.0 / s.mass[row] + turning

    def push(self, row, lever, nx, ny, impulse):
        s = self.state
        s.velocity[row] += (impulse / s.mass[row] * nx, impulse / s.mass[row] * ny)
        if s.inertia[row] > 0.0:
            s.angular_velocity[row] += impulse * lever / s.inertia[row]

    def part(self, p, q, i, j, dx, dy):
        r, mass = self.state.sites.radius, self.state.mass
        away = math.sqrt(dx * dx + dy * dy)
        if r[p] + r[q] - away <= 0.0:
            return
        part = (r[p] + r[q] - away) / away / (mass[i] + mass[j])
        self.shift(i, part * mass[j] * dx, part * mass[j] * dy)
        self.shift(j, -part * mass[i] * dx, -part * mass[i] * dy)

    def shift(self, row, dx, dy):
        self.state.position[row] += (dx, dy)
        for site in self.mine[row]:
            self.x[site] += (dx, dy)

    def walls(self, row):
        s, size = self.state, self.geometry.size
        if not self.enclosed:
            self.sides(row)
            return
        bounces = 0
        while True:
            found = self.at_element(row)
            if found is None:
                break
            site, depth, nx, ny = found
            bounces += 1
            assert bounces < 64
            lift = 0.0
            if any(self.g):
                lift = s.mass[row] * (self.g[0] * (depth * nx) + self.g[1] * (depth * ny))
                self.shift(row, depth * nx, depth * ny)
            lever, closing, _, yielding = self.contact(site, nx, ny)
            square = max(closing * closing + 2.0 * yielding * lift, 0.0)
            self.push(row, lever, nx, ny, (math.sqrt(square) - closing) / yielding)
        for axis in range(2):
            if self.geometry.periodic[axis]:
                s.position[row, axis] -= math.floor(s.position[row, axis] / size[axis]) * size[axis]

    def sides(self, row):
        while True:
            for site in self.mine[row]:
                for wall in range(4):
                    axis, inwards = wall // 2, 1.0 if wall % 2 == 0 else -1.0
                    if self.geometry.periodic[axis]:
                        continue
                    nx, ny = (inwards, 0.0) if axis == 0 else (0.0, inwards)
                    lever, closing, scale, yielding = self.contact(site, nx, ny)
                    place, r = (
                        self.state.position[row, axis] + self.arm[site, axis],
                        self.state.sites.radius[site],
                    )
                    at = place <= r if inwards > 0 else place + r >= self.geometry.size[axis]
                    if at and closing < -GRAZING * scale:
                        self.push(row, lever, nx, ny, -2.0 * closing / yielding)
                        break
                else:
                    continue
                break
            else:
                return

    def at_element(self, row):
        """The first site and element that overlap and approach: site, depth, normal."""
        for site in self.mine[row]:
            r = self.state.sites.radius[site]
            for element in self.geometry.elements:
                x, y = self.x[site] - np.array(element.place)
                nx, ny = element.normal
                if element.kind == SIDE:
                    face = float(element.faces) or (1.0 if x * nx + y * ny >= 0.0 else -1.0)
                    foot = x * element.tangent[0] + y * element.tangent[1]
                    if not element.low <= foot <= element.high:
                        continue
                    depth, nx, ny = r - face * (x * nx + y * ny), face * nx, face * ny
                else:
                    away = math.sqrt(x * x + y * y)
                    sign = 1.0 if element.kind == CORNER else -1.0
                    depth = r + element.radius - away if element.kind == CORNER else away + r - element.radius
                    nx, ny = sign * x / away, sign * y / away
                _, closing, scale, _ = self.contact(site, nx, ny)
                if depth >= 0.0 and closing < -GRAZING * scale:
                    return site, depth, nx, ny
        return None
