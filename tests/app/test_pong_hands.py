"""Who moves which bat: keys, mouse and fingers, and what goes out; tones of the game."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from frame_server import FrameServer, running
from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.browser

HANDS = """async ([players, deeds]) => {
  const { Hands } = await import("/core/worlds/pong_hands.js");
  const sent = [];
  const hands = new Hands((name, value) => sent.push([name, value]), () => sent.push("tap"));
  const bats = { left: { low: 10, high: 90 }, right: { low: 20, high: 80 } };
  hands.know(players, bats);
  hands.outbox.nextFrame = (call) => { hands.beat = call; };
  const took = deeds.map(([deed, ...said]) => {
    if (deed === "frame") return hands.beat?.();
    if (deed === "know") return hands.know(said[0], bats);
    if (deed === "key") return hands.key(...said);
    if (deed === "release") return hands.release();
    const [x, y, event] = said;
    const usual = { pointerId: 1, pointerType: "mouse", clientX: x, clientY: y, timeStamp: 0 };
    return hands.pointer(x, y, { ...usual, ...event }, 80);
  });
  return [sent, took.map((one) => one ?? null)];
}"""
BOTH = {"left": "human", "right": "human"}
LEFT = {"left": "human", "right": "hard"}
NOBODY = {"left": "easy", "right": "hard"}
FRAME = ("frame",)


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with running() as server:
        yield opened(browser, server)


def opened(browser: Browser, server: FrameServer) -> Page:
    one = browser.new_page()
    one.goto(f"http://127.0.0.1:{server.port}/")
    return one


def played(page: Page, players: dict[str, str], *deeds: tuple[Any, ...]) -> list[Any]:
    sent: list[Any] = page.evaluate(HANDS, [players, deeds])[0]
    return sent


def took(page: Page, players: dict[str, str], *deeds: tuple[Any, ...]) -> list[Any]:
    found: list[Any] = page.evaluate(HANDS, [players, deeds])[1]
    return found


def test_each_has_a_pair_of_keys(page: Page) -> None:
    assert played(page, BOTH, ("key", "w", True), FRAME, ("key", "arrowdown", True)) == [
        ["left_push", 1],
        ["right_push", -1],
    ]


def test_a_single_human_has_all_keys(page: Page) -> None:
    assert played(page, LEFT, ("key", "arrowup", True), FRAME, ("key", "arrowup", False)) == [
        ["left_push", 1],
        ["left_push", 0],
    ]


def test_of_two_keys_the_newer_counts(page: Page) -> None:
    down = [("key", "w", True), FRAME, ("key", "s", True), FRAME, ("key", "s", False), FRAME]
    assert played(page, LEFT, *down, ("release",)) == [["left_push", way] for way in (1, -1, 1, 0)]


def test_a_key_that_repeats_says_nothing_new(page: Page) -> None:
    assert played(page, LEFT, ("key", "w", True, False), FRAME, ("key", "w", True, True), FRAME) == [
        ["left_push", 1]
    ]


def test_without_a_human_nothing_is_taken(page: Page) -> None:
    assert took(page, NOBODY, ("key", "w", True), ("point", 10, 50, {"type": "pointermove"})) == [
        False,
        False,
    ]


def test_once_per_frame_and_the_newest_counts(page: Page) -> None:
    moves = [("point", 10, y, {"type": "pointermove"}) for y in (30, 40, 50)]
    assert played(page, LEFT, *moves, FRAME, FRAME, ("point", 10, 50, {"type": "pointermove"})) == [
        ["left_target", 30],
        ["left_target", 50],
    ]


def test_a_mouse_moves_the_bat_of_its_half_and_no_farther_than_it_goes(page: Page) -> None:
    moves = [("point", 10, 500, {"type": "pointermove"}), FRAME, ("point", 100, 0, {"type": "pointermove"})]
    assert played(page, BOTH, *moves) == [["left_target", 90], ["right_target", 20]]


def test_two_fingers_move_two_bats(page: Page) -> None:
    finger = {"pointerType": "touch"}
    first, second = {**finger, "pointerId": 1}, {**finger, "pointerId": 2}
    deeds = [
        ("point", 10, 30, {**first, "type": "pointerdown"}),
        FRAME,
        ("point", 150, 40, {**second, "type": "pointerdown"}),
        FRAME,
        ("point", 100, 50, {**first, "type": "pointermove"}),  # beyond the middle it keeps its bat
        FRAME,
        ("point", 150, 60, {**second, "type": "pointerup", "timeStamp": 900}),
        ("point", 150, 70, {**second, "type": "pointermove"}),
    ]
    assert played(page, BOTH, *deeds) == [["left_target", 30], ["right_target", 40], ["left_target", 50]]


def test_a_tap_is_short_and_stays(page: Page) -> None:
    down = ("point", 10, 30, {"type": "pointerdown"})
    up = {"type": "pointerup"}
    for where, when, taps in ((32, 100, 1), (60, 100, 0), (30, 900, 0)):
        deeds = [down, ("point", 10, where, {**up, "timeStamp": when})]
        assert played(page, LEFT, *deeds).count("tap") == taps


def test_a_player_who_leaves_lets_go(page: Page) -> None:
    assert played(page, LEFT, ("key", "w", True), FRAME, ("know", NOBODY), ("know", LEFT), FRAME) == [
        ["left_push", 1],
        ["left_push", 0],
    ]


SOUNDS = """async (counts) => {
  const { Sounds } = await import("/core/worlds/sounds.js");
  localStorage.setItem("gasbox-sound", "off");
  const sounds = new Sounds();
  const played = [];
  sounds.play = (kind) => played.push(kind);
  for (const one of counts) sounds.hear(one);
  const off = sounds.on;
  sounds.toggle();
  const kept = localStorage.getItem("gasbox-sound");
  sounds.destroy();
  return [off, kept, new Sounds().on, played];
}"""


def test_what_has_grown_is_heard_and_the_choice_is_kept(page: Page) -> None:
    counts = [{"paddle": 3}, {"paddle": 4}, {"paddle": 4, "goal": 1}, {"paddle": 0, "goal": 0}, {"wall": 2}]
    off, kept, next_time, heard = page.evaluate(SOUNDS, counts)
    assert (off, kept, next_time) == (False, "on", True)
    assert heard[:3] == ["paddle", "goal", "wall"]


def test_a_mouse_that_was_let_go_outside_holds_no_bat(page: Page) -> None:
    passing = {"type": "pointermove", "buttons": 0}
    deeds = [("point", 10, 30, {"type": "pointerdown", "buttons": 1}), FRAME, ("point", 150, 40, passing)]
    assert played(page, BOTH, *deeds)[-1] == ["right_target", 40]
    held = ("point", 150, 40, {**passing, "buttons": 1})
    assert played(page, BOTH, *deeds[:2], held)[-1] == ["left_target", 40]
