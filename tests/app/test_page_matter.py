"""The row for temperature, heat and pressure, with NiceGUI's simulated user and a gas that needs no engine."""

from __future__ import annotations

import pytest
from simulated_lab import Lab
from surroundings import matter
from test_page_studies import loaded
from test_page_surroundings import changes

from gasbox.state import SetBarostat, SetHeating, SetThermostat

ARGON = {"name": "argon", "length": 3.405e-10, "energy": 1.654e-21, "mass": 6.634e-26}
HELD = {"thermostat": {"kind": "velocity-rescaling"}, "barostat": {"pressure": 0.02}, "units": ARGON}


async def opened(lab: Lab, **settings: object) -> None:
    await loaded(lab, matter(**settings))
    await lab.until(lambda: lab.page.matter.visible)


async def test_only_matter_with_forces_has_the_row(lab: Lab) -> None:
    assert not lab.page.matter.visible
    await opened(lab)
    assert lab.one("temperature-aim").text == "thermostat off"
    assert lab.one("pressure-aim").text == "barostat off"
    assert lab.one("heat-reading").text == "no heating"


async def test_the_thermostat_by_switch_slider_and_number(lab: Lab) -> None:
    await opened(lab, **HELD)
    await lab.until(lambda: lab.one("temperature-aim").text == "T = 1.00 · 120 K")
    lab.one("temperature-slider").set_value(-1.0)
    await lab.until(lambda: changes(lab) == [SetThermostat(0.5)])
    await lab.until(lambda: lab.one("temperature-goal").value == 0.5)
    lab.one("temperature-over").set_value(40.0)
    lab.one("temperature-goal").set_value(0.7)
    await lab.until(lambda: changes(lab)[-1] == SetThermostat(0.7, 40.0))
    await lab.until(lambda: lab.one("temperature-aim").text.startswith("T → 0.700"))
    lab.click("temperature-switch")
    await lab.until(lambda: changes(lab)[-1] == SetThermostat(None))
    await lab.until(lambda: lab.one("temperature-aim").text == "thermostat off")
    lab.click("temperature-switch")
    await lab.until(lambda: changes(lab)[-1] == SetThermostat(0.7))
    assert len(changes(lab)) == 4


async def test_the_thermostat_begins_at_the_temperature_of_the_gas(lab: Lab) -> None:
    await opened(lab)
    lab.click("temperature-switch")
    await lab.until(lambda: changes(lab))
    (change,) = changes(lab)
    assert isinstance(change, SetThermostat)
    assert change.temperature == pytest.approx(0.01, rel=0.2)  # of free flight, whatever the scenario says


async def test_heat_flows_while_something_is_held_down(lab: Lab) -> None:
    await opened(lab, heating={"power": 0.001})
    await lab.until(lambda: lab.one("heat-reading").text == "heat +0.00100")
    with lab.user:
        lab.page.matter.hold("heat")
        lab.page.matter.hold("heat")  # a key repeats
    await lab.until(lambda: changes(lab))
    (hot,) = changes(lab)
    assert hot == SetHeating(pytest.approx(1.0 / (10 * 60 * 0.5), rel=0.05))
    assert "held" in lab.one("hold-heat").classes
    with lab.user:
        lab.page.matter.hold("")
    await lab.until(lambda: changes(lab)[-1] == SetHeating(0.001))
    with lab.user:
        lab.page.matter.hold("cool")
    await lab.until(lambda: changes(lab)[-1] == SetHeating(-hot.power))  # type: ignore[attr-defined]
    with lab.user:
        lab.page.matter.hold("")
    await lab.until(lambda: len(changes(lab)) == 4)


async def test_constant_heating_by_slider_and_number(lab: Lab) -> None:
    await opened(lab)
    lab.one("heat-slider").set_value(-1.0)
    await lab.until(lambda: changes(lab))
    (cold,) = changes(lab)
    assert isinstance(cold, SetHeating)
    assert cold.power == pytest.approx(-8 / (10 * 60 * 0.5), rel=0.05)  # the cube of twice as much as by hand
    lab.one("heat-power").set_value(0.002)
    await lab.until(lambda: changes(lab)[-1] == SetHeating(0.002))
    lab.click("heat-zero")
    await lab.until(lambda: changes(lab)[-1] == SetHeating(0.0))
    lab.one("heat-slider").set_value(0.04)  # so near to the middle it means nothing
    await lab.until(lambda: len(changes(lab)) == 3)


async def test_pressure_is_held_where_there_are_no_walls(lab: Lab) -> None:
    await opened(lab, **HELD)
    assert lab.page.matter.pressure.root.visible
    lab.one("pressure-slider").set_value(1.0)
    await lab.until(lambda: changes(lab) == [SetBarostat(0.04)])
    await lab.until(lambda: lab.one("pressure-aim").text == "p = 0.0400 · 571 µN/m")
    lab.click("pressure-switch")
    await lab.until(lambda: changes(lab)[-1] == SetBarostat(None))
    await loaded(lab, matter(container={"shape": "rectangle", "width": 60, "height": 40}))
    await lab.until(lambda: not lab.page.matter.pressure.root.visible)
    assert lab.page.matter.visible


async def test_readouts_of_matter_in_both_units(lab: Lab) -> None:
    assert lab.one("collisions/time").text
    await opened(lab, **HELD)
    await lab.until(lambda: lab.one("density").text == "0.0833")
    await lab.user.should_see("0.719/nm²")
    assert lab.one("potential").text == "0"
    assert lab.one("kinetic").text == "0.0101" or lab.one("kinetic").text.startswith("0.0")
