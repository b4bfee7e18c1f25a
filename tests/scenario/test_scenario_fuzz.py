"""Whatever comes in, only the errors of gasbox come out."""

import gzip
import json
from copy import deepcopy

import pytest
from forced_scenarios import FULL
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from molecule_scenarios import FLEXIBLE, FULL_OF_MOLECULES

from gasbox.errors import FileError, ScenarioError, UsageError
from gasbox.scenario import load, parse, shipped, with_settings

pytestmark = pytest.mark.small

LEAVES = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=5)
    | st.sampled_from(["x", "stepped", "rectangle", "circle", "gasbox-scenario/1", 10**400, -0.0, "\ud800"])
)
WORDS = """format seed container width height periodic shape species name radius count temperature velocities region
particles position dynamics kind snapshot memory tallies time gravity histograms color $schema frame_interval
forces thermostat barostat heating units lattice sigma epsilon charge cutoff pairs charges
molecules atoms bonds angles stiffness model scale inertia angle angular_velocity hydrogen"""
KEYS = st.text(max_size=4) | st.sampled_from(WORDS.split())
JSON = st.recursive(
    LEAVES, lambda inner: st.lists(inner, max_size=4) | st.dictionaries(KEYS, inner, max_size=5)
)
FUZZ = settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


def accepts_or_refuses(data):
    try:
        scenario = parse(data)
    except (ScenarioError, FileError) as error:
        message = str(error).replace("\n", "")
    else:
        message = ""
        assert parse(scenario.to_json()) == scenario
    assert message.isprintable()


@FUZZ
@given(JSON)
def test_any_json(data):
    accepts_or_refuses(data)
    accepts_or_refuses(json.dumps(data))


@FUZZ
@given(st.binary(max_size=60), st.booleans())
def test_any_bytes(data, packed):
    accepts_or_refuses(gzip.compress(data) if packed else data)
    accepts_or_refuses(b"\x1f\x8b" + data)


@FUZZ
@given(st.text(max_size=60))
def test_any_text(data):
    accepts_or_refuses(data)


def change_something(scenario, data):
    """Put anything in the place of something, or take it away."""
    place = scenario
    while isinstance(place, dict | list) and place:
        keys = sorted(place) if isinstance(place, dict) else range(len(place))
        key = data.draw(st.sampled_from(keys))
        if not isinstance(place[key], dict | list) or data.draw(st.booleans()):
            if data.draw(st.booleans()):
                place[key] = data.draw(JSON)
            else:
                del place[key]
            break
        place = place[key]


@FUZZ
@given(st.sampled_from(shipped()), st.data())
def test_shipped_scenarios_with_something_changed(name, data):
    scenario = load(name).to_dict()
    change_something(scenario, data)
    accepts_or_refuses(scenario)


@settings(FUZZ, max_examples=400)
@given(st.data())
def test_forces_with_something_changed(data):
    scenario = deepcopy(FULL)
    scenario["species"][0]["lattice"] = 1.1
    change_something(scenario, data)
    accepts_or_refuses(scenario)


@settings(FUZZ, max_examples=400)
@given(st.sampled_from([FULL_OF_MOLECULES, FLEXIBLE]), st.data())
def test_molecules_with_something_changed(scenario, data):
    scenario = deepcopy(scenario)
    change_something(scenario, data)
    accepts_or_refuses(scenario)


@FUZZ
@given(st.sampled_from(shipped()), st.data())
def test_shipped_scenarios_with_damaged_text(name, data):
    text = load(name).to_json()
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, min(len(text), start + 30)))
    accepts_or_refuses(text[:start] + data.draw(st.text(max_size=5)) + text[end:])


@FUZZ
@given(
    st.text(max_size=20) | st.sampled_from(["species.0.count", "species[0]", "particles.0", "..", "seed.x"]),
    st.text(max_size=9),
)
def test_any_setting(path, value):
    try:
        with_settings(load("two-discs"), {path: value})
    except (ScenarioError, UsageError) as error:
        str(error).encode()
