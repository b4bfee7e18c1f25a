"""Thermostat, barostat and heating changed in a run: by hand, by a schedule, in snapshots; repeated to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from gasbox.errors import UsageError
from gasbox.kernels.forced.bath import T_TO
from gasbox.scenario import ScheduledChange, parse
from gasbox.simulation import Simulation
from gasbox.state import SetBarostat, SetHeating, SetThermostat

THERMOSTATS = pytest.mark.parametrize("thermostat", [None, "langevin", "velocity-rescaling"])


def scenario(thermostat=None, periodic=("x", "y"), kind="forced", **more):
    data = {
        "format": "gasbox-scenario/1",
        "seed": 5,
        "container": {"shape": "rectangle", "width": 16, "height": 14, "periodic": list(periodic)},
        "species": [{"name": "atom", "radius": 0.5, "count": 90, "temperature": 1.0}],
        "dynamics": {"kind": kind, **({"time_step": 0.05} if kind == "stepped" else {})},
        "frame_interval": 0.5,
        **more,
    }
    if thermostat is not None:
        data["thermostat"] = {"kind": thermostat, "temperature": 1.0, "time": 0.4}
    return parse(data)


def bits(simulation) -> tuple:
    state, tallies = simulation.state, simulation.dynamics.tallies
    sums = [tallies.thermostat_heat, tallies.heater_heat, tallies.barostat_work, tallies.area_time]
    return (
        state.time,
        state.position.tobytes(),
        state.velocity.tobytes(),
        state.wall_displacement.tobytes(),
        (state.potential, state.virial),
        *(part.tobytes() for part in sums),
    )


def act(simulation) -> None:
    """Some changes at odd times."""
    simulation.advance(until=0.525)
    simulation.apply(SetThermostat(2.0, over=1.5))
    simulation.advance(until=1.13)
    simulation.apply(SetBarostat(1.5))
    simulation.advance(until=1.5)
    simulation.apply(SetHeating(0.3))
    simulation.apply(SetBarostat(3.0, over=1.0))
    simulation.advance(until=2.31)
    simulation.apply(SetThermostat(None))
    simulation.advance(until=2.8)
    simulation.apply(SetThermostat(0.5))
    simulation.apply(SetBarostat(None))
    simulation.advance(until=3.0)
    simulation.apply(SetHeating(0.0))


@THERMOSTATS
def test_a_run_with_controls_is_repeated_by_a_schedule(thermostat):
    by_hand = Simulation(scenario(thermostat))
    act(by_hand)
    by_hand.advance(until=4.0)
    log = [ScheduledChange.of(time, change) for time, change in by_hand.changes]
    assert len(log) == 8
    plan = [entry.model_dump(mode="json", exclude_none=True) for entry in log]
    again = Simulation(scenario(thermostat, schedule=plan))
    for time in (0.7, 2.31, 2.9, 4.0):
        again.advance(until=time)
    assert bits(again) == bits(by_hand)
    assert again.changes == by_hand.changes
    assert again.state.wall_displacement[1] != 0.0


def test_changes_at_one_time_are_made_in_their_order():
    plan = [
        {"at": 0.5, "thermostat": {"temperature": 3.0}},
        {"at": 0.5, "thermostat": {"temperature": 1.0, "over": 2.0}},
        {"at": 0.2, "heating": {"power": 0.1}},
        {"at": 0.5, "heating": {"power": 0.0}},
    ]
    simulation = Simulation(scenario("velocity-rescaling", schedule=plan))
    simulation.advance(until=1.0)
    wanted = [SetHeating(0.1), SetThermostat(3.0), SetThermostat(1.0, 2.0), SetHeating(0.0)]
    assert [change for _, change in simulation.changes] == wanted


@THERMOSTATS
@pytest.mark.parametrize("until", [0.3, 1.2, 1.8, 2.5, 2.95, 3.4])
def test_a_snapshot_goes_on_between_and_after_controls(thermostat, until, tmp_path):
    """Also on the way of a ramp, and while the thermostat is off."""
    plan = Simulation(scenario(thermostat))
    act(plan)
    schedule = [
        ScheduledChange.of(time, change).model_dump(mode="json", exclude_none=True)
        for time, change in plan.changes
    ]
    whole = Simulation(scenario(thermostat, schedule=schedule))
    whole.advance(until=until)
    whole.save(tmp_path / "half.json")
    whole.advance(until=4.0)
    resumed = Simulation.restore(tmp_path / "half.json")
    resumed.advance(until=4.0)
    assert bits(resumed) == bits(whole)
    assert resumed.changes == whole.changes


@THERMOSTATS
def test_switched_off_is_switched_off(thermostat):
    simulation = Simulation(scenario(thermostat, barostat={"pressure": 2.0}))
    simulation.advance(until=1.0)
    for change in (SetThermostat(None), SetBarostat(None), SetHeating(0.0)):
        simulation.apply(change)
    tallies, moved = simulation.dynamics.tallies.copy(), simulation.state.wall_displacement.copy()
    assert moved.any()
    simulation.advance(until=2.0)
    change = simulation.dynamics.tallies - tallies
    assert not change.thermostat_heat[0]
    assert not change.heater_heat[0]
    assert not change.barostat_work[0]
    assert np.array_equal(simulation.state.wall_displacement, moved)


def test_a_schedule_leads_temperature_and_pressure():
    plan = [
        {"at": 1.0, "thermostat": {"temperature": 4.0, "over": 4.0}},
        {"at": 6.0, "thermostat": "off"},
        {"at": 6.0, "heating": {"power": 1.0}},
    ]
    simulation = Simulation(scenario("velocity-rescaling", forces={"law": "none"}, schedule=plan))
    found = []
    for time in np.arange(4.5, 6.0, 0.1):
        simulation.advance(until=time)
        found.append(simulation.temperature())
    # The temperature lags by the time of the thermostat, and fluctuates by one part in sqrt(89).
    assert 2.8 < np.mean(found) < 4.6
    simulation.advance(until=6.0)
    before = simulation.energy()
    simulation.advance(until=8.0)
    assert simulation.energy() - before == pytest.approx(90 * 2.0, rel=1e-9)


@pytest.mark.parametrize("kind", ["event-driven", "stepped"])
@pytest.mark.parametrize("change", [SetThermostat(1.0), SetBarostat(1.0), SetHeating(0.1)])
def test_other_rules_have_no_controls(kind, change):
    simulation = Simulation(scenario(kind=kind))
    before = bits(simulation)
    with pytest.raises(UsageError, match=f"{kind} dynamics has no thermostat, barostat or heating"):
        simulation.apply(change)
    assert simulation.changes == []
    assert bits(simulation) == before


@pytest.mark.parametrize("periodic", [(), ("x",), ("y",)])
def test_no_barostat_between_walls(periodic):
    simulation = Simulation(scenario("langevin", periodic))
    with pytest.raises(UsageError, match="periodic in both directions"):
        simulation.apply(SetBarostat(1.0))
    assert simulation.changes == []
    simulation.apply(SetBarostat(None))
    simulation.apply(SetThermostat(2.0))
    simulation.apply(SetHeating(0.1))
    simulation.advance(until=1.0)
    assert not simulation.dynamics.tallies.barostat_work[0]


@pytest.mark.parametrize("periodic", [(), ("x", "y")])
def test_a_thermostat_without_a_temperature_keeps_that_of_the_start(periodic):
    atom = {"name": "atom", "radius": 0.5, "count": 90, "speed": 2.0}
    gas = scenario(periodic=periodic, species=[atom]).to_dict()
    simulation = Simulation(parse({**gas, "thermostat": {"kind": "langevin"}}))
    aim = simulation.dynamics.memory()["drive"][T_TO]
    assert aim == pytest.approx(simulation.temperature(), rel=1e-12)
    if not periodic:
        assert aim == pytest.approx(2.0**2 / 2, rel=1e-12)
