"""What is written over the court of pong."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from frame_server import running
from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.browser

# Each text that is drawn, with the middle of it as a share of the court.
DRAW = """async (state) => {
  const { drawBoard } = await import("/core/worlds/pong_board.js");
  const { View } = await import("/core/view.js");
  const view = new View();
  view.resize(812, 512, 1);
  view.setRoom([0, 0, 160, 100], false);
  const context = document.createElement("canvas").getContext("2d");
  const texts = [];
  context.fillText = (text, px, py) => {
    const [x, y] = view.toBox(px, py);
    texts.push([text, x / 160, y / 100]);
  };
  const theme = { box: [255, 255, 255], ring: "#111111", obstacle: "#333333" };
  drawBoard(context, { table: { width: 160, height: 100 }, view, theme }, state);
  return texts;
}"""
VIEW = {
    "score": [3, 10],
    "points": 11,
    "phase": "play",
    "winner": None,
    "players": {"left": "human", "right": "hard"},
}
STATE = {"time": 7.0, "paused": False, "touch": False, "humans": ["left"], "moved": True}


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with running() as server:
        one = browser.new_page()
        one.goto(f"http://127.0.0.1:{server.port}/")
        yield one


def drawn(page: Page, state: dict[str, Any] | None = None, **view: Any) -> list[Any]:
    texts: list[Any] = page.evaluate(DRAW, {**STATE, **(state or {}), "view": {**VIEW, **view}})
    return texts


def said(page: Page, state: dict[str, Any] | None = None, **view: Any) -> list[str]:
    """All but the score."""
    return [text for text, _, _ in drawn(page, state, **view)][2:]


def test_the_score_stands_at_the_top_of_each_half(page: Page) -> None:
    (left, x, y), (right, u, v) = drawn(page)
    assert (left, right) == ("3", "10")
    assert (x, u) == (pytest.approx(0.25), pytest.approx(0.75))
    assert 0.8 < y < 0.95
    assert y == v


def test_who_plays_alone_sees_bricks_and_balls(page: Page) -> None:
    texts = [
        text for text, _, _ in drawn(page, players={"left": "human", "right": None}, score=[4, 2], points=3)
    ]
    assert texts == ["4", "1 ball left"]


@pytest.mark.parametrize(
    ("state", "view", "words"),
    [
        ({}, {"phase": "serve", "serve_at": 7.44}, ["Serve in 0.4", "Space serves at once"]),
        ({"touch": True}, {"phase": "serve"}, ["Get ready", "Tap to serve"]),
        ({"humans": []}, {"phase": "serve"}, ["Get ready"]),
        ({"paused": True}, {}, ["Paused", "P or Space goes on"]),
        ({"paused": True}, {"score": [0, 0], "last": None}, ["Ready?", "Space starts"]),
        ({}, {"phase": "over", "winner": "left"}, ["You win", "Space or Enter: new game"]),
        ({}, {"phase": "over", "winner": "right"}, ["The computer wins", "Space or Enter: new game"]),
        (
            {"humans": ["left", "right"]},
            {"phase": "over", "winner": "right"},
            ["Right wins", "Space or Enter: new game"],
        ),
        ({}, {"phase": "over", "winner": None}, ["A draw", "Space or Enter: new game"]),
        ({}, {}, []),
    ],
)
def test_what_is_to_be_done(page: Page, state: Any, view: Any, words: list[str]) -> None:
    assert said(page, state, **view) == words


def test_hints_until_somebody_has_moved(page: Page) -> None:
    first = {"moved": False}
    assert said(page, first) == ["Your bat", "mouse, ↑ ↓ or W S"]
    both = said(page, {**first, "humans": ["left", "right"]})
    assert both[::2] == ["W and S", "↑ and ↓"]
    assert said(page, {**first, "touch": True}) == ["Your bat", "slide a finger here"]
