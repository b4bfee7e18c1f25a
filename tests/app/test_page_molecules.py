"""A simulated user of a page with molecules: histograms of rotation, bars, the followed molecule, the panel."""

from __future__ import annotations

from collections.abc import AsyncIterator

import pytest
from free_rotors import DUMBBELL, SPRING, FreeRotors, rotors
from nicegui.testing import user_simulation
from simulated_lab import WIDE, Lab, bars

from gasbox.app.page import Page, build
from gasbox.app.session import Session


@pytest.fixture
async def molecules() -> AsyncIterator[Lab]:
    pages: list[Page] = []
    argon = {"name": "argon", "count": 30, "temperature": 1}
    scenario = rotors(
        {**DUMBBELL, "count": 100},
        {**SPRING, "count": 50},
        species=(argon,),
        container=WIDE,
        dynamics={"kind": "forced"},
    )

    def root() -> None:
        pages.append(build(Session(scenario, unwatched=True, simulate=FreeRotors)))

    async with user_simulation(root=root) as user:
        await user.open("/")
        page = pages[-1]
        page.session.start()
        one = Lab(user, page)
        await one.until(lambda: page.session.sample() is not None and one.one("particles").text == "180")
        yield one
        page.session.close()


async def test_a_page_with_molecules(molecules: Lab) -> None:
    lab, page = molecules, molecules.page
    await lab.until(lambda: bars(lab, 2))
    assert [chart.kind.name for chart in page.charts.histograms] == ["argon", "molecule 0", "molecule 1"]
    assert [sum(bar[1] for bar in bars(lab, kind)) for kind in range(3)] == [30, 100, 50]
    # The bars that level out are shown by themselves.
    assert next(iter(page.studies.charts)) == "degrees"
    await lab.until(lambda: page.studies.charts["degrees"].told)
    # What molecules alone have: angular velocities on both sides of zero.
    assert set(lab.one("quantity").options) >= {"speed", "angular-velocity", "rotational-energy"}
    lab.one("quantity").set_value("angular-velocity")
    await lab.until(lambda: bars(lab, 1))
    rows = bars(lab, 1)
    assert rows[0][2] == -rows[-1][3] < 0
    assert sum(bar[1] for bar in rows) == 100
    assert lab.one("facts-0").text == "does not turn"
    # A molecule that is followed tells what it has.
    page.session.follow(40)
    await lab.until(lambda: "energy of flight" in page.caption._text.text)
    assert lab.one("followed-text").text.startswith("molecule 0 no. 40 · speed")
    # And the panel knows molecules.
    page.panel.toggle()
    await lab.until(lambda: page.panel._draft is not None)
    lab.one("molecules[0].count").set_value("60")
    lab.one("species[0].remove").set_enabled(True)
    lab.click("species[0].remove")
    draft = page.panel._draft
    assert draft is not None
    assert (draft.species, draft.molecules[0].count) == ([], "60")
    lab.click("apply")
    await lab.until(lambda: lab.one("particles").text == "110")
    await lab.until(lambda: len(page.charts.histograms) == 2 and bars(lab, 0))
