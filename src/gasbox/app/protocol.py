"""The wire format, twin of ``frontend/core/protocol.js``.

Two kinds of message go to the browser:

- *binary*: a frame. Frames may be dropped, so they never carry state: each one can be drawn by itself.
- *text*: JSON with a ``kind``. Text is never dropped and always arrives before the frames that rely on it.

A frame, little endian (offset, type, meaning):

====== ====== ==============================================================================
0      u8     version of the format
1      u8     flags: 1 highlight bits follow, 2 a particle is followed, 4 playing, 8 neighbours are joined by lines,
              16 there are molecules, 32 a particle is pointed at
2      u16    length of this header; the arrays begin there
4      u32    generation of the table that this frame relies on
8      u32    frame number
12     u32    n, number of particles
16     f64    time [time]
24     f32 2  width and height of the container [length]
32     u32    row of the followed particle
36     u32    id of the followed particle
40     f32 4  its x, y [length], its velocity x, y [length/time]
56     f32    temperature of the gas, for the colours of thermal walls; 0 if there is none [energy]
60     u32    m, number of walls; 0 if none moves
64     u8     what colours say: 0 species, 1 phase, 2 neighbours, 3 speed; three bytes of nothing after it
68     u32    s, number of discs of flexible molecules
72     u32    row of the particle that is pointed at
76     u32    its id
80     f32 5  its speed [length/time], angular velocity [rad/time], and its kinetic energies of translation, of
              rotation and of vibration [energy]; not a number where it has none
100    -      m f32 displacements of the walls [length], n * 2 f32 positions, if there are molecules n f32 angles [rad]
              and s * 2 f32 positions of the discs of flexible ones, n * u8 species,
              n * u8 shades unless colours say the species, ceil(n / 8) u8 highlight bits (bit 0 first)
====== ====== ==============================================================================

A species is a kind of particle, disc or molecule; it fits into a byte because a scenario has at most 250. A shade is
0 gas, 1 liquid, 2 solid; or 0 to 7 neighbours, 7 for more; or from 0 at rest to 255 for the fastest
(`gasbox.app.shading`).

The text of kind ``table`` has a ``generation`` and what stays the same from frame to frame, as they are at the start,
before walls are displaced:

- ``container``: ``shape`` (rectangle, circle, polygon), ``width`` and ``height`` of the box around it, ``periodic``
  [x, y], and the ``radius`` of a circle or the ``vertices`` of a polygon, counter-clockwise;
- ``walls``, in the order of their indices: ``name``; ``line``: solid, dashed (open), dotted (somebody passes);
  ``way``: forward or backward, if they pass one way only; ``temperature`` of a thermal wall or null; ``present``;
  ``motion``: null, driven or piston; ``handle``, if it can be dragged; of those two kinds the ``normal`` along which
  they move; of one that moves, unless it is a disc, its ``reach``, displacements between which it will be as far as can
  be told;
- ``obstacles``: index of the ``wall``, ``shape`` (segment, polygon, disc), and ``start`` and ``end``, ``vertices``, or
  ``center`` and ``radius``;
- ``gravity`` [x, y];
- ``species``: ``name``, ``radius``, ``color``, and ``reach``: two particles are neighbours up to the mean of theirs;
- with molecules, ``discs``: ``radius`` and ``color`` of each kind of disc; and ``bodies``, one for each species: its
  ``discs``, ``place`` [x, y] of each at angle 0, ``sticks`` [disc, disc] between them, whether it is ``flexible``, and
  whether it ``turns``.

From the browser comes JSON text only: ``{"ack": frames received, "drawn": frames drawn}``, ``{"hidden": bool}``,
``{"drag": index of a wall, "to": displacement}``, ``{"drop": index of a wall}``, ``{"point": row or null}``.
"""

from __future__ import annotations

import json
import math
import struct
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.bodies import bodies
from gasbox.app.look import COLORINGS, REACH, Coloring, sizes_of
from gasbox.app.molecule_numbers import Energies
from gasbox.app.outline import outline
from gasbox.app.sample import Followed
from gasbox.geometry import Geometry
from gasbox.scenario import Scenario

__all__ = ["VERSION", "WireFrame", "decode_frame", "encode_frame", "notice", "table"]

VERSION: Final = 4

_HEADER: Final = struct.Struct("<BBHIIIdffIIfffffIBxxxIIIfffff")
_HIGHLIGHT, _FOLLOWED, _PLAYING, _BONDS, _MOLECULES, _POINTED = 1, 2, 4, 8, 16, 32


@dataclass(frozen=True)
class WireFrame:
    """What one binary message says. The arrays may be views into the message.

    Attributes
    ----------
    position : (n, 2) float32 [length]
    species : (n,) uint8
    highlight : (n,) bool, or None if nothing is highlighted
    followed : the followed disc with its row, or None
    temperature : of the gas, 0 if there is none [energy]
    displacement : (walls,) float32 [length]; empty if no wall moves
    coloring : what the shades say
    shades : (n,) uint8, or None if `coloring` is by species
    bonds : whether neighbours are joined by lines
    angle : (n,) float32 [rad] in a gas with molecules, else None
    places : (s, 2) float32 [length], of the discs of flexible molecules, in the order of these; None without molecules
    pointed : the particle that is pointed at, with its row, or None
    """

    generation: int
    number: int
    time: float
    width: float
    height: float
    playing: bool
    position: NDArray[np.float32]
    species: NDArray[np.uint8]
    highlight: NDArray[np.bool_] | None = None
    followed: Followed | None = None
    row: int = 0
    temperature: float = 0.0
    displacement: NDArray[np.float32] = field(default_factory=lambda: np.zeros(0, np.float32))
    coloring: Coloring = "species"
    shades: NDArray[np.uint8] | None = None
    bonds: bool = False
    angle: NDArray[np.float32] | None = None
    places: NDArray[np.float32] | None = None
    pointed: Followed | None = None
    pointed_row: int = 0


def encode_frame(frame: WireFrame) -> bytes:
    """The bytes of one frame."""
    places = np.zeros((0, 2), np.float32) if frame.places is None else frame.places
    head = _HEADER.pack(
        VERSION, _flags(frame), _HEADER.size, frame.generation, frame.number & 0xFFFFFFFF, frame.species.shape[0],
        frame.time, frame.width, frame.height, *_followed(frame), frame.temperature, frame.displacement.size,
        COLORINGS.index("species" if frame.shades is None else frame.coloring), places.shape[0], *_pointed(frame),
    )  # fmt: skip
    parts = [head, frame.displacement.astype("<f4").tobytes(), frame.position.astype("<f4").tobytes()]
    if frame.angle is not None:
        parts += [frame.angle.astype("<f4").tobytes(), places.astype("<f4").tobytes()]
    parts.append(frame.species.astype("u1").tobytes())
    if frame.shades is not None:
        parts.append(frame.shades.astype("u1").tobytes())
    if frame.highlight is not None:
        parts.append(np.packbits(frame.highlight, bitorder="little").tobytes())
    return b"".join(parts)


def _flags(frame: WireFrame) -> int:
    said = {
        _HIGHLIGHT: frame.highlight is not None,
        _FOLLOWED: frame.followed is not None,
        _PLAYING: frame.playing,
        _BONDS: frame.bonds,
        _MOLECULES: frame.angle is not None,
        _POINTED: frame.pointed is not None,
    }
    return sum(flag for flag, holds in said.items() if holds)


def _followed(frame: WireFrame) -> tuple[float, ...]:
    if frame.followed is None:
        return (0, 0, 0.0, 0.0, 0.0, 0.0)
    return (frame.row, frame.followed.id, *frame.followed.position, *frame.followed.velocity)


def _pointed(frame: WireFrame) -> tuple[float, ...]:
    if frame.pointed is None:
        return (0, 0, 0.0, 0.0, 0.0, 0.0, 0.0)
    had = frame.pointed.energies or Energies(math.nan)
    parts = (had.angular_velocity, had.translational, had.rotational, had.vibrational)
    numbers = (math.nan if part is None else part for part in parts)
    return (frame.pointed_row, frame.pointed.id, frame.pointed.speed, *numbers)


def decode_frame(message: bytes) -> WireFrame:
    """The frame in a binary message, without what is pointed at.

    Raises
    ------
    ValueError
        It is not a frame of this version, or it is cut short.
    """
    if len(message) < _HEADER.size or message[0] != VERSION:
        raise ValueError(f"not a frame of version {VERSION}")
    fields = _HEADER.unpack_from(message)
    flags, header, generation, number, count, time, width, height = fields[1:9]
    row, disc, x, y, vx, vy, warmth, walls, coloring, soft = fields[9:19]
    read = _Reader(message, header)
    displacement = read.take("<f4", walls)
    position = read.take("<f4", 2 * count).reshape(count, 2)
    angle = read.take("<f4", count) if flags & _MOLECULES else None
    places = read.take("<f4", 2 * soft).reshape(soft, 2) if flags & _MOLECULES else None
    species = read.take("u1", count)
    shades = read.take("u1", count) if coloring else None
    packed = read.take("u1", (count + 7) // 8) if flags & _HIGHLIGHT else None
    read.end()
    followed = None
    if flags & _FOLLOWED:
        kind = int(species[row]) if row < count else 0
        followed = Followed(disc, kind, (x, y), (vx, vy))
    return WireFrame(
        generation=generation,
        number=number,
        time=time,
        width=width,
        height=height,
        playing=bool(flags & _PLAYING),
        position=position,
        species=species,
        highlight=None
        if packed is None
        else np.unpackbits(packed, count=count, bitorder="little").astype(bool),
        followed=followed,
        row=row,
        temperature=warmth,
        displacement=displacement,
        coloring=COLORINGS[coloring],
        shades=shades,
        bonds=bool(flags & _BONDS),
        angle=angle,
        places=places,
    )


class _Reader:
    """Takes one array after the other from a message."""

    def __init__(self, message: bytes, start: int) -> None:
        self._message, self._at = message, start

    def take(self, kind: str, count: int) -> NDArray[Any]:
        """The next so many numbers."""
        size = count * np.dtype(kind).itemsize
        if self._at + size > len(self._message):
            raise ValueError(f"a frame cut short: {len(self._message)} bytes")
        self._at += size
        return np.frombuffer(self._message, kind, count, self._at - size)

    def end(self) -> None:
        """There must be nothing after it."""
        if self._at != len(self._message):
            raise ValueError(f"a frame of {self._at} bytes, not {len(self._message)}")


def table(generation: int, geometry: Geometry, scenario: Scenario, *, handles: bool = True) -> str:
    """The text message with what stays the same from frame to frame: the surroundings and the kinds of particle."""
    return notice(
        "table",
        generation=generation,
        **outline(geometry, handles=handles),
        species=[
            {
                "name": kind.name,
                "radius": float(kind.radius),
                "color": str(kind.color),
                "reach": REACH * size,
            }
            for kind, size in zip(scenario.kinds, sizes_of(scenario), strict=True)
        ],
        **bodies(scenario),
        world=None if scenario.world is None else scenario.world.kind,
    )


def notice(kind: str, **fields: Any) -> str:
    """A text message of any kind: ``table``, ``world``, ``preparing``, ``busy``, ``gone``, ``trouble``."""
    return json.dumps({"kind": kind, **fields}, separators=(",", ":"))
