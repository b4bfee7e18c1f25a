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
56     -      n * 2 f32 positions, n * u8 species, ceil(n / 8) u8 highlight bits (bit 0 first)
====== ====== ==============================================================================

A species fits into a byte because a scenario has at most 250.

From the browser comes JSON text only: ``{"ack": frames received, "drawn": frames drawn}``, ``{"hidden": bool}``.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.sample import Followed
from gasbox.geometry import Rectangle

__all__ = ["VERSION", "WireFrame", "decode_frame", "encode_frame", "notice", "table"]

VERSION: Final = 1

_HEADER: Final = struct.Struct("<BBHIIIdffIIffff")
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
        frame.time, frame.width, frame.height, *tail,
    )  # fmt: skip
    parts = [head, frame.position.astype("<f4").tobytes(), frame.species.astype("u1").tobytes()]
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
    fields = _HEADER.unpack_from(message)
    _, flags, start, generation, number, count, time, width, height, row, disc, x, y, vx, vy = fields
    bits = (count + 7) // 8 if flags & _HIGHLIGHT else 0
    if len(message) != start + 9 * count + bits:
        raise ValueError(f"a frame of {count} discs has {start + 9 * count + bits} bytes, not {len(message)}")
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
    )


def table(
    generation: int, geometry: Rectangle, names: list[str], radii: list[float], colors: list[str]
) -> str:
    """The text message with what stays the same from frame to frame: the container and the species."""
    return notice(
        "table",
        generation=generation,
        container={
            "shape": "rectangle",
            "width": geometry.width,
            "height": geometry.height,
            "periodic": [bool(geometry.periodic_x), bool(geometry.periodic_y)],
        },
        species=[
            {"name": name, "radius": radius, "color": color}
            for name, radius, color in zip(names, radii, colors, strict=True)
        ],
    )


def notice(kind: str, **fields: Any) -> str:
    """A text message of any kind: ``table``, ``preparing``, ``busy``, ``gone``, ``trouble``."""
    return json.dumps({"kind": kind, **fields}, separators=(",", ":"))
