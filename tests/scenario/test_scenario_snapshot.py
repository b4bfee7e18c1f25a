"""The section that makes a scenario a snapshot must fit its gas."""

import pytest

from gasbox.errors import ScenarioError
from gasbox.scenario import parse

pytestmark = pytest.mark.small

BOX = {"width": 40, "height": 30}
GAS = {"name": "gas", "count": 3, "temperature": 1}


def problems(data, **changes):
    base = {"container": BOX, "species": [GAS]}
    with pytest.raises(ScenarioError) as caught:
        parse({**base, **changes} if data is None else data)
    return {problem.path: problem for problem in caught.value.problems}


TALLIES = {
    "pair_virial": [0.5],
    "pair_collisions": [[1]],
    "wall_impulse": [[0.5]] * 4,
    "wall_collisions": [[1]] * 4,
}
REFERENCES = {"epoch": 2, "epoch_length": 64.0, "position": [[1, 2]], "velocity": [[0, 1]], "time": [0.5]}
FORCED = {
    "forced_step": 20,
    "position": [[1, 2]],
    "built": [[1, 2]],
    "box": [40, 30],
    "drive": [0.3] * 13,
    "drive_said": [0.3] * 13,
}
LISTED = [{"species": "gas", "position": [1, 1]}]


@pytest.mark.parametrize("memory", [{"step": 7}, REFERENCES, FORCED, {}])
def test_a_snapshot_that_fits(memory):
    snapshot = {"version": "1", "time": 0, "memory": memory, "tallies": TALLIES}
    scenario = {"container": BOX, "species": [GAS], "particles": LISTED, "snapshot": snapshot}
    assert parse(parse(scenario).to_json()) == parse(scenario)
    turned = {**snapshot, "memory": dict(reversed(memory.items()))}
    assert parse({**scenario, "snapshot": turned}).hash() == parse(scenario).hash()


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("memory", {"position": [[1, 2], [3]]}),
        ("memory", {"position": "here"}),
        ("memory", {"position": [[float("nan"), 2]]}),
        ("memory.step", {"step": 0.5}),
        ("memory.epoch_length", {**REFERENCES, "epoch_length": 0}),
        ("memory.position", {**REFERENCES, "position": [[1, 2], [3, 4]]}),
        ("memory.forced_step", {**FORCED, "forced_step": 0.5}),
        ("memory.position", {**FORCED, "position": [[1, 2], [3, 4]]}),
        ("memory.built", {**FORCED, "built": [[1, 2, 3]]}),
        ("memory.box", {**FORCED, "box": [40]}),
        ("memory.drive", {**FORCED, "drive": 3}),
        ("memory.drive", {key: value for key, value in FORCED.items() if key != "drive"}),
        ("memory.time", {key: value for key, value in REFERENCES.items() if key != "time"}),
        ("tallies.pair_collisions", {**TALLIES, "pair_collisions": [[0.5]]}),
        ("tallies.wall_impulse", {**TALLIES, "wall_impulse": [[-1]] * 4}),
        ("tallies.wall_impulse", {**TALLIES, "wall_impulse": [[1]]}),
        ("tallies.extra", {**TALLIES, "extra": [1]}),
        ("tallies.pair_virial", {}),
        ("time", "now"),
    ],
)
def test_a_snapshot_must_fit_the_gas(path, value):
    good = {"version": "1", "time": 0, "memory": {"step": 1}, "tallies": TALLIES}
    found = problems(None, particles=LISTED, snapshot={**good, path.split(".")[0]: value})
    assert f"snapshot.{path}" in found


def test_a_snapshot_needs_particles():
    snapshot = {"version": "1", "time": 0, "memory": {}, "tallies": TALLIES}
    assert "particles" in problems(None, snapshot=snapshot)
