"""What Python encodes, JavaScript decodes."""

from __future__ import annotations

import base64
from collections.abc import Iterator

import numpy as np
import pytest
from frame_server import FrameServer, running
from free_flight import gas
from playwright.sync_api import Browser, Page

from gasbox.app.molecule_numbers import Energies
from gasbox.app.protocol import WireFrame, encode_frame, table
from gasbox.app.sample import Followed
from gasbox.geometry import Enclosure, Polygon, Post, Rectangle, Segment, Wall

pytestmark = pytest.mark.browser

DECODE = """async (text) => {
  const { decodeFrame } = await import("/core/protocol.js");
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const frame = decodeFrame(bytes.buffer);
  const arrays = ["position", "species", "shades", "highlight", "displacement", "angle", "places"];
  for (const key of arrays) frame[key] &&= Array.from(frame[key]);
  return frame;
}"""


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running() as one:
        yield one


@pytest.fixture(scope="module")
def page(browser: Browser, server: FrameServer) -> Page:
    one = browser.new_page()
    one.goto(f"http://127.0.0.1:{server.port}/")
    return one


def decoded(page: Page, message: bytes) -> dict[str, object]:
    return page.evaluate(DECODE, base64.b64encode(message).decode())


@pytest.mark.parametrize("count", [0, 1, 7, 8, 9, 1000])
def test_frames_of_any_length(page: Page, count: int) -> None:
    random = np.random.default_rng(count)
    frame = WireFrame(
        generation=4_000_000_000,
        number=17,
        time=1234.5678,
        width=60.5,
        height=40.25,
        playing=True,
        position=random.random((count, 2), np.float32) * 100,
        species=random.integers(0, 256, count, np.uint8),
        highlight=random.random(count) < 0.5,
        followed=Followed(3_000_000_000, 0, (1.5, 2.5), (-0.5, 0.25)),
        row=0,
        temperature=0.75,
        displacement=np.array([0.5, -2.0], np.float32),
        coloring="speed",
        shades=random.integers(0, 256, count, np.uint8),
        bonds=True,
        angle=random.random(count, np.float32),
        places=np.array([[1, 2], [3, 4]], np.float32),
        pointed=Followed(7, 0, (0.0, 0.0), (3.0, 4.0), Energies(12.5, 0.5, 0.25, -2.0)),
    )
    seen = decoded(page, encode_frame(frame))
    assert seen == {
        "generation": 4_000_000_000,
        "number": 17,
        "count": count,
        "time": 1234.5678,
        "width": 60.5,
        "height": 40.25,
        "playing": True,
        "temperature": 0.75,
        "displacement": [0.5, -2.0],
        "position": frame.position.ravel().tolist(),
        "species": frame.species.tolist(),
        "coloring": 3,
        "shades": frame.shades.tolist(),  # type: ignore[union-attr]
        "bonds": True,
        "highlight": np.packbits(frame.highlight, bitorder="little").tolist(),  # type: ignore[arg-type]
        "followed": {"row": 0, "id": 3_000_000_000, "x": 1.5, "y": 2.5, "vx": -0.5, "vy": 0.25},
        "angle": frame.angle.tolist(),  # type: ignore[union-attr]
        "places": [1, 2, 3, 4],
        "pointed": {
            "row": 0,
            "id": 7,
            "speed": 5,
            "angularVelocity": -2,
            "translational": 12.5,
            "rotational": 0.5,
            "vibrational": 0.25,
        },
    }


def test_nothing_optional(page: Page) -> None:
    bare = WireFrame(1, 2, 3.0, 4.0, 5.0, False, np.zeros((1, 2), np.float32), np.zeros(1, np.uint8))
    seen = decoded(page, encode_frame(bare))
    assert (seen["playing"], seen["highlight"], seen["followed"]) == (False, None, None)
    assert (seen["coloring"], seen["shades"], seen["bonds"]) == (0, None, False)


@pytest.mark.parametrize("message", [b"", b"\x04" + bytes(55), b"\x03" + bytes(99), bytes(100)])
def test_what_is_no_frame_is_refused(page: Page, message: bytes) -> None:
    with pytest.raises(Exception, match="not a frame"):
        decoded(page, message)


def test_a_frame_cut_short_is_refused(page: Page) -> None:
    bare = WireFrame(1, 2, 3.0, 4.0, 5.0, False, np.zeros((1, 2), np.float32), np.zeros(1, np.uint8))
    with pytest.raises(Exception, match="bytes"):
        decoded(page, encode_frame(bare)[:-1])


DECODE_TABLE = """async (text) => {
  const { decodeTable } = await import("/core/protocol.js");
  const table = decodeTable(JSON.parse(text));
  return { ...table, radii: Array.from(table.radii), reaches: Array.from(table.reaches) };
}"""


def test_the_table(page: Page) -> None:
    text = table(7, Rectangle(60.0, 40.0, True, False), gas())
    seen = page.evaluate(DECODE_TABLE, text)
    wanted = {
        "generation": 7,
        "shape": "rectangle",
        "width": 60,
        "height": 40,
        "periodicX": True,
        "periodicY": False,
        "obstacles": [],
        "gravity": [0, 0],
        "names": ["kind 0", "kind 1"],
        "colors": ["#ff0000", "#00a000"],
        "radii": [0.5, 1],
        "reaches": [1.5, 3],
    }
    assert {key: seen[key] for key in wanted} == wanted
    assert [side["out"] for side in seen["sides"]] == [[-1, 0], [1, 0], [0, -1], [0, 1]]


def test_the_table_of_other_surroundings(page: Page) -> None:
    triangle = Polygon(((0.0, 0.0), (8.0, 0.0), (0.0, 6.0)))
    walls = (
        Wall("floor", temperature=2.0),
        Wall("slope", open=True),
        Wall("left"),
        Wall("door"),
        Wall("post"),
    )
    geometry = Enclosure(triangle, (Segment((1, 1), (1, 3)), Post((2, 2), 0.5)), walls, (0.0, -0.25))
    seen = page.evaluate(DECODE_TABLE, table(8, geometry, gas((1,))))
    assert (seen["shape"], seen["width"], seen["height"], seen["gravity"]) == ("polygon", 8, 6, [0, -0.25])
    assert [side["wall"]["name"] for side in seen["sides"]] == ["floor", "slope", "left"]
    assert seen["sides"][1]["out"] == pytest.approx([0.6, 0.8])
    assert [side["wall"]["line"] for side in seen["sides"]] == ["solid", "dashed", "solid"]
    assert seen["sides"][0]["wall"]["temperature"] == 2
    assert [line["wall"]["name"] for line in seen["lines"]] == ["door"]
    assert [block["wall"]["name"] for block in seen["blocks"]] == ["post"]
