"""Both renderers draw people who are but points, and what there is of an epidemic over them: pixels are read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from drawn_box import BOTH, LIGHT_BOX, boxes
from frame_server import FrameServer, running
from people import People, epidemic
from playwright.sync_api import Browser

pytestmark = pytest.mark.browser
SUSCEPTIBLE = (0x3D, 0x8F, 0xD1)


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running(simulate=People) as one:
        yield one


@pytest.fixture
def show(browser: Browser, server: FrameServer) -> Iterator[Any]:
    with boxes(browser, server) as opened:
        yield opened.shown  # type: ignore[attr-defined]


@BOTH
def test_people_are_seen_however_small(show: Any, renderer: str) -> None:
    box = show(renderer, epidemic(40, radius=1e-4), 40)
    places = box.session.show.simulation.state.position[box.session.show.simulation.state.species == 0]
    image = box.screenshot()
    found = 0
    for x, y in places[:20].tolist():
        px, py = box.place(x, y)
        patch = image[int(py) - 1 : int(py) + 2, int(px) - 1 : int(px) + 2].reshape(-1, 3)
        found += bool(patch.size and np.abs(patch - np.array(SUSCEPTIBLE)).max(axis=1).min() < 60)
    assert found >= 15  # some lie under rings and names


@BOTH
def test_rooms_quarantine_rings_and_the_day_are_drawn(show: Any, renderer: str) -> None:
    box = show(renderer, epidemic(20), 20)
    bare, view = box.screenshot(), box.session.show.simulation.world.view()
    assert_inked(bare, box, *view["rooms"][0][2:])
    assert_inked(bare, box, *view["central"][0][:2])
    # This corner lies inside the container, away from all rooms: nothing else is drawn there.
    assert_inked(bare, box, *view["quarantine"][:2])
    x, y, _ = min(view["rings"], key=lambda ring: ring[2])
    assert_inked(bare, box, x, y, reach=16)
    assert box.page.evaluate("lab.world.world.view.day") == 0.0
    assert box.page.evaluate("gasboxStats.errors") == 0


def assert_inked(image: Any, box: Any, x: float, y: float, reach: int = 3) -> None:
    """Something is drawn near a place of the box."""
    px, py = (int(part) for part in box.place(x, y))
    patch = image[max(py - reach, 0) : py + reach + 1, max(px - reach, 0) : px + reach + 1]
    assert np.abs(patch - np.array(LIGHT_BOX)).max() > 60, (x, y)


WORDS = """() => new Promise((done) => {
  const said = [];
  const { prototype } = CanvasRenderingContext2D;
  const write = prototype.fillText;
  prototype.fillText = function (text, x, y) {
    const wide = this.measureText(text).width;
    const { a, b, c, d, e, f } = this.getTransform();
    const ends = [-0.5, 0.5].map((part) => [a * part * wide + c * y + e, b * part * wide + d * y + f]);
    said.push([text, ...ends[0], ...ends[1]]);
    write.call(this, text, x, y);
  };
  lab.schedule();
  requestAnimationFrame(() => requestAnimationFrame(() => {
    prototype.fillText = write;
    done([said, lab.view.width, lab.view.height]);
  }));
})"""


@BOTH
def test_words_are_not_cut_off_and_a_name_is_no_wider_than_its_room(show: Any, renderer: str) -> None:
    box = show(renderer, epidemic(20), 20)
    (words, width, height), view = box.page.evaluate(WORDS), box.session.show.simulation.world.view()
    assert len(words) >= 2
    for text, x0, y0, x1, y1 in words:
        assert 0 <= min(x0, x1) <= max(x0, x1) <= width, text
        assert 0 <= min(y0, y1) <= max(y0, y1) <= height, text
    (x0, y0, x1, y1) = next(one[1:] for one in words if one[0] == "quarantine")
    left, _, right, _ = (box.place(x, 0.0)[0] for x in view["quarantine"])
    assert left - 1 <= min(x0, x1) <= max(x0, x1) <= right + 1
