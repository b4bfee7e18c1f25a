"""Matter with forces on the page in a real Chromium: its controls, what is held down, colours and charts."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from pictures import changed, pixels
from playwright.sync_api import Locator, Page, expect
from test_browser_layout import CUT_OFF, assert_apart, boxes
from test_browser_page import pause

pytestmark = pytest.mark.browser

Opened = Callable[..., Page]
ARGON: dict[str, Any] = {
    "format": "gasbox-scenario/1",
    "title": "A crystal of argon",
    "container": {"shape": "rectangle", "width": 40, "height": 30, "periodic": ["x", "y"]},
    "species": [{"name": "argon", "radius": 0.5, "count": 300, "temperature": 0.3, "lattice": 1.12}],
    "dynamics": {"kind": "forced"},
    "units": {"name": "argon", "length": 3.405e-10, "energy": 1.654e-21, "mass": 6.634e-26},
}


def load(page: Page, **settings: Any) -> None:
    data = json.dumps(ARGON | settings).encode()
    page.set_input_files(
        "input[type=file]", files=[{"name": "argon.json", "mimeType": "application/json", "buffer": data}]
    )
    expect(page.locator(".matter")).to_be_visible(timeout=120_000)
    page.wait_for_function("gasboxStats.count === 300")


def reading(page: Page, name: str) -> Locator:
    return page.locator(".readout", has=page.get_by_text(name, exact=True)).locator(".value")


def test_heat_flows_while_a_key_or_a_button_is_down(open_page: Opened) -> None:
    page = open_page()
    load(page)
    heat = page.get_by_role("group", name="Heat").locator(".reading")
    expect(heat).to_have_text("no heating")
    before = float(reading(page, "temperature").inner_text())
    page.keyboard.down("h")
    expect(heat).to_have_text("heat +0.0330")
    expect(reading(page, "temperature")).not_to_have_text(str(before))
    page.wait_for_function(
        f"Number([...document.querySelectorAll('.readout')].find((one) =>"
        f" one.innerText.startsWith('temperature')).innerText.split('\\n')[1]) > {before} + 0.1"
    )
    page.keyboard.up("h")
    expect(heat).to_have_text("no heating")
    button = page.get_by_role("button", name="Hold to cool").bounding_box()
    assert button is not None
    page.mouse.move(button["x"] + 10, button["y"] + 10)
    page.mouse.down()
    expect(heat).to_have_text("heat \u22120.0330")
    page.mouse.move(5, 5)  # the pointer may slip off
    page.mouse.up()
    expect(heat).to_have_text("no heating")
    page.get_by_role("button", name="Hold to heat").focus()
    page.keyboard.down("Enter")
    expect(heat).to_have_text("heat +0.0330")
    page.keyboard.up("Enter")
    expect(heat).to_have_text("no heating")


def test_thermostat_and_barostat(open_page: Opened) -> None:
    page = open_page()
    load(page)
    thermostat = page.get_by_role("group", name="Thermostat")
    expect(thermostat.locator(".reading")).to_have_text("thermostat off")
    thermostat.get_by_role("button", name="Thermostat in numbers").click()
    page.get_by_label("temperature (energy)").fill("0.6")
    expect(thermostat.locator(".reading")).to_have_text("T = 0.600 · 71.9 K")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Thermostat on or off").click()
    expect(thermostat.locator(".reading")).to_have_text("thermostat off")
    barostat = page.get_by_role("group", name="Barostat")
    barostat.get_by_role("button", name="Barostat in numbers").click()
    page.get_by_label("pressure (mass/time²)").fill("2")
    expect(barostat.locator(".reading")).to_contain_text("p = 2.00")
    density = float(reading(page, "density").inner_text())
    page.wait_for_function(
        f"Number([...document.querySelectorAll('.readout')].find((one) =>"
        f" one.innerText.startsWith('density')).innerText.split('\\n')[1]) > 1.05 * {density}",
        timeout=60_000,
    )


def test_colours_with_their_legend_and_bonds(open_page: Opened) -> None:
    page = open_page()
    load(page)
    pause(page)
    page.wait_for_timeout(300)
    species = pixels(page)
    legend = page.get_by_role("note")
    expect(legend).to_be_hidden()
    for words, color in (("gas", (0x35, 0x29, 0x7A)), ("7+", (0x45, 0x31, 0x7C)), ("slow", None)):
        page.keyboard.press("c")
        expect(legend).to_contain_text(words)
        page.wait_for_timeout(300)
        image = pixels(page)
        assert changed(species, image) > 0.02
        if color is not None:  # of a solid, and of six neighbours
            assert np.mean(np.all(np.abs(image - np.array(color) / 255) < 0.02, axis=2)) > 0.02
    page.keyboard.press("c")
    expect(legend).to_be_hidden()
    page.wait_for_timeout(300)
    assert changed(species, pixels(page)) == 0
    page.keyboard.press("b")
    page.wait_for_timeout(300)
    assert changed(species, pixels(page)) > 0.02


def test_charts_of_matter(open_page: Opened) -> None:
    page = open_page()
    load(page, heating={"power": 0.01})
    for title in ("Heating curve", "Phases and order"):
        chart = page.locator(".study", has_text=title)
        expect(chart.locator("svg")).to_be_visible(timeout=60_000)
    page.get_by_role("button", name="Charts", exact=True).click()
    page.get_by_role("checkbox", name="Radial distribution g(r)").click()
    page.get_by_role("checkbox", name="Mean squared displacement").click()
    page.keyboard.press("Escape")
    expect(page.locator(".study svg")).to_have_count(4, timeout=60_000)
    page.wait_for_timeout(1500)
    assert page.evaluate(CUT_OFF) == []


@pytest.mark.parametrize("size", [(1280, 720), (1024, 768), (390, 844)])
def test_the_row_has_room(open_page: Opened, size: tuple[int, int]) -> None:
    phone = size[0] < 500
    page = open_page(size=size, has_touch=phone, is_mobile=phone)
    load(page)
    page.keyboard.press("c")
    page.keyboard.press("c")
    page.wait_for_timeout(1000)
    parts = {
        name: part for name, part in boxes(page).items() if not (phone and name.startswith(".transport"))
    }
    parts |= {"matter": page.locator(".matter").bounding_box() or {}}
    assert_apart(parts)
    for name, part in parts.items():
        assert part["x"] >= 0, name
        assert part["x"] + part["width"] <= size[0], name
    assert page.evaluate("document.scrollingElement.scrollWidth") == size[0]
    edge = parts["matter"]
    for control in page.locator(".matter button, .matter .reading, .legend .entry").all():
        box = control.bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= size[0]
    assert edge["height"] < (160 if phone else 70)
