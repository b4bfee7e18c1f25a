"""The page without a browser: another gas, from a file, from the list, or from the side panel."""

from __future__ import annotations

import json

import pytest
from free_flight import gas
from simulated_lab import Lab

from gasbox.scenario import load, parse


async def test_a_good_file_replaces_the_gas(lab: Lab) -> None:
    other = gas((50,), title="Another gas", watch_for="And this.")
    await lab.upload("other.json", other.to_json().encode())
    await lab.until(lambda: lab.one("particles").text == "50")
    assert len(lab.page.charts.histograms) == 1
    await lab.user.should_see("And this.")


async def test_a_broken_file_is_explained_and_the_old_gas_goes_on(lab: Lab) -> None:
    broken = {**gas().to_dict(), "species": [{"name": "x", "mass": -1, "radius": "big", "count": 3}]}
    version, time = lab.session.version, lab.time()
    await lab.upload("broken.json", json.dumps(broken).encode())
    await lab.user.should_see("broken.json can't be used")
    await lab.user.should_see("species[0].mass")
    await lab.user.should_see("species[0].radius")
    assert lab.session.version == version
    await lab.until(lambda: lab.time() > time)


@pytest.mark.parametrize("data", [b"", b"\xff\xfe\x00", b"[" * 100_000, b"\x1f\x8b\x08junk", b'{"a": NaN}'])
async def test_what_is_no_scenario_at_all_is_explained_too(lab: Lab, data: bytes) -> None:
    await lab.upload("junk.bin", data)
    await lab.user.should_see("junk.bin can't be used")


async def test_a_shipped_scenario_can_be_chosen(lab: Lab) -> None:
    lab.one("scenario").set_value("hot-and-cold")
    await lab.until(lambda: lab.session.scenario.hash() == load("hot-and-cold").hash())
    await lab.until(lambda: len(lab.page.charts.histograms) == 2)
    assert lab.one("scenario").value == "hot-and-cold"


async def test_scenario_and_snapshot_are_downloaded_as_files_that_can_be_opened(lab: Lab) -> None:
    for marker in ("save-scenario", "save-snapshot"):
        lab.click(marker)
        response = await lab.user.download.next(timeout=5.0)
        assert parse(response.content).hash() == lab.session.scenario.hash()


async def test_panel_applies_what_was_typed(lab: Lab) -> None:
    lab.page.panel.toggle()
    lab.one("species[0].count").set_value("7")
    lab.one("species[2].color").set_value("#123456")
    lab.one("seed").set_value("4321")
    lab.click("apply")
    await lab.until(lambda: lab.session.scenario.seed == 4321)
    assert [species.count for species in lab.session.scenario.species] == [7, 200, 100]
    assert lab.session.scenario.species[2].color == "#123456"


async def test_panel_says_what_is_wrong_and_loses_nothing(lab: Lab) -> None:
    lab.page.panel.toggle()
    version = lab.session.version
    lab.one("species[1].radius").set_value("-2")
    lab.one("species[0].mass").set_value("much")
    lab.one("seed").set_value("4321")
    lab.click("apply")
    await lab.until(lambda: lab.one("species[1].radius").error)
    assert lab.one("species[0].mass").error
    assert lab.one("species[0].mass").value == "much"
    assert lab.one("seed").value == "4321"
    assert lab.session.version == version
    lab.click("revert")
    assert lab.one("species[1].radius").value == "1"


async def test_species_can_be_added_and_removed(lab: Lab) -> None:
    lab.page.panel.toggle()
    lab.click("add-species")
    lab.click("apply")
    await lab.until(lambda: len(lab.page.charts.histograms) == 4)
    lab.click("species[0].remove")
    lab.click("apply")
    await lab.until(lambda: len(lab.page.charts.histograms) == 3)
    assert lab.session.scenario.species[0].name == "kind 1"


async def test_dynamics_and_container_can_be_changed(lab: Lab) -> None:
    lab.page.panel.toggle()
    lab.one("dynamics.kind").set_value("stepped")
    lab.one("dynamics.time_step").set_value("0.5")
    lab.one("periodic-x").set_value(False)
    lab.one("container.width").set_value("90")
    lab.click("apply")
    await lab.until(lambda: lab.session.scenario.dynamics.kind == "stepped")
    assert lab.session.scenario.container.width == 90
    assert lab.session.scenario.container.periodic == ("y",)
