"""The wire format in Python; `test_protocol_browser` reads the same bytes in JavaScript."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from free_flight import gas
from free_rotors import DUMBBELL, SPRING, rotors
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from gasbox.app.look import COLORINGS
from gasbox.app.molecule_numbers import Energies
from gasbox.app.protocol import WireFrame, decode_frame, encode_frame, notice, table
from gasbox.app.sample import Followed
from gasbox.geometry import Rectangle

pytestmark = pytest.mark.small


@st.composite
def wire_frames(draw: st.DrawFn) -> WireFrame:
    n = draw(st.integers(0, 40))
    small = st.floats(-1e6, 1e6, width=32)
    row = draw(st.integers(0, n - 1)) if n and draw(st.booleans()) else None
    species = draw(arrays.arrays(np.uint8, n))
    pair = st.tuples(small, small)
    coloring = draw(st.sampled_from(COLORINGS))
    return WireFrame(
        generation=draw(st.integers(0, 2**32 - 1)),
        number=draw(st.integers(0, 2**32 - 1)),
        time=draw(st.floats(allow_nan=False, allow_infinity=False)),
        width=draw(small),
        height=draw(small),
        playing=draw(st.booleans()),
        position=draw(arrays.arrays(np.float32, (n, 2), elements=small)),
        species=species,
        highlight=draw(st.none() | arrays.arrays(np.bool_, n)),
        followed=None
        if row is None
        else Followed(draw(st.integers(0, 2**32 - 1)), int(species[row]), draw(pair), draw(pair)),
        row=row or 0,
        temperature=draw(small),
        coloring=coloring,
        shades=None if coloring == "species" else draw(arrays.arrays(np.uint8, n)),
        bonds=draw(st.booleans()),
        displacement=draw(arrays.arrays(np.float32, st.integers(0, 6), elements=small)),
        **_molecules(draw, n, small),
    )


def _molecules(draw: st.DrawFn, n: int, small: st.SearchStrategy[float]) -> dict[str, Any]:
    if draw(st.booleans()):
        return {}
    soft = draw(st.integers(0, 5))
    return {
        "angle": draw(arrays.arrays(np.float32, n, elements=small)),
        "places": draw(arrays.arrays(np.float32, (soft, 2), elements=small)),
    }


@given(wire_frames())
def test_what_is_encoded_is_decoded(frame: WireFrame) -> None:
    back = decode_frame(encode_frame(frame))
    for name in (
        "generation",
        "number",
        "time",
        "width",
        "height",
        "playing",
        "followed",
        "temperature",
        "coloring",
        "bonds",
    ):
        assert getattr(back, name) == getattr(frame, name)
    np.testing.assert_array_equal(back.position, frame.position)
    np.testing.assert_array_equal(back.species, frame.species)
    np.testing.assert_array_equal(back.displacement, frame.displacement)
    for name in ("highlight", "shades", "angle", "places"):
        if getattr(frame, name) is None:
            assert getattr(back, name) is None
        else:
            np.testing.assert_array_equal(getattr(back, name), getattr(frame, name))


@given(wire_frames(), st.data())
def test_a_frame_cut_short_is_refused(frame: WireFrame, data: st.DataObject) -> None:
    message = encode_frame(frame)
    with pytest.raises(ValueError, match="frame"):
        decode_frame(message[: data.draw(st.integers(0, len(message) - 1))])


def test_another_version_is_refused() -> None:
    with pytest.raises(ValueError, match="version"):
        decode_frame(bytes([99]) + bytes(100))


def test_the_bytes_are_those_of_the_description() -> None:
    frame = WireFrame(
        generation=7,
        number=11,
        time=2.5,
        width=60.0,
        height=40.0,
        playing=True,
        position=np.array([[1, 2], [3, 4], [5, 6]], np.float32),
        species=np.array([0, 1, 2], np.uint8),
        highlight=np.array([True, False, True]),
        followed=Followed(21, 1, (3.0, 4.0), (0.5, -0.5)),
        row=1,
        temperature=0.25,
        displacement=np.array([0, -7, 0, 0], np.float32),
        coloring="neighbours",
        shades=np.array([6, 5, 7], np.uint8),
        bonds=True,
    )
    message = encode_frame(frame)
    assert message[:4] == bytes([4, 15, 100, 0])
    assert struct.unpack_from("<III", message, 4) == (7, 11, 3)
    assert struct.unpack_from("<d", message, 16) == (2.5,)
    assert struct.unpack_from("<ff", message, 24) == (60.0, 40.0)
    assert struct.unpack_from("<IIffff", message, 32) == (1, 21, 3.0, 4.0, 0.5, -0.5)
    assert struct.unpack_from("<fI", message, 56) == (0.25, 4)
    assert message[64:68] == bytes([2, 0, 0, 0])
    assert struct.unpack_from("<4f", message, 100) == (0, -7, 0, 0)
    assert struct.unpack_from("<6f", message, 116) == (1, 2, 3, 4, 5, 6)
    assert message[140:] == bytes([0, 1, 2, 6, 5, 7, 0b101])


def test_a_disc_takes_nine_bytes_and_one_more_for_a_shade() -> None:
    many = WireFrame(0, 0, 0.0, 1.0, 1.0, True, np.zeros((1000, 2), np.float32), np.zeros(1000, np.uint8))
    assert len(encode_frame(many)) == 100 + 9 * 1000
    shaded = replace(many, coloring="speed", shades=np.zeros(1000, np.uint8))
    assert len(encode_frame(shaded)) == 100 + 10 * 1000


def test_the_table_says_what_does_not_change() -> None:
    message = json.loads(table(3, Rectangle(60.0, 40.0, True, False), gas()))
    plain = {"line": "solid", "temperature": None, "motion": None, "present": True}
    assert message == {
        "kind": "table",
        "generation": 3,
        "world": None,
        "container": {"shape": "rectangle", "width": 60.0, "height": 40.0, "periodic": [True, False]},
        "walls": [{"name": name, **plain} for name in ("left", "right", "bottom", "top")],
        "obstacles": [],
        "gravity": [0.0, 0.0],
        "species": [
            {"name": "kind 0", "radius": 0.5, "color": "#ff0000", "reach": 1.5},
            {"name": "kind 1", "radius": 1.0, "color": "#00a000", "reach": 3.0},
        ],
    }


def test_molecules_add_an_angle_each_and_the_places_of_what_bends() -> None:
    frame = WireFrame(
        generation=1,
        number=2,
        time=0.0,
        width=60.0,
        height=40.0,
        playing=False,
        position=np.array([[1, 2], [3, 4]], np.float32),
        species=np.array([0, 1], np.uint8),
        angle=np.array([0.5, -0.25], np.float32),
        places=np.array([[2, 4], [4, 4]], np.float32),
        pointed=Followed(9, 1, (3.0, 4.0), (3.0, 4.0), Energies(12.5, 0.5, None, 2.0)),
        pointed_row=1,
    )
    message = encode_frame(frame)
    assert message[1] == 16 + 32
    assert struct.unpack_from("<IIIff", message, 68) == (2, 1, 9, 5.0, 2.0)
    assert struct.unpack_from("<ff", message, 88) == (12.5, 0.5)
    assert np.isnan(struct.unpack_from("<f", message, 96)[0])
    assert struct.unpack_from("<10f", message, 100) == (1, 2, 3, 4, 0.5, -0.25, 2, 4, 4, 4)
    assert message[140:] == bytes([0, 1])


def test_the_table_says_of_what_discs_molecules_are_made() -> None:
    argon = {"name": "argon", "radius": 2.0, "color": "#7b4fb5"}
    scenario = rotors(DUMBBELL, SPRING, species=(argon,), dynamics={"kind": "forced"})
    message = json.loads(table(3, Rectangle(60.0, 40.0, True, False), scenario))
    assert [one["name"] for one in message["species"]] == ["argon", "molecule 0", "molecule 1"]
    assert message["species"][1]["radius"] == 3.5
    assert [one["color"] for one in message["discs"]] == ["#7b4fb5", "#0000ff", "#00a000", "#c86dd7"]
    assert message["bodies"] == [
        {"discs": [0], "place": [[0, 0]], "sticks": [], "flexible": False, "turns": False},
        {"discs": [1, 2], "place": [[-2, 0], [2, 0]], "sticks": [[0, 1]], "flexible": False, "turns": True},
        {
            "discs": [3, 3],
            "place": [[-1.5, 0], [1.5, 0]],
            "sticks": [[0, 1]],
            "flexible": True,
            "turns": True,
        },
    ]


def test_notices_are_json_with_a_kind() -> None:
    assert json.loads(notice("busy", text="full")) == {"kind": "busy", "text": "full"}
