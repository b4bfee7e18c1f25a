"""Files in a real Chromium: opened by button and by dropping, refused with reasons, saved and opened again."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest
from pictures import changed, pixels
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser

Opened = Callable[..., Page]

SMALL = {
    "format": "gasbox-scenario/1",
    "title": "A small gas",
    "watch_for": "Few particles, much noise.",
    "container": {"shape": "rectangle", "width": 60, "height": 40},
    "species": [{"name": "only", "count": 50, "temperature": 0.1}],
    "dynamics": {"kind": "event-driven"},
    "frame_interval": 0.5,
}
BROKEN = {**SMALL, "species": [{"name": "only", "mass": -1, "radius": "big", "count": 50}]}
DROP = """([name, text]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([text], name, {type: "application/json"}));
  const settings = {dataTransfer: transfer, bubbles: true, cancelable: true};
  for (const type of ["dragenter", "dragover", "drop"])
    document.querySelector(".lab").dispatchEvent(new DragEvent(type, settings));
}"""


def file(data: object, name: str = "gas.json") -> dict[str, object]:
    return {"name": name, "mimeType": "application/json", "buffer": json.dumps(data).encode()}


def open_with_button(page: Page, data: object, name: str = "gas.json") -> None:
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Open").click()
    chooser.value.set_files([file(data, name)])  # type: ignore[list-item]


def test_a_good_file_is_opened_with_the_button(open_page: Opened) -> None:
    page = open_page()
    open_with_button(page, SMALL)
    page.wait_for_function("gasboxStats.count === 50")
    expect(page.get_by_text("Few particles, much noise.")).to_be_visible()
    expect(page.locator(".histogram")).to_have_count(1)
    expect(page.locator(".histogram svg text", has_text="number of particles")).to_be_visible()
    expect(page.get_by_text("A small gas")).to_be_visible()


def test_a_file_can_be_dropped_on_the_page(open_page: Opened) -> None:
    page = open_page()
    page.evaluate(DROP, ["dropped.json", json.dumps(SMALL)])
    page.wait_for_function("gasboxStats.count === 50")


def test_a_broken_file_is_explained_and_the_old_gas_goes_on(open_page: Opened) -> None:
    page = open_page()
    open_with_button(page, BROKEN, "broken.json")
    expect(page.get_by_text("broken.json can't be used")).to_be_visible()
    for text in ("species[0].mass", "species[0].radius", "-1", '"big"'):
        expect(page.locator(".dialog").get_by_text(text, exact=True).first).to_be_visible()
    drawn, time = page.evaluate("[gasboxStats.drawn, gasboxStats.time]")
    page.wait_for_function(f"gasboxStats.drawn > {drawn} && gasboxStats.time > {time}")
    assert page.evaluate("gasboxStats.count") == 2000
    page.get_by_role("button", name="Close").click()
    open_with_button(page, SMALL)
    page.wait_for_function("gasboxStats.count === 50")


def test_a_snapshot_brings_the_same_moment_back(open_page: Opened) -> None:
    page = open_page()
    page.keyboard.press(" ")
    page.wait_for_function("gasboxStats.playing === false")
    page.wait_for_timeout(400)
    time, before = page.evaluate("gasboxStats.time"), pixels(page)
    with page.expect_download() as download:
        page.keyboard.press("s")
    assert download.value.suggested_filename == "three-gases-in-a-box-snapshot.json"
    data = json.loads(download.value.path().read_text())
    assert data["snapshot"]["time"] == time
    page.keyboard.press("r")
    page.wait_for_function("gasboxStats.time === 0")
    open_with_button(page, data, "snapshot.json")
    page.wait_for_function(f"gasboxStats.time === {time}")
    page.wait_for_timeout(400)
    assert changed(before, pixels(page)) == 0
    page.keyboard.press(" ")
    page.wait_for_function(f"gasboxStats.time > {time}")


def test_the_scenario_can_be_downloaded(open_page: Opened) -> None:
    page = open_page()
    page.get_by_role("button", name="Save").click()
    with page.expect_download() as download:
        page.get_by_text("Download the scenario").click()
    assert json.loads(download.value.path().read_text())["title"] == "Three gases in a box"


def test_a_shipped_scenario_is_chosen_from_the_list(open_page: Opened) -> None:
    page = open_page()
    page.get_by_label("Scenario").click()
    page.get_by_role("option", name="Hot").click()
    expect(page.locator(".histogram")).to_have_count(2)


def test_panel_in_the_browser(open_page: Opened) -> None:
    page = open_page()
    page.get_by_role("button", name="Edit the gas").click()
    count = page.get_by_label("count").first
    count.fill("-5")
    page.get_by_role("button", name="Apply").click()
    expect(page.get_by_role("alert").filter(has_text="species[0].count")).to_be_visible()
    assert page.evaluate("gasboxStats.count") == 2000
    count.fill("500")
    page.get_by_role("button", name="Apply").click()
    page.wait_for_function("gasboxStats.count === 1500")
    expect(page.get_by_role("alert").filter(has_text="species[0].count")).to_be_hidden()
