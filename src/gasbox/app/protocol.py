"""The wire format, twin of ``frontend/core/protocol.js``.

Two kinds of message go to the browser:

- *binary*: a frame. Frames may be dropped, so they never carry state: each one can be drawn by itself.
- *text*: JSON with a ``kind``. Text is never dropped and always arrives before the frames that rely on it.

A frame, little endian (offset, type, meaning):

====== ====== ==============================================================================
0      u8     version of the format
1      u8     flags: 1 highlight bits follow, 2 a disc is followed, 4 playing, 8 neighbours are joined by lines
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
64     u8     what colours say: 0 species, 1 phase, 2 neighbours, 3 speed; three bytes of nothing after it
68     -      m f32 displacements of the walls [length], n * 2 f32 positions, n * u8 species,
              n * u8 shades unless colours say the species, ceil(n / 8) u8 highlight bits (bit 0 first)
====== ====== ==============================================================================

A species fits into a byte because a scenario has at most 250. A shade is 0 gas, 1 liquid, 2 solid; or 0 to 7
neighbours, 7 for more; or from 0 at rest to 255 for the fastest (`gasbox.app.shading`).

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
- ``species``: ``name``, ``radius``, ``color``, and ``reach``: two discs are neighbours up to the mean of theirs.

From the browser comes JSON text only: ``{"ack": frames received, "drawn": frames drawn}``, ``{"hidden": bool}``,
``{"drag": index of a wall, "to": displacement}``, ``{"drop": index of a wall}``.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.look import COLORINGS, REACH, Coloring, size_of
from gasbox.app.outline import outline
from gasbox.app.sample import Followed
from gasbox.geometry import Geometry
from gasbox.scenario import Species

__all__ = ["VERSION", "WireFrame", "decode_frame", "encode_frame", "notice", "table"]

VERSION: Final = 3

_HEADER: Final = struct.Struct("<BBHIIIdffIIfffffIBxxx")
_HIGHLIGHT, _FOLLOWED, _PLAYING, _BONDS = 1, 2, 4, 8


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


def encode_frame(frame: WireFrame) -> bytes:
    """The bytes of one frame."""
    flags = (_PLAYING if frame.playing else 0) | (_BONDS if frame.bonds else 0)
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
        COLORINGS.index("species" if frame.shades is None else frame.coloring),
    )  # fmt: skip
    parts = [
        head,
        frame.displacement.astype("<f4").tobytes(),
        frame.position.astype("<f4").tobytes(),
        frame.species.astype("u1").tobytes(),
    ]
    if frame.shades is not None:
        parts.append(frame.shades.astype("u1").tobytes())
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
        coloring,
    ) = _HEADER.unpack_from(message)
    bits = (count + 7) // 8 if flags & _HIGHLIGHT else 0
    start = header + 4 * walls
    tail_at = start + (10 if coloring else 9) * count
    if len(message) != tail_at + bits:
        raise ValueError(f"a frame of {count} discs has {tail_at + bits} bytes, not {len(message)}")
    displacement = np.frombuffer(message, "<f4", walls, header)
    position = np.frombuffer(message, "<f4", 2 * count, start).reshape(count, 2)
    species = np.frombuffer(message, "u1", count, start + 8 * count)
    shades = np.frombuffer(message, "u1", count, start + 9 * count) if coloring else None
    packed = np.frombuffer(message, "u1", bits, tail_at)
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
        COLORINGS[coloring],
        shades,
        bool(flags & _BONDS),
    )


def table(generation: int, geometry: Geometry, species: Sequence[Species], *, handles: bool = True) -> str:
    """The text message with what stays the same from frame to frame: the surroundings and the species."""
    return notice(
        "table",
        generation=generation,
        **outline(geometry, handles=handles),
        species=[
            {
                "name": one.name,
                "radius": float(one.radius),
                "color": str(one.color),
                "reach": REACH * size_of(one),
            }
            for one in species
        ],
    )


def notice(kind: str, **fields: Any) -> str:
    """A text message of any kind: ``table``, ``preparing``, ``busy``, ``gone``, ``trouble``."""
    return json.dumps({"kind": kind, **fields}, separators=(",", ":"))
