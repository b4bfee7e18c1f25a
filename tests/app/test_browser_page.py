"""The page in a real Chromium: what is drawn, what moves, what the controls do."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from pictures import changed, pixels
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser

Opened = Callable[..., Page]


def stats(page: Page) -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate("({...gasboxStats, moments: 0})")
    return found


def wait_for_frames(page: Page, count: int = 5) -> None:
    page.wait_for_function(f"gasboxStats.drawn > {stats(page)['drawn'] + count}")


def pause(page: Page) -> None:
    page.get_by_role("button", name="Pause", exact=True).click()
    page.wait_for_function("gasboxStats.playing === false")


def test_particles_are_drawn_and_move(open_page: Opened) -> None:
    page = open_page()
    before, time = pixels(page), stats(page)["time"]
    wait_for_frames(page, 20)
    after = pixels(page)
    assert stats(page)["time"] > time
    assert changed(before, after) > 0.01
    assert stats(page)["count"] == 2000


def test_the_box_shows_each_species_in_its_colour(open_page: Opened) -> None:
    page = open_page()
    image = pixels(page)
    for color in ((0x5B, 0x6C, 0xF0), (0xE0, 0x5A, 0x00), (0x00, 0x9E, 0x73)):
        near = np.all(np.abs(image - np.array(color) / 255) < 0.06, axis=2)
        assert np.mean(near) > 0.002


def test_pause_stops_and_play_goes_on(open_page: Opened) -> None:
    page = open_page()
    pause(page)
    page.wait_for_timeout(300)
    before, time = pixels(page), stats(page)["time"]
    page.wait_for_timeout(600)
    assert stats(page)["time"] == time
    assert changed(before, pixels(page)) == 0
    page.get_by_role("button", name="Play", exact=True).click()
    page.wait_for_function(f"gasboxStats.time > {time}")


def test_one_frame_moves_on_by_one(open_page: Opened) -> None:
    page = open_page()
    pause(page)
    page.wait_for_timeout(300)
    number = stats(page)["number"]
    page.get_by_role("button", name="One frame").click()
    page.wait_for_function(f"gasboxStats.number === {number + 1}")


def test_histograms_have_named_axes_titles_and_a_curve(open_page: Opened) -> None:
    page = open_page()
    charts = page.locator(".histogram")
    expect(charts).to_have_count(3)
    for index, name in enumerate(("light", "medium", "heavy")):
        chart = charts.nth(index)
        expect(chart.locator(".title")).to_contain_text(name)
        expect(chart.locator("svg text", has_text="speed (length/time)")).to_be_visible()
        expect(chart.locator("svg text", has_text="number of particles")).to_be_visible()
        expect(chart.locator("svg path[stroke='var(--ink)'][fill='none']")).to_have_count(1)


def test_pointing_at_a_bar_tells_its_bin_and_lights_up_its_particles(open_page: Opened) -> None:
    page = open_page()
    pause(page)
    page.wait_for_timeout(500)
    before = pixels(page)
    plot = page.locator(".histogram .plot").nth(1)
    box = plot.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 0.4 * box["height"])
    tip = plot.locator(".chart-tip")
    expect(tip).to_be_visible()
    for text in ("speed 0", "particles", "theory expects"):
        expect(tip).to_contain_text(text)
    page.wait_for_timeout(500)
    lit = pixels(page)
    assert changed(before, lit) > 0.02
    page.mouse.move(5, 5)
    page.wait_for_timeout(500)
    assert changed(before, pixels(page)) == 0


def test_keys(open_page: Opened) -> None:
    page = open_page()
    page.keyboard.press(" ")
    page.wait_for_function("gasboxStats.playing === false")
    page.wait_for_timeout(300)
    number = stats(page)["number"]
    page.keyboard.press("ArrowRight")
    page.wait_for_function(f"gasboxStats.number === {number + 1}")
    for key, reading in (
        ("ArrowUp", "2×"),
        ("+", "5×"),
        ("-", "2×"),
        ("ArrowDown", "1×"),
        ("ArrowDown", "0.5×"),
    ):
        page.keyboard.press(key)
        expect(page.locator(".transport .reading")).to_have_text(reading)
    page.keyboard.press("r")
    page.wait_for_function("gasboxStats.time === 0")
    page.keyboard.press("?")
    expect(page.get_by_text("stop following a particle", exact=True)).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.get_by_text("stop following a particle", exact=True)).to_be_hidden()


def test_keys_do_nothing_while_somebody_types(open_page: Opened) -> None:
    page = open_page()
    page.keyboard.press("e")
    field = page.get_by_label("seed")
    field.click()
    field.press_sequentially("r 1-2+s?")
    expect(field).to_have_value("7r 1-2+s?")
    page.wait_for_timeout(300)
    assert stats(page)["playing"]
    expect(page.locator(".transport .reading")).to_have_text("1×")


def test_space_means_pause_also_after_a_click_on_another_button(open_page: Opened) -> None:
    page = open_page()
    page.get_by_role("button", name="Faster").click()
    page.keyboard.press(" ")
    page.wait_for_function("gasboxStats.playing === false")
    expect(page.locator(".transport .reading")).to_have_text("2×")


def test_a_clicked_particle_is_followed_until_escape(open_page: Opened) -> None:
    page = open_page()
    pause(page)
    page.wait_for_timeout(300)
    image = pixels(page)
    rows, columns = np.nonzero(np.all(np.abs(image - np.array([0x00, 0x9E, 0x73]) / 255) < 0.02, axis=2))
    box = page.locator(".gasbox-lab").bounding_box()
    assert box is not None
    middle = len(rows) // 2
    page.mouse.click(box["x"] + columns[middle] + 0.5, box["y"] + rows[middle] + 0.5)
    expect(page.locator(".followed")).to_be_visible()
    expect(page.locator(".followed")).to_contain_text("heavy no.")
    expect(page.locator(".followed")).to_contain_text("speed")
    page.keyboard.press("Escape")
    expect(page.locator(".followed")).to_be_hidden()


def test_charts_can_be_left_out_and_come_back(open_page: Opened) -> None:
    page = open_page("?charts=0")
    expect(page.locator(".histogram").first).to_be_hidden()
    page.get_by_role("button", name="Histograms on or off").click()
    expect(page.locator(".histogram").first).to_be_visible()
    expect(page.locator(".histogram svg").first).to_be_visible()


def test_light_and_dark(open_page: Opened) -> None:
    dark = open_page(scheme="dark")
    background = "getComputedStyle(document.body).backgroundColor"
    assert dark.evaluate(background) == "rgb(14, 17, 22)"
    dark.get_by_role("button", name="Light or dark").click()
    dark.wait_for_function(f"{background} === 'rgb(244, 245, 247)'")
