"""Single fields are changed by their path."""

import pytest

from gasbox.errors import ScenarioError, UsageError
from gasbox.scenario import load, with_settings

pytestmark = pytest.mark.small


def test_values_are_json_or_else_text():
    changed = with_settings(
        load("three-gases"),
        {
            "species.0.count": "500",
            "species[1].name": "middling",
            "container.periodic": '["x"]',
            "title": "12 monkeys",
            "seed": "3",
            "histograms.maximum": "null",
        },
    )
    assert changed.species[0].count == 500
    assert changed.species[1].name == "middling"
    assert changed.container.periodic == ("x",)
    assert changed.title == "12 monkeys"
    assert changed.seed == 3
    assert changed.histograms.maximum is None
    assert changed.species[2] == load("three-gases").species[2]


def test_a_section_that_was_absent():
    assert with_settings(load("one-gas"), {"species.0.region.x": "[0, 180]"}).species[0].region.x == (0, 180)


def test_listed_particles_stay_and_change():
    changed = with_settings(load("two-discs"), {"particles.0.velocity": "[0.2, 0]"})
    assert changed.particles.velocity.tolist() == [[0.2, 0.0], [-0.1, 0.0]]
    assert with_settings(load("two-discs"), {"seed": "9"}).particles == load("two-discs").particles


def test_nothing_changed_is_the_same():
    assert with_settings(load("brownian"), {}) == load("brownian")


@pytest.mark.parametrize(
    "path", ["species.7.count", "species.x.count", "title.x", "species.-1.count", "seed.0"]
)
def test_paths_that_lead_nowhere(path):
    with pytest.raises(UsageError, match="has"):
        with_settings(load("three-gases"), {path: "1"})


@pytest.mark.parametrize(
    ("path", "value"), [("sed", "1"), ("species.0.count", "many"), ("species.0.speed", "1")]
)
def test_bad_values_are_problems_of_the_scenario(path, value):
    with pytest.raises(ScenarioError):
        with_settings(load("three-gases"), {path: value})
