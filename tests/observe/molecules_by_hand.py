"""Gases of molecules made by hand."""

import numpy as np
from hand_made import gas

from gasbox.state import Sites


def sites(first, mass, place, position=None, velocity=None, flexible=None):
    """Discs of particles; they stand at their places and rest unless told otherwise."""
    mass, place = np.array(mass, float), np.array(place, float).reshape(-1, 2)
    count = len(first) - 1
    return Sites(
        first=np.array(first, np.int64),
        species=np.zeros(mass.size, np.int32),
        mass=mass,
        radius=np.ones(mass.size),
        place=place,
        position=place.copy() if position is None else np.array(position, float),
        velocity=np.zeros_like(place) if velocity is None else np.array(velocity, float),
        flexible=np.zeros(count, np.bool_) if flexible is None else np.array(flexible),
    )


def dumbbell_and_disc(position=None, spin=3.0):
    """Kind 1: a dumbbell of mass 4 and moment of inertia 8; kind 0: a disc of mass 2 that cannot turn."""
    state = gas([[1.0, 2.0], [3.0, 0.0]], mass=[4.0, 2.0], species=[1, 0], position=position)
    state.angle, state.angular_velocity = np.array([0.0, 0.0]), np.array([spin, 5.0])
    state.inertia = np.array([8.0, 0.0])
    state.sites = sites([0, 2, 3], [2.0, 2.0, 2.0], [[-1, 0], [1, 0], [0, 0]])
    state.turn_sites()
    return state


def spring():
    """Two sites of mass 1 and 3 at (0, 0) and (4, 0): the centre of mass at (3, 0) moves with (1, 2).

    About it, I = 1 * 9 + 3 * 1 = 12; velocities (3, -3) and (-1, 1) make L = 9 + 3 = 12, and K = 9 + 3 = 12: half of it
    rotation, half vibration.
    """
    state = gas([[1.0, 2.0]], mass=[4.0], position=[[3.0, 0.0]])
    state.angle, state.angular_velocity, state.inertia = np.zeros(1), np.ones(1), np.full(1, 99.0)
    state.sites = sites(
        [0, 2], [1.0, 3.0], [[-3, 0], [1, 0]], [[0, 0], [4, 0]], [[4.0, -1.0], [0.0, 3.0]], [True]
    )
    return state


def rods(angle, position=None, turning=None, time=0.0):
    """Dumbbells of mass 2 and moment of inertia 2 turned by these angles."""
    angle = np.array(angle, float)
    count = angle.size
    state = gas(np.zeros((count, 2)), mass=np.full(count, 2.0), position=position, time=time)
    state.angle, state.inertia = angle, np.full(count, 2.0)
    state.angular_velocity = np.zeros(count) if turning is None else np.array(turning, float)
    ends = np.tile([[-0.5, 0.0], [0.5, 0.0]], (count, 1))
    state.sites = sites(np.arange(count + 1) * 2, np.ones(2 * count), ends)
    state.turn_sites()
    return state
