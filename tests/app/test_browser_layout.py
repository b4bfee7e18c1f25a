"""Where things are on the page: nothing overlaps, nothing is cut off, at the sizes that people use."""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser

Opened = Callable[..., Page]
PARTS = (".lab-bar", ".caption", ".box", ".transport", ".readings", ".chart-settings", ".histogram")


CUT_OFF = """[...document.querySelectorAll(".histogram svg")].flatMap((chart) => {
  const frame = chart.getBoundingClientRect();
  return [...chart.querySelectorAll("text")].filter((text) => {
    const box = text.getBoundingClientRect();
    return box.left < frame.left - 0.5 || box.right > frame.right + 0.5
      || box.top < frame.top - 0.5 || box.bottom > frame.bottom + 0.5;
  }).map((text) => text.textContent);
})"""


def boxes(page: Page) -> dict[str, dict[str, float]]:
    found: dict[str, Any] = {}
    for selector in PARTS:
        for index, part in enumerate(page.locator(selector).all()):
            found[f"{selector} {index}"] = part.bounding_box()
    return found


def assert_apart(parts: dict[str, dict[str, float]]) -> None:
    for (name, a), (other, b) in itertools.combinations(parts.items(), 2):
        across = min(a["x"] + a["width"], b["x"] + b["width"]) - max(a["x"], b["x"])
        along = min(a["y"] + a["height"], b["y"] + b["height"]) - max(a["y"], b["y"])
        assert across <= 0.5 or along <= 0.5, f"{name} and {other} overlap"


def species(count: int) -> str:
    return json.dumps(
        {
            "format": "gasbox-scenario/1",
            "title": "Many",
            "container": {"shape": "rectangle", "width": 200, "height": 150},
            "species": [{"name": f"kind {i}", "count": 40, "temperature": 0.1} for i in range(count)],
            "dynamics": {"kind": "event-driven"},
        }
    )


def load(page: Page, text: str, count: int) -> None:
    page.set_input_files(
        "input[type=file]",
        files=[{"name": "many.json", "mimeType": "application/json", "buffer": text.encode()}],
    )
    expect(page.locator(".histogram")).to_have_count(count)
    expect(page.locator(".histogram svg")).to_have_count(count)


def test_all_is_seen_at_once_on_a_desk(open_page: Opened) -> None:
    page = open_page(size=(1280, 720))
    parts = boxes(page)
    assert_apart(parts)
    for name, part in parts.items():
        assert part["x"] >= 0, name
        assert part["y"] >= 0, name
        assert part["x"] + part["width"] <= 1280, name
        assert part["y"] + part["height"] <= 720, name
    assert parts[".box 0"]["width"] * parts[".box 0"]["height"] > 0.3 * 1280 * 720
    assert page.evaluate(
        "[document.scrollingElement.scrollWidth, document.scrollingElement.scrollHeight]"
    ) == [1280, 720]


@pytest.mark.parametrize("count", [1, 2, 4, 6])
def test_one_to_six_species_have_room(open_page: Opened, count: int) -> None:
    page = open_page(size=(1280, 720))
    load(page, species(count), count)
    page.wait_for_timeout(500)
    parts = boxes(page)
    assert_apart(parts)
    for name, part in parts.items():
        assert part["y"] + part["height"] <= 720, name
        assert part["x"] + part["width"] <= 1280, name
        if name.startswith(".histogram"):
            assert part["width"] > 250
            assert part["height"] > 150


def test_the_open_panel_covers_nothing_on_a_desk(open_page: Opened) -> None:
    page = open_page(size=(1280, 720))
    page.keyboard.press("e")
    expect(page.get_by_role("button", name="Apply")).to_be_visible()
    page.wait_for_timeout(600)
    assert_apart({**boxes(page), "panel": page.locator(".panel").bounding_box() or {}})


def test_a_phone_has_the_box_on_top_and_the_rest_in_a_scroll(open_page: Opened) -> None:
    page = open_page(size=(390, 844), has_touch=True, is_mobile=True)
    parts = boxes(page)
    parts = {name: part for name, part in parts.items() if not name.startswith(".transport")}
    assert_apart(parts)
    for name, part in parts.items():
        assert part["x"] >= 0, name
        assert part["x"] + part["width"] <= 390, name
    assert parts[".box 0"]["y"] < 200
    assert parts[".histogram 0"]["y"] > parts[".box 0"]["y"]
    assert page.evaluate("document.scrollingElement.scrollWidth") == 390
    page.evaluate("scrollTo(0, 1e6)")
    page.wait_for_timeout(300)
    transport = page.locator(".transport").bounding_box()
    assert transport is not None
    assert 0 <= transport["y"] <= 844 - transport["height"]


def test_controls_of_a_phone_fit(open_page: Opened) -> None:
    page = open_page(size=(390, 844), has_touch=True, is_mobile=True)
    edge = page.locator(".transport").bounding_box()
    assert edge is not None
    for control in page.locator(".transport > *").all():
        box = control.bounding_box()
        if box is not None and box["width"] > 0:
            assert edge["x"] <= box["x"]
            assert box["x"] + box["width"] <= edge["x"] + edge["width"]


def test_labels_of_axes_are_not_cut_off(open_page: Opened) -> None:
    page = open_page(size=(1280, 720))
    assert page.evaluate(CUT_OFF) == []


def test_focus_can_be_seen(open_page: Opened) -> None:
    page = open_page()
    page.get_by_role("button", name="Pause", exact=True).focus()
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.ariaLabel") == "One frame"
    assert page.evaluate("getComputedStyle(document.activeElement).outlineStyle") == "solid"
    assert page.evaluate("getComputedStyle(document.activeElement).outlineWidth") == "2px"
