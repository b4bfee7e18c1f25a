"""Scenarios are read from text, files and names; what is written reads back as the same."""

import gzip
import json
import time

import numpy as np
import pytest

from gasbox.errors import FileError, ScenarioError
from gasbox.scenario import Particles, Scenario, load, parse, shipped

GOOD = {
    "container": {"width": 40, "height": 30, "periodic": ["y", "x"]},
    "species": [
        {"name": "a", "count": 3, "temperature": 0.5},
        {"name": "b", "mass": 2, "radius": 0.5, "count": 2, "velocities": [[1, 2], [0.1, -0.0]]},
        {"name": "c", "count": 1, "speed": 2, "region": {"x": [0, 20]}},
    ],
    "particles": [
        {"species": "a", "position": [1, 0.1]},
        {"species": "b", "position": [9, 9], "velocity": [1, 1]},
    ],
    "dynamics": {"kind": "stepped", "time_step": 0.1},
    "frame_interval": 0.3,
    "histograms": {"bins": 10, "maximum": 3, "quantity": "energy"},
    "seed": 5,
}


@pytest.mark.small
@pytest.mark.parametrize("name", shipped())
def test_shipped_scenarios_read_back_as_the_same(name):
    scenario = load(name)
    again = parse(scenario.to_json())
    assert again == scenario
    assert again.hash() == scenario.hash()
    assert again.to_json() == scenario.to_json()


@pytest.mark.small
@pytest.mark.parametrize("name", shipped())
def test_shipped_scenarios_say_what_to_watch_for(name):
    scenario = load(name)
    assert scenario.title
    assert scenario.watch_for.endswith(".")
    assert scenario.frame_interval is not None


@pytest.mark.small
def test_the_promised_scenarios_are_shipped():
    promised = {
        "two-discs",
        "three-gases",
        "one-gas",
        "brownian",
        "equal-speeds",
        "hot-and-cold",
        "ten-thousand",
    }
    assert promised <= set(shipped())


@pytest.mark.small
def test_two_discs_is_the_worked_example():
    scenario = load("two-discs")
    _, position, velocity = scenario.particles.arrays([species.name for species in scenario.species])
    assert position.tolist() == [[19.9, 20.0], [21.5, 21.4]]
    assert velocity.tolist() == [[0.1, 0.0], [-0.1, 0.0]]
    assert scenario.dynamics.kind == "stepped"
    assert scenario.dynamics.time_step == 1.0
    assert [species.radius for species in scenario.species] == [1.0, 1.0]


@pytest.mark.small
def test_round_trip_of_every_field():
    scenario = parse(GOOD)
    assert parse(scenario.to_json()) == scenario
    assert parse(scenario.to_dict()) == scenario
    assert Scenario(**GOOD) == scenario
    assert scenario.container.periodic == ("x", "y")
    assert scenario.to_dict()["species"][1]["velocities"] == [[1.0, 2.0], [0.1, -0.0]]


@pytest.mark.small
def test_objects_and_columns_say_the_same():
    columns = {"species": ["a", "b"], "position": [[1, 0.1], [9, 9]], "velocity": [[0, 0], [1, 1]]}
    assert parse({**GOOD, "particles": columns}) == parse(GOOD)
    assert parse({**GOOD, "particles": columns}).hash() == parse(GOOD).hash()


@pytest.mark.small
def test_hash_depends_on_what_is_said_and_not_on_the_order_of_keys():
    scenario = parse(GOOD)
    turned = parse(json.dumps(dict(reversed(GOOD.items()))))
    assert turned.hash() == scenario.hash()
    assert parse({**GOOD, "$schema": "anywhere"}).hash() == scenario.hash()
    assert parse({**GOOD, "seed": 6}).hash() != scenario.hash()


@pytest.mark.small
def test_species_without_a_colour_get_different_ones():
    colors = [species.color for species in parse(GOOD).species]
    assert len(set(colors)) == 3


@pytest.mark.small
def test_snapshot_floats_read_back_to_the_same_bits():
    random = np.random.default_rng(3)
    position, velocity = (
        random.random((20, 2)) * 30,
        random.standard_normal((20, 2)) * 10.0 ** random.integers(-30, 30, (20, 2)),
    )
    memory = {
        "epoch": 3,
        "epoch_length": 64.0,
        "position": random.standard_normal((20, 2)) * 1e-7,
        "velocity": random.standard_normal((20, 2)) * 1e7,
        "time": random.random(20),
    }
    tallies = {
        "pair_virial": [0.1 + 0.2],
        "pair_collisions": [[1, 2, 3], [0, 1, 2], [0, 0, 9]],
        "wall_impulse": random.random((4, 3)).tolist(),
        "wall_collisions": np.ones((4, 3), int).tolist(),
    }
    scenario = parse(
        {
            **GOOD,
            "particles": Particles.of(["a", "b"] * 10, position, velocity),
            "snapshot": {"version": "0.1.0", "time": 0.1 + 0.7, "memory": memory, "tallies": tallies},
        }
    )
    again = parse(scenario.to_json())
    assert again == scenario
    assert again.particles.velocity.tobytes() == velocity.tobytes()
    assert again.particles.position.tobytes() == position.tobytes()
    assert again.snapshot.memory["position"].tobytes() == memory["position"].tobytes()
    assert again.snapshot.memory["epoch"] == 3
    assert again.snapshot.tallies == tallies
    assert again.snapshot.time == 0.1 + 0.7


@pytest.mark.small
def test_files_plain_and_compressed(tmp_path):
    text = parse(GOOD).to_json()
    plain, packed = tmp_path / "gas.json", tmp_path / "gas.json.gz"
    plain.write_text(text, encoding="utf-8")
    packed.write_bytes(gzip.compress(text.encode()))
    assert load(plain) == load(str(packed)) == parse(GOOD)
    (tmp_path / "marked.json").write_bytes(b"\xef\xbb\xbf" + text.encode())
    assert load(tmp_path / "marked.json") == parse(GOOD)


@pytest.mark.small
def test_a_missing_file_names_what_is_near():
    with pytest.raises(FileError, match=r'did you mean "three-gases"\?'):
        load("tree-gases")
    with pytest.raises(FileError, match=r"shipped: .*brownian"):
        load("nothing/of/the/kind.json")


@pytest.mark.small
def test_unreadable_files(tmp_path):
    with pytest.raises(FileError, match="cannot read"):
        load(tmp_path)
    with pytest.raises(FileError, match="cannot read"):
        load("a\0b")
    broken = tmp_path / "broken.json.gz"
    broken.write_bytes(gzip.compress(b"{" * 1000)[:20])
    with pytest.raises(FileError, match="damaged"):
        load(broken)


@pytest.mark.small
def test_a_small_file_may_not_unpack_to_a_huge_one():
    with pytest.raises(FileError, match="unpacks to more than 1000 bytes"):
        parse(gzip.compress(b" " * 100_000), largest=1000)


@pytest.mark.small
def test_the_source_is_named(tmp_path):
    path = tmp_path / "mine.json"
    path.write_text("{}")
    with pytest.raises(ScenarioError, match=r"mine\.json: 2 problems"):
        load(path)


def test_a_million_listed_particles_take_seconds():
    count = 1_000_000
    random = np.random.default_rng(1)
    columns = {
        "species": ["a", "b"] * (count // 2),
        "position": (random.random((count, 2)) * [40, 30]).tolist(),
        "velocity": random.standard_normal((count, 2)).tolist(),
    }
    gas = {**GOOD, "species": [{"name": "a"}, {"name": "b"}]}
    began = time.process_time()
    scenario = parse({**gas, "particles": columns})
    species, position, _ = scenario.particles.arrays(["a", "b"])
    assert time.process_time() - began < 5
    assert species[:4].tolist() == [0, 1, 0, 1]
    assert position.tolist() == columns["position"]
    began = time.process_time()
    text = scenario.to_json()
    again = parse(text)
    assert time.process_time() - began < 20
    assert again.particles == scenario.particles
