"""The wire format, twin of ``frontend/core/protocol.js``.

Two kinds of message go to the browser:

- *binary*: a frame. Frames may be dropped, so they never carry state: each one can be drawn by itself.
- *text*: JSON with a ``kind``. Text is never dropped and always arrives before the frames that rely on it.

A frame, little endian (offset, type, meaning):

====== ====== ==============================================================================
0      u8     version of the format
1      u8     flags: 1 highlight bits follow, 2 a disc is followed, 4 playing
2      u16    length of this header; the arrays begin there
4      u32    generation of the table that this frame relies on
8      u32    frame number
12     u32    n, number of discs
16     f64    time [time]
24     f32 2  width and height of the container [length]
32     u32    row of the followed disc
36     u32    id of the followed disc
40     f32 4  its x, y [length], its velocity x, y [length/time]
56     f32    temperature of the gas, for the colours of thermal walls; 0 if there is none [energy]
60     u32    m, number of walls; 0 if none moves
64     -      m f32 displacements of the walls [length], n * 2 f32 positions, n * u8 species,
              ceil(n / 8) u8 highlight bits (bit 0 first)
====== ====== ==============================================================================

A species fits into a byte because a scenario has at most 250.

The text of kind ``table`` has a ``generation`` and what stays the same from frame to frame, as they are at the start,
before walls are displaced:

- ``container``: ``shape`` (rectangle, circle, polygon), ``width`` and ``height`` of the box around it, ``periodic``
  [x, y], and the ``radius`` of a circle or the ``vertices`` of a polygon, counter-clockwise;
- ``walls``, in the order of their indices: ``name``; ``line``: solid, dashed (open), dotted (somebody passes);
  ``way``: forward or backward, if they pass one way only; ``temperature`` of a thermal wall or null; ``present``;
  ``motion``: null, driven or piston; ``handle``, if it can be dragged; of those two kinds the ``normal`` along which
  they move; of one that moves its ``reach``, displacements between which it will be as far as can be told;
- ``obstacles``: index of the ``wall``, ``shape`` (segment, polygon, disc), and ``start`` and ``end``, ``vertices``, or
  ``center`` and ``radius``;
- ``gravity`` [x, y];
- ``species``: ``name``, ``radius``, ``color``.

From the browser comes JSON text only: ``{"ack": frames received, "drawn": frames drawn}``, ``{"hidden": bool}``,
``{"drag": index of a wall, "to": displacement}``, ``{"drop": index of a wall}``.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.outline import outline
from gasbox.app.sample import Followed
from gasbox.geometry import Geometry

__all__ = ["VERSION", "WireFrame", "decode_frame", "encode_frame", "notice", "table"]

VERSION: Final = 2

_HEADER: Final = struct.Struct("<BBHIIIdffIIfffffI")
_HIGHLIGHT, _FOLLOWED, _PLAYING = 1, 2, 4


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


def encode_frame(frame: WireFrame) -> bytes:
    """The bytes of one frame."""
    flags = _PLAYING if frame.playing else 0
    tail: tuple[float, ...] = (0, 0, 0.0, 0.0, 0.0, 0.0)
    if frame.highlight is not None:
        flags |= _HIGHLIGHT
    if frame.followed is not None:
        flags |= _FOLLOWED
        tail = (frame.row, frame.followed.id, *frame.followed.position, *frame.followed.velocity)
    count = frame.species.shape[0]
    head = _HEADER.pack(
        VERSION, flags, _HEADER.size, frame.generation, frame.number & 0xFFFFFFFF, count,
        frame.time, frame.width, frame.height, *tail, frame.temperature, frame.displacement.size,
    )  # fmt: skip
    parts = [
        head,
        frame.displacement.astype("<f4").tobytes(),
        frame.position.astype("<f4").tobytes(),
        frame.species.astype("u1").tobytes(),
    ]
    if frame.highlight is not None:
        parts.append(np.packbits(frame.highlight, bitorder="little").tobytes())
    return b"".join(parts)


def decode_frame(message: bytes) -> WireFrame:
    """The frame in a binary message.

    Raises
    ------
    ValueError
        It is not a frame of this version, or it is cut short.
    """
    if len(message) < _HEADER.size or message[0] != VERSION:
        raise ValueError(f"not a frame of version {VERSION}")
    (
        _,
        flags,
        header,
        generation,
        number,
        count,
        time,
        width,
        height,
        row,
        disc,
        x,
        y,
        vx,
        vy,
        warmth,
        walls,
    ) = _HEADER.unpack_from(message)
    bits = (count + 7) // 8 if flags & _HIGHLIGHT else 0
    start = header + 4 * walls
    if len(message) != start + 9 * count + bits:
        raise ValueError(f"a frame of {count} discs has {start + 9 * count + bits} bytes, not {len(message)}")
    displacement = np.frombuffer(message, "<f4", walls, header)
    position = np.frombuffer(message, "<f4", 2 * count, start).reshape(count, 2)
    species = np.frombuffer(message, "u1", count, start + 8 * count)
    packed = np.frombuffer(message, "u1", bits, start + 9 * count)
    highlight = np.unpackbits(packed, count=count, bitorder="little").astype(bool) if bits else None
    if flags & _HIGHLIGHT and highlight is None:
        highlight = np.zeros(0, dtype=bool)
    followed = None
    if flags & _FOLLOWED:
        kind = int(species[row]) if row < count else 0
        followed = Followed(disc, kind, (x, y), (vx, vy))
    return WireFrame(
        generation,
        number,
        time,
        width,
        height,
        bool(flags & _PLAYING),
        position,
        species,
        highlight,
        followed,
        row,
        warmth,
        displacement,
    )


def table(
    generation: int, geometry: Geometry, names: list[str], radii: list[float], colors: list[str]
) -> str:
    """The text message with what stays the same from frame to frame: the surroundings and the species."""
    return notice(
        "table",
        generation=generation,
        **outline(geometry),
        species=[
            {"name": name, "radius": radius, "color": color}
            for name, radius, color in zip(names, radii, colors, strict=True)
        ],
    )


def notice(kind: str, **fields: Any) -> str:
    """A text message of any kind: ``table``, ``preparing``, ``busy``, ``gone``, ``trouble``."""
    return json.dumps({"kind": kind, **fields}, separators=(",", ":"))
