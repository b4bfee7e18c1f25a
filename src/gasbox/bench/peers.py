"""What else a Python user would take for a stepped gas: two game engines, an N-body code, and NumPy."""

from __future__ import annotations

import ctypes
import importlib
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gasbox.bench.contest import Contender
from gasbox.bench.crowds import missing_crowd_peers
from gasbox.bench.fluids import missing_fluid_peers
from gasbox.initial import populate
from gasbox.scenario import Scenario
from gasbox.state import State

__all__ = [
    "PEERS",
    "ArrayGas",
    "Box2DGas",
    "PymunkGas",
    "ReboundGas",
    "corners",
    "missing_peers",
    "pymunk_gas",
    "stepped_peers",
]


def stepped_peers(scenario: Scenario) -> list[Contender]:
    """The peers that are installed, each with the same gas at the start."""
    return [make(scenario) for package, make in PEERS.items() if _is_installed(package)]


def pymunk_gas(scenario: Scenario) -> list[Contender]:
    """pymunk with the same gas at the start, which may be of molecules; nothing where it is not installed."""
    return [PymunkGas(scenario)] if _is_installed("pymunk") else []


def missing_peers() -> list[str]:
    """Names of the packages that are not installed (or do not start), of those that peers of any kind need."""
    stepped = [package for package in PEERS if not _is_installed(package)]
    return stepped + missing_fluid_peers() + missing_crowd_peers()


def _is_installed(package: str) -> bool:
    try:
        importlib.import_module(package)
    except ImportError:
        return False
    return True


def corners(size: NDArray[np.float64]) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Both ends of each wall of a box of width and height `size` (2,) [length]."""
    width, height = size.tolist()
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    return list(zip(corners, corners[1:] + corners[:1], strict=True))


class PymunkGas:
    """Rigid circles, or bodies of several, in pymunk (Chipmunk): elastic, without friction or slop, ten iterations."""

    name = "pymunk"

    def __init__(self, scenario: Scenario) -> None:
        import pymunk

        self._space = space = pymunk.Space()
        space.iterations, space.collision_slop, space.damping = 10, 0.0, 1.0
        state = populate(scenario)
        for start, end in corners(scenario.geometry().size):
            self._add(pymunk.Segment(space.static_body, start, end, 0.0))
        for row in range(state.count):
            self._enter(state, row)
        self._particles = state.count

    def _enter(self, state: State, row: int) -> None:
        """Add a particle: a circle, or the circles of a molecule on one body."""
        import pymunk

        inertia = float("inf") if state.sites is None else float(state.inertia[row])
        body = pymunk.Body(float(state.mass[row]), inertia)
        body.position, body.velocity = (
            tuple(state.position[row].tolist()),
            tuple(state.velocity[row].tolist()),
        )
        self._space.add(body)
        if state.sites is None:
            self._add(pymunk.Circle(body, float(state.radius[row])))
            return
        body.angle, body.angular_velocity = float(state.angle[row]), float(state.angular_velocity[row])
        sites = state.sites
        for site in range(sites.first[row], sites.first[row + 1]):
            self._add(pymunk.Circle(body, float(sites.radius[site]), tuple(sites.place[site].tolist())))

    def _add(self, shape: Any) -> None:
        shape.elasticity, shape.friction = 1.0, 0.0
        self._space.add(shape)

    def work(self, portions: int) -> float:
        """Steps times particles."""
        for _ in range(portions):
            self._space.step(1.0)
        return float(portions * self._particles)


class Box2DGas:
    """Rigid circles in Box2D 3 (single precision): elastic at any speed, no friction, spin, sleep or sweeps.

    One substep in a step, which is the fastest. A step is the sixtieth of a second that its contacts are tuned for.
    """

    name = "Box2D"
    _STEP = 1.0 / 60.0

    def __init__(self, scenario: Scenario) -> None:
        import pyb2d3  # type: ignore[import-untyped]

        self._world = world = pyb2d3.World(gravity=(0, 0), restitution_threshold=0.0)
        world.sleeping_enabled = world.continuous_enabled = False
        surface = pyb2d3.surface_material(restitution=1.0, friction=0.0)
        shape = pyb2d3.shape_def(density=1.0 / np.pi, material=surface, enable_contact_events=False)
        walls = world.create_static_body(position=(0, 0))
        for start, end in corners(scenario.geometry().size):
            walls.create_segment_shape(shape, pyb2d3.segment(start, end))
        state, circle = populate(scenario), pyb2d3.circle(radius=1.0)
        body = pyb2d3.body_def(type=pyb2d3.BodyType.DYNAMIC, enable_sleep=False, fixed_rotation=True)
        velocities = state.velocity / self._STEP
        self._bodies: list[Any] = []
        for position, velocity in zip(state.position.tolist(), velocities.tolist(), strict=True):
            body.position, body.linear_velocity = tuple(position), tuple(velocity)
            self._bodies.append(world.create_body_from_def(body))
            self._bodies[-1].create_circle_shape(shape, circle)

    def work(self, portions: int) -> float:
        """Steps times particles."""
        for _ in range(portions):
            self._world.step(self._STEP, 1)
        return float(portions * len(self._bodies))


class ReboundGas:
    """Hard spheres in REBOUND: drift (leapfrog without gravity), collisions found in its tree, all in C.

    It has no walls, and rounding errors would let the spheres leave the plane, exponentially; both are seen to in
    NumPy after each step, in its own memory, which takes 6 % of its time (10^3) to 2 % (10^5).
    """

    name = "REBOUND"

    def __init__(self, scenario: Scenario) -> None:
        import rebound  # type: ignore[import-untyped]

        self._gas = gas = rebound.Simulation()
        state, size = populate(scenario), scenario.geometry().size
        gas.integrator, gas.gravity, gas.dt = "leapfrog", "none", 1.0
        gas.collision, gas.collision_resolve = "tree", "hardsphere"
        # The tree's root is centred on zero; centres stay within it with a little to spare.
        gas.root_size, self._reach = 1.01 * float(size.max()), 0.5 * size - 1.0
        for (x, y), (vx, vy) in zip(
            (state.position - 0.5 * size).tolist(), state.velocity.tolist(), strict=True
        ):
            gas.add(m=1.0, r=1.0, x=x, y=y, vx=vx, vy=vy)
        # A particle is a row of numbers (or pointers) of 8 bytes: x, y, z, vx, vy, vz, ...
        columns = ctypes.sizeof(rebound.Particle) // 8
        numbers = ctypes.cast(gas._particles, ctypes.POINTER(ctypes.c_double))
        self._rows = np.ctypeslib.as_array(numbers, (state.count, columns))

    def work(self, portions: int) -> float:
        """Steps times particles."""
        position, velocity = self._rows[:, 0:2], self._rows[:, 3:5]
        for _ in range(portions):
            self._gas.steps(1)
            outward = (position <= -self._reach) & (velocity < 0)
            outward |= (position >= self._reach) & (velocity > 0)
            velocity[outward] *= -1
            self._rows[:, 2] = self._rows[:, 5] = 0.0
        return float(portions * len(self._rows))


class ArrayGas:
    """NumPy arrays, and the pairs of each step from SciPy's k-d tree, as a student writes it."""

    name = "NumPy + k-d tree"

    def __init__(self, scenario: Scenario) -> None:
        from scipy.spatial import cKDTree  # type: ignore[import-untyped]

        self._tree = cKDTree
        self._state: State = populate(scenario)
        self._size: NDArray[np.float64] = scenario.geometry().size

    def work(self, portions: int) -> float:
        """Steps times particles."""
        for _ in range(portions):
            self._step()
        return float(portions * self._state.count)

    def _step(self) -> None:
        position, velocity = self._state.position, self._state.velocity
        position += velocity
        first, second = self._tree(position).query_pairs(2.0, output_type="ndarray").T
        apart = position[first] - position[second]
        along = np.einsum("ij,ij->i", velocity[first] - velocity[second], apart)
        meet = along < 0
        first, second, apart, along = first[meet], second[meet], apart[meet], along[meet]
        change = (along / np.einsum("ij,ij->i", apart, apart))[:, None] * apart
        np.subtract.at(velocity, first, change)
        np.add.at(velocity, second, change)
        outward = ((position <= 1) & (velocity < 0)) | ((position >= self._size - 1) & (velocity > 0))
        velocity[outward] *= -1


PEERS: dict[str, Callable[[Scenario], Contender]] = {
    "pymunk": PymunkGas,
    "pyb2d3": Box2DGas,
    "rebound": ReboundGas,
    "scipy": ArrayGas,
}
"""Package that is imported, and the gas in it."""
