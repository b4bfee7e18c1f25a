"""The simulation, its frames, and its snapshots."""

from __future__ import annotations

import gzip
import json

import numpy as np
import pytest

import gasbox
from gasbox.observe import ContactLog
from gasbox.scenario import parse, with_settings

SCENARIOS = {
    "stepped": {"dynamics": {"kind": "stepped", "time_step": 0.5}},
    "event-driven": {"dynamics": {"kind": "event-driven"}},
}
every_dynamics = pytest.mark.parametrize("kind", SCENARIOS)


def scenario_of(kind: str, **more) -> gasbox.Scenario:
    return parse(
        {
            "format": "gasbox-scenario/1",
            "seed": 5,
            "container": {"shape": "rectangle", "width": 40, "height": 30},
            "species": [
                {"name": "light", "radius": 0.5, "mass": 1, "count": 60, "temperature": 0.1},
                {"name": "heavy", "radius": 1.5, "mass": 9, "count": 6, "temperature": 0.2},
            ],
            **SCENARIOS[kind],
            **more,
        }
    )


def bits(simulation: gasbox.Simulation) -> list[bytes]:
    memory = simulation.dynamics.memory()
    tallies = simulation.dynamics.tallies
    arrays = [simulation.state.position, simulation.state.velocity, tallies.pair_virial, tallies.wall_impulse]
    return [np.asarray(a).tobytes() for a in [*arrays, *(memory[name] for name in sorted(memory))]]


@every_dynamics
@pytest.mark.parametrize("name", ["later.json", "later.json.gz"])
@pytest.mark.small
def test_a_restored_run_equals_the_uninterrupted_one_to_the_bit(kind, name, tmp_path):
    whole = gasbox.Simulation(scenario_of(kind))
    whole.advance(until=90.0)

    first = gasbox.Simulation(scenario_of(kind))
    first.advance(until=31.5)
    first.save(tmp_path / name)
    second = gasbox.Simulation.restore(tmp_path / name)
    assert second.time == 31.5
    second.advance(until=90.0)
    assert bits(second) == bits(whole)
    assert second.dynamics.tallies.pair_collisions.sum() > 20


@every_dynamics
@pytest.mark.small
def test_frames_recorded_often_or_never_give_the_same_bits(kind):
    final = []
    for every in (0.5, 2.0, 30.0):
        simulation = gasbox.Simulation(scenario_of(kind))
        observers = [ContactLog()] if every == 0.5 else []
        frames = [f.state.time for f in gasbox.run(simulation, until=30.0, every=every, observers=observers)]
        assert frames == [k * every for k in range(round(30 / every) + 1)]
        final.append(bits(simulation))
    assert final[0] == final[1] == final[2]


@pytest.mark.small
def test_same_seed_same_bits_other_seed_other_bits():
    runs = []
    for seed in (1, 1, 2):
        simulation = gasbox.Simulation(scenario_of("event-driven", seed=seed))
        simulation.advance(until=5.0)
        runs.append(bits(simulation))
    assert runs[0] == runs[1] != runs[2]


@every_dynamics
@pytest.mark.small
def test_summary(kind):
    simulation = gasbox.Simulation(scenario_of(kind, frame_interval=1.0))
    simulation.advance(frames=40)
    summary = json.loads(json.dumps(simulation.summary()))
    assert summary["time"] == 40.0
    assert summary["frames"] == 40
    assert summary["particles"] == 66
    assert summary["collisions"] == simulation.dynamics.tallies.pair_collisions.sum() > 0
    assert summary["collision_rates"]["pairs"] == summary["collisions"] / 40.0
    assert np.sum(summary["collision_rates"]["per_pair"]) == pytest.approx(summary["collisions"] / 40.0)
    assert summary["energy"] == pytest.approx(60 * 0.1 + 6 * 0.2, rel=1e-12)
    assert summary["temperature"] == pytest.approx(7.2 / 66, rel=1e-12)
    assert [s["count"] for s in summary["species"]] == [60, 6]
    # Wall hits: P = sum over species N_s T_s/A_s and more; within five standard errors of the ideal value.
    hits = summary["wall_collisions"]
    assert summary["pressure"] == pytest.approx(7.2 / (39 * 29), rel=5 * 1.13 / np.sqrt(hits) + 0.2)
    assert (summary["particle_steps_per_second"] is None) == (kind == "event-driven")


@pytest.mark.small
def test_a_run_that_asks_for_nonsense_says_so():
    simulation = gasbox.Simulation(scenario_of("stepped"))
    with pytest.raises(gasbox.UsageError, match="whole multiple of the time step"):
        gasbox.run(simulation, frames=3, every=0.7)
    with pytest.raises(gasbox.UsageError, match="above zero"):
        gasbox.run(simulation, frames=3, every=0.0)
    with pytest.raises(gasbox.UsageError, match="not both"):
        gasbox.run(simulation, frames=3, until=5.0)
    simulation.advance(until=10.0)
    with pytest.raises(gasbox.UsageError, match="already"):
        gasbox.run(simulation, until=5.0)
    with pytest.raises(gasbox.UsageError, match="already"):
        simulation.advance(until=5.0)


@pytest.mark.small
def test_overlaps_are_refused_with_the_worst_pair():
    scenario = parse(
        {
            "format": "gasbox-scenario/1",
            "container": {"shape": "rectangle", "width": 40, "height": 30},
            "species": [{"name": "a", "radius": 1}],
            "particles": [
                {"species": "a", "position": [5, 5]},
                {"species": "a", "position": [20, 20]},
                {"species": "a", "position": [21.5, 20]},
            ],
        }
    )
    with pytest.raises(gasbox.ScenarioError) as caught:
        gasbox.Simulation(with_settings(scenario, {"dynamics.kind": "event-driven"}))
    assert "0.5" in str(caught.value)
    gasbox.Simulation(with_settings(scenario, {"dynamics.kind": "stepped"})).advance(frames=1)


@pytest.mark.small
def test_from_stepped_to_event_driven_overlaps_are_separated_and_told():
    simulation = gasbox.Simulation(scenario_of("stepped"))
    simulation.advance(until=50.0)
    other = gasbox.Simulation(with_settings(simulation.snapshot(), {"dynamics.kind": "event-driven"}))
    assert other.time == 50.0
    assert any("moved apart" in warning for warning in other.warnings)
    other.advance(until=60.0)
    assert other.energy() == pytest.approx(simulation.energy(), rel=1e-13)


@pytest.mark.small
def test_tunnelling_is_told():
    simulation = gasbox.Simulation(scenario_of("stepped", dynamics={"kind": "stepped", "time_step": 5.0}))
    assert any("pass through each other" in warning for warning in simulation.warnings)
    assert not gasbox.Simulation(scenario_of("stepped")).warnings


@pytest.mark.small
def test_frame_interval_is_chosen_where_none_is_given():
    assert gasbox.Simulation(scenario_of("stepped")).frame_interval == 0.5
    chosen = gasbox.Simulation(scenario_of("event-driven")).frame_interval
    # 30 lengths in 240 frames at a typical speed of about 0.45: 0.28, rounded down to 1, 2 or 5.
    assert chosen == 0.2


@pytest.mark.small
def test_a_snapshot_file_is_a_scenario(tmp_path):
    simulation = gasbox.Simulation(scenario_of("event-driven"))
    simulation.advance(until=3.0)
    simulation.save(tmp_path / "s.json.gz")
    text = json.loads(gzip.decompress((tmp_path / "s.json.gz").read_bytes()))
    assert text["format"] == "gasbox-scenario/1"
    assert len(text["particles"]["position"]) == 66 if isinstance(text["particles"], dict) else True
    assert text["snapshot"]["time"] == 3.0
    with pytest.raises(gasbox.FileError, match="cannot be written"):
        simulation.save(tmp_path / "nowhere" / "s.json")
