"""The charts beside the histograms on the page, with NiceGUI's simulated user."""

from __future__ import annotations

import json

from simulated_lab import Lab
from surroundings import DIVIDER, walled

from gasbox.app.session import Session
from gasbox.scenario import Scenario


def text_of(scenario: Scenario) -> bytes:
    return json.dumps(scenario.to_dict()).encode()


async def loaded(lab: Lab, scenario: Scenario) -> None:
    version = lab.session.version
    await lab.upload("other.json", text_of(scenario))
    await lab.until(lambda: lab.session.version > version)


async def test_a_plain_gas_has_histograms_only_until_somebody_wants_more(lab: Lab) -> None:
    assert not lab.page.studies.charts
    await lab.until(lambda: lab.page.studies.suitable)
    assert not lab.one("show-pressures").enabled  # no walls
    lab.one("show-centers").set_value(True)
    await lab.until(lambda: list(lab.page.studies.charts) == ["centers"])
    assert lab.session.charts == {"centers"}
    await lab.until(lambda: lab.page.studies.charts["centers"].told)
    lab.one("show-centers").set_value(False)
    assert not lab.page.studies.charts
    assert lab.session.charts == frozenset()


async def test_a_gas_with_a_divider_opens_its_charts(lab: Lab) -> None:
    await loaded(lab, walled(obstacles=[DIVIDER]))
    await lab.until(lambda: list(lab.page.studies.charts) == ["sides", "mixing"])
    await lab.until(lambda: lab.one("show-sides").value and lab.one("show-mixing").value)
    assert not lab.one("show-work").enabled
    assert lab.session.charts is None


async def test_what_was_chosen_is_kept_when_the_gas_changes_and_when_the_page_is_loaded_again(
    lab: Lab,
) -> None:
    await lab.until(lambda: lab.page.studies.suitable)
    lab.one("show-density").set_value(True)
    await loaded(lab, walled(obstacles=[DIVIDER]))
    await lab.until(lambda: "pressures" in lab.page.studies.suitable)
    assert list(lab.page.studies.charts) == ["density"]
    heir = Session(lab.session.scenario, unwatched=True)
    lab.session.hand_over(heir)
    assert heir.charts == {"density"}
    heir.close()
