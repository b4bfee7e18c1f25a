"""Many epidemics: what is drawn of them, and the theory beside it."""

from __future__ import annotations

import math
from typing import Any

import pytest

from gasbox.cli.ensemble_epidemic import well_mixed
from gasbox.cli.ensemble_figure import figure_of
from gasbox.cli.ensemble_run import Outcome
from gasbox.scenario import Scenario, parse
from gasbox.simulation import Simulation
from gasbox.sweep import Member, ensemble, gathered, plan_for, spread

DENSITY = 0.25


def town(people: int = 400, r0: float = 2.0, ill: int = 1, **world: Any) -> Scenario:
    """People who change places so fast that they are well mixed: each crosses the town in a tenth of an infection."""
    side = math.sqrt(people / DENSITY)
    rate = r0 / (DENSITY * math.pi * 4.0 * 5.0)
    return parse(
        {
            "container": {"width": side, "height": side, "periodic": ["x", "y"]},
            "species": [
                {"name": "susceptible", "radius": 0.2, "count": people - ill},
                {"name": "infectious", "radius": 0.2, "count": ill},
                {"name": "recovered", "radius": 0.2},
            ],
            "dynamics": {"kind": "walk", "time_step": 0.05, "speed": 80, "turning": 1},
            "world": {
                "kind": "epidemic",
                "transmission": {"by": "closeness", "radius": 2.0, "probability_per_day": rate},
                "infectious": {"law": "exponential", "mean": 5},
                **world,
            },
        }
    )


def several(scenario: Scenario, seeds: int, until: float) -> tuple[Any, Outcome]:
    plan = plan_for(Simulation(scenario, threads=1), until=until)
    members = list(ensemble(plan, range(1, seeds + 1)))
    assert all(isinstance(one, Member) for one in members)
    return plan, Outcome(seeds, gathered(members, plan.times), [], False, 1.0)


def test_theory_is_that_of_the_town() -> None:
    law = well_mixed(town(people=1000))
    assert law is not None
    assert law.r0 == pytest.approx(2.0)
    assert law.size == pytest.approx(0.7968, abs=2e-3)  # one of a thousand is ill at the start
    assert law.size_deviation == pytest.approx(0.913 / math.sqrt(1000), rel=2e-3)
    assert law.peak == pytest.approx(0.1534, abs=1e-3)
    assert law.extinction == pytest.approx(0.5)
    assert law.growth == pytest.approx(0.2)


def test_where_theory_does_not_hold_nothing_is_marked() -> None:
    assert well_mixed(town(distancing={"strength": 1.0})) is None
    assert well_mixed(town(hygiene=0.5)) is not None
    unlike = well_mixed(town(infectious={"law": "fixed", "mean": 5}))
    assert unlike is not None
    assert math.isnan(unlike.peak)
    small = well_mixed(town(r0=0.8))
    assert small is not None
    assert math.isnan(small.growth)


def test_sizes_are_those_of_a_well_mixed_crowd() -> None:
    plan, outcome = several(town(ill=8), 24, 150.0)
    law, found = well_mixed(plan.scenario), outcome.found
    assert law is not None
    assert found.values["world.over"].all()
    assert found.values["time"].max() < 150.0
    told = spread(found.values["world.attack_rate"][found.values["world.major"] > 0])
    assert told.runs >= 22
    assert abs(told.mean - law.size) < 4.0 * law.size_deviation / math.sqrt(told.runs)
    # Of n values, a standard deviation is known to 1/sqrt(2 (n - 1)); the law is that of many people.
    assert told.standard_deviation == pytest.approx(law.size_deviation, rel=4.0 / math.sqrt(2 * told.runs))


def test_the_figure_shows_all_people_and_only_major_outbreaks() -> None:
    plan, outcome = several(town(people=60, ill=1), 8, 60.0)
    figure = figure_of(plan, outcome)
    major = outcome.found.values["world.major"] > 0
    assert 0 < major.sum() < 8
    assert f"{8 - major.sum()} of 8 outbreaks stayed small" in figure.get_suptitle()
    assert "well mixed 50 %" in figure.get_suptitle()
    people, ill, *piles = figure.get_axes()
    assert people.get_xlabel() == "time [day]"
    assert ill.get_ylabel() == "infected people"
    medians = [line.get_ydata() for line in people.lines if str(line.get_label()).endswith("median")]
    assert [line[0] for line in medians] == [59, 1, 0]
    assert medians[2][-1] > 6
    sizes = piles[0].patches[0].get_data().values
    assert sizes.sum() == major.sum()
