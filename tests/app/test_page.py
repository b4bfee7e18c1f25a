"""The page without a browser: time, histograms and what is said, with NiceGUI's simulated user."""

from __future__ import annotations

import asyncio
import math
from typing import Any

import pytest
from nicegui import ui
from simulated_lab import Lab, bars


async def test_one_histogram_for_each_species_with_all_its_particles(lab: Lab) -> None:
    await lab.until(lambda: bars(lab, 2))
    assert [histogram.kind.name for histogram in lab.page.charts.histograms] == [
        "kind 0",
        "kind 1",
        "kind 2",
    ]
    for species, count in enumerate((300, 200, 100)):
        facts = lab.one(f"facts-{species}").text
        beyond = int(facts.split(" · ")[1].split()[0]) if "beyond" in facts else 0
        assert sum(row[1] for row in bars(lab, species)) + beyond == count
        assert facts.startswith(f"N = {count}")


async def test_what_to_watch_for_is_said(lab: Lab) -> None:
    await lab.user.should_see("Watch this.")


async def test_play_and_pause(lab: Lab) -> None:
    assert lab.session.playing
    lab.click("play")
    assert not lab.session.playing
    lab.session.settle()
    time = lab.time()
    await asyncio.sleep(0.2)
    assert lab.time() == time
    lab.click("play")
    await lab.until(lambda: lab.time() > time)


async def test_one_frame_pauses_and_moves_on_by_one(lab: Lab) -> None:
    lab.click("play")
    lab.session.settle()
    before = lab.session.sample()
    lab.click("step")
    await lab.until(lambda: lab.session.sample() is not before)
    after = lab.session.sample()
    assert before is not None
    assert after is not None
    assert after.time - before.time == pytest.approx(0.5)
    assert not lab.session.playing


async def test_reset_goes_back_to_the_start(lab: Lab) -> None:
    lab.click("play")
    version = lab.session.version
    lab.click("reset")
    await lab.until(lambda: lab.session.version > version)
    await lab.until(lambda: lab.time() == 0.0)
    await lab.until(lambda: lab.one("time").text == "0")


async def test_slider_is_logarithmic(lab: Lab) -> None:
    lab.one("speed").set_value(1.0)
    assert lab.session.speed == 10.0
    lab.one("speed").set_value(-1.0)
    assert lab.session.speed == 0.1
    assert lab.one("speed-reading").text == "0.1×"


async def test_buttons_go_up_and_down_the_ladder_and_stop_at_its_ends(lab: Lab) -> None:
    for _ in range(12):
        lab.click("faster")
    assert lab.session.speed == 100.0
    assert lab.one("speed").value == 2.0
    for _ in range(12):
        lab.click("slower")
    assert lab.session.speed == 0.1


async def test_it_is_said_when_the_engine_cannot_keep_up(lab: Lab) -> None:
    lab.page.transport.show_reached(keeping_up=False, reached=3.21)
    assert lab.one("behind").text == "can't keep up: 3.2×"
    lab.page.transport.show_reached(keeping_up=True, reached=10.0)
    assert lab.one("behind").text == ""


async def test_keys(lab: Lab) -> None:
    await lab.press(" ")
    await lab.until(lambda: not lab.session.playing)
    await lab.press("ArrowUp")
    await lab.press("+")
    await lab.until(lambda: lab.session.speed == 5.0)
    await lab.press("-")
    await lab.until(lambda: lab.session.speed == 2.0)
    assert lab.page.chart_settings.theory.value
    await lab.press("t")
    await lab.until(lambda: not lab.page.chart_settings.theory.value)
    await lab.press("?")
    await lab.user.should_see("this list")


async def test_theory_can_be_switched_off(lab: Lab) -> None:
    options = lab.page.charts.histograms[0].chart.options
    await lab.until(lambda: options["series"][1]["data"])
    lab.one("theory").set_value(False)
    await lab.until(lambda: not options["series"][1]["data"])
    lab.one("theory").set_value(True)
    await lab.until(lambda: options["series"][1]["data"])


async def test_bins_range_and_quantity_can_be_changed_live(lab: Lab) -> None:
    lab.one("bins").set_value(12)
    await lab.until(lambda: len(bars(lab, 0)) == 12)
    lab.one("range").set_value("given")
    lab.one("minimum").set_value(0.05)
    lab.one("maximum").set_value(0.2)
    axis = lab.page.charts.histograms[1].chart.options["xAxis"]
    await lab.until(lambda: (axis["min"], axis["max"]) == (0.05, 0.2))
    assert "below the range" in lab.one("facts-1").text
    assert "beyond the range" in lab.one("facts-1").text
    lab.one("quantity").set_value("energy")

    # Another quantity has other axes: its charts are new ones.
    def axis_now():
        return lab.page.charts.histograms[1].chart.options["xAxis"]

    await lab.until(lambda: axis_now()["name"].startswith("energy"))


async def test_senseless_bins_are_not_taken(lab: Lab) -> None:
    await lab.until(lambda: bars(lab, 0))
    count = len(bars(lab, 0))
    for value in (0, None, 1e9):
        lab.one("bins").set_value(value)
    lab.one("range").set_value("given")
    lab.one("minimum").set_value(9.0)
    lab.one("maximum").set_value(1.0)
    await asyncio.sleep(0.4)
    assert len(bars(lab, 0)) == count


async def test_smoothing_averages(lab: Lab) -> None:
    lab.one("smoothing").set_value(math.inf)
    await lab.until(lambda: lab.page.charts.window == math.inf)
    assert lab.page.charts.histograms[0]._smoothing.window == math.inf


async def test_pointing_at_a_bin_lights_it_up_and_leaving_ends_it(lab: Lab) -> None:
    await lab.until(lambda: bars(lab, 1))
    lit: list[tuple[Any, ...]] = []
    lab.session.highlight = lambda *bin_: lit.append(bin_)  # type: ignore[method-assign]
    lab.session.clear_highlight = lambda: lit.append(())  # type: ignore[method-assign]
    lab.page.charts._dim = lab.session.clear_highlight
    lab.page.charts._pointed(1, 4)
    lab.page.charts._pointed(1, 4)
    lab.page.charts._pointed(1, None)
    row = bars(lab, 1)[4]
    assert lit[0] == (1, pytest.approx(row[2], rel=1e-4), pytest.approx(row[3], rel=1e-4), "speed")
    assert lit[1:] == [()]


async def test_a_followed_particle_is_shown_until_escape(lab: Lab) -> None:
    with lab.user:
        lab.session.follow(310)
    await lab.until(lambda: lab.page.caption._followed.visible)
    assert lab.one("followed-text").text.startswith("kind 1 no. 310 · speed ")
    await lab.press("Escape")
    await lab.until(lambda: not lab.page.caption._followed.visible)


async def test_charts_can_be_left_out(lab: Lab) -> None:
    lab.page.toggle_charts()
    assert "bare" in lab.page._lab._classes
    lab.page.toggle_charts()
    assert "bare" not in lab.page._lab._classes


@pytest.mark.parametrize(
    ("notice", "said"),
    [
        (
            {"kind": "preparing", "done": 2, "total": 5, "name": "walls", "first": True},
            "Compiling for this machine …",
        ),
        ({"kind": "busy", "text": "all 16 places of this lab are taken"}, "The lab is full"),
        ({"kind": "trouble", "text": "no progress"}, "The gas can't go on"),
        ({"kind": "lost"}, "Connection lost"),
    ],
)
async def test_the_page_says_why_there_is_no_gas(lab: Lab, notice: dict[str, Any], said: str) -> None:
    lab.session.sample = lambda: None  # type: ignore[method-assign]
    with lab.user:
        lab.page.stage.hear(notice)
    await lab.user.should_see(said)
    with lab.user:
        lab.page.stage.hear({"kind": "connected"})
    await lab.user.should_not_see(said)


async def test_a_hidden_page_asks_for_nothing(lab: Lab) -> None:
    asked: list[int] = []
    lab.page._visible = False
    lab.session.sample = lambda: asked.append(1)  # type: ignore[method-assign, assignment, func-returns-value]
    await asyncio.sleep(0.6)
    assert not asked


async def test_controls_have_names_for_screen_readers(lab: Lab) -> None:
    for button in lab.user.find(kind=ui.button).elements:
        assert button.props.get("aria-label") or button.text, button.props
