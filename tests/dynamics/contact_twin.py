"""A slow twin of event-driven dynamics of molecules: all discs, images and walls, looked at every moment.

The distances of all discs that could touch are sampled densely; between samples, zeros and the bottoms of near misses
are looked for by bisection. It shares no line with the engine.
"""

from __future__ import annotations

import itertools

import numpy as np

from gasbox.geometry import Enclosure, Post, Rectangle, Segment

STEP = 2e-3
CHUNK = 64


class MoleculeTwin:
    """Molecules from contact to contact.

    events : (time, 1 for a pair or 2 for a wall, lower id, other id or wall)
    """

    def __init__(self, state, geometry):
        self.geometry = geometry
        self.mass, self.inertia, self.sites = state.mass, state.inertia, state.sites
        self.x, self.v = state.position.copy(), state.velocity.copy()
        self.angle, self.omega = state.angle.copy(), state.angular_velocity.copy()
        self.g = np.array(getattr(geometry, "gravity", (0.0, 0.0)))
        self.time, self.events = state.time, []
        self.owner = state.sites.owner
        pairs = itertools.combinations(range(state.sites.count), 2)
        self.pairs = np.array([(k, m) for k, m in pairs if self.owner[k] != self.owner[m]])
        ways = [range(-2, 3) if periodic else (0,) for periodic in geometry.periodic]
        self.shifts = np.array([geometry.size * shift for shift in itertools.product(*ways)])
        # Just parted, per contact: it counts again once its distance has grown.
        self.parted = set()

    def discs(self, t):
        """(times, discs, 2): where all discs are at times after the present one."""
        t = np.atleast_1d(t)[:, None]
        centre = self.x + self.v * t[:, :, None] + 0.5 * self.g * t[:, :, None] ** 2
        angle = (self.angle + self.omega * t)[:, self.owner]
        cos, sin, place = np.cos(angle), np.sin(angle), self.sites.place
        arm = np.stack(
            [cos * place[:, 0] - sin * place[:, 1], sin * place[:, 0] + cos * place[:, 1]], axis=-1
        )
        return centre[:, self.owner] + arm

    def gaps(self, t):
        """(times, contacts): of all pairs of discs and images, then of all discs and walls."""
        at = self.discs(t)
        one, other = self.pairs.T
        apart = (at[:, one] - at[:, other])[:, :, None] + self.shifts
        reach = (self.sites.radius[one] + self.sites.radius[other])[:, None]
        of_pairs = (np.hypot(apart[..., 0], apart[..., 1]) - reach).reshape(len(at), -1)
        of_walls = [self.height(at, wall)[0] - self.sites.radius for wall in self.walls()]
        return np.concatenate([of_pairs, *of_walls], axis=1)

    def walls(self):
        """What there is apart from discs: (number of the wall, what it is)."""
        box = getattr(self.geometry, "container", self.geometry)
        found = []
        if isinstance(box, Rectangle):
            found = [(wall, wall) for wall in range(4) if not self.geometry.periodic[wall // 2]]
        else:
            found = [(0, box)]
        if isinstance(self.geometry, Enclosure):
            first = len(self.geometry.walls) - len(self.geometry.obstacles)
            found += [(first + k, obstacle) for k, obstacle in enumerate(self.geometry.obstacles)]
        return found

    def height(self, at, wall):
        """Distance of points (..., 2) from a wall, and the unit normal towards them."""
        _, what = wall
        if isinstance(what, int):
            axis, sign = what // 2, 1.0 if what % 2 == 0 else -1.0
            normal = np.zeros(2)
            normal[axis] = sign
            place = at[..., axis] if sign > 0 else self.geometry.size[axis] - at[..., axis]
            return place, np.broadcast_to(normal, at.shape)
        if isinstance(what, Segment):
            start, end = np.array(what.start), np.array(what.end)
            along = np.clip(((at - start) @ (end - start)) / ((end - start) @ (end - start)), 0.0, 1.0)
            away = at - (start + along[..., None] * (end - start))
            length = np.hypot(away[..., 0], away[..., 1])
            return length, away / length[..., None]
        away = at - np.array(what.center)
        length = np.hypot(away[..., 0], away[..., 1])
        if isinstance(what, Post):
            return length - what.radius, away / length[..., None]
        return what.radius - length, -away / length[..., None]

    def run(self, count):
        while len(self.events) < count:
            at, contact = self.next()
            self.go(at)
            self.strike(contact)

    def next(self):
        """Time until the next contact, and its number."""
        begin = 0.0
        while True:
            t = begin + STEP * np.arange(CHUNK + 1)
            f = self.gaps(t)
            if begin == 0.0:
                for contact in self.parted:
                    f[0, contact] = 1e-12
            found = []
            low = f.min(axis=0)
            for contact in np.flatnonzero(low < 0.05):
                found += self.zero(t, f[:, contact], contact)
            if found:
                return min(found)
            begin = t[-1]
            self.parted.clear()

    def zero(self, t, f, contact):
        """The first zero of one distance, also between two samples."""
        for k in range(len(t) - 1):
            if f[k] > 0 >= f[k + 1]:
                return [(self.bisect(t[k], t[k + 1], contact), contact)]
            if k > 0 and f[k] < min(f[k - 1], f[k + 1]) and f[k] < 1e-3:
                bottom = self.bottom(t[k - 1], t[k + 1], contact)
                if self.gaps(bottom)[0, contact] < 0:
                    return [(self.bisect(t[k - 1], bottom, contact), contact)]
        return []

    def bisect(self, low, high, contact):
        low += 1e-7 if contact in self.parted and low == 0.0 else 0.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            if self.gaps(middle)[0, contact] > 0:
                low = middle
            else:
                high = middle
        return low

    def bottom(self, low, high, contact):
        for _ in range(60):
            third = (high - low) / 3
            left, right = self.gaps([low + third, high - third])[:, contact]
            low, high = (low, high - third) if left < right else (low + third, high)
        return 0.5 * (low + high)

    def go(self, t):
        self.x = self.x + self.v * t + 0.5 * self.g * t * t
        self.v = self.v + self.g * t
        self.angle = self.angle + self.omega * t
        self.time += t

    def strike(self, contact):
        """Momentum along the normal, and its moment about each centre of mass."""
        self.parted.add(contact)
        pairs = len(self.pairs) * len(self.shifts)
        at = self.discs(0.0)[0]
        if contact < pairs:
            one, other = self.pairs[contact // len(self.shifts)]
            apart = at[one] - at[other] + self.shifts[contact % len(self.shifts)]
            members = [(one, 1.0), (other, -1.0)]
            normal = apart / np.hypot(*apart)
            self.events.append((self.time, 1, *sorted(map(int, self.owner[[one, other]]))))
        else:
            wall, one = divmod(contact - pairs, self.sites.count)
            number = self.walls()[wall][0]
            normal = self.height(at[one], self.walls()[wall])[1]
            members = [(one, 1.0)]
            self.events.append((self.time, 2, int(self.owner[one]), number))
        rate, give = 0.0, 0.0
        for disc, sign in members:
            i = self.owner[disc]
            arm = at[disc] - self.x[i]
            moment = arm[0] * normal[1] - arm[1] * normal[0]
            rate += sign * (self.v[i] @ normal + self.omega[i] * moment)
            give += 1.0 / self.mass[i] + (moment**2 / self.inertia[i] if self.inertia[i] else 0.0)
        for disc, sign in members:
            i = self.owner[disc]
            arm = at[disc] - self.x[i]
            push = -2.0 * rate / give * sign * normal
            self.v[i] = self.v[i] + push / self.mass[i]
            if self.inertia[i]:
                self.omega[i] += (arm[0] * push[1] - arm[1] * push[0]) / self.inertia[i]
        self.x = self.geometry.wrap(self.x)
