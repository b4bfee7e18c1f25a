"""What is drawn of many epidemics, and what theory says of a crowd that is well mixed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gasbox.cli.ensemble_report import headline
from gasbox.cli.ensemble_run import Outcome
from gasbox.plots import Fan, Mark, Pile, ensemble_figure
from gasbox.scenario import Epidemic, Scenario, places_of
from gasbox.simulation import Simulation
from gasbox.sweep import Gathered, Plan
from gasbox.theory import epidemic as theory

__all__ = ["WellMixed", "epidemic_figure", "well_mixed"]

_INFECTED: Final = ("exposed", "infectious", "asymptomatic")
_OVER: Final = ("recovered", "dead")
_MEASURES: Final = (
    "vaccination_per_day",
    "distancing",
    "quarantine_probability",
    "central_visits",
)
"""Settings that are zero where people do nothing about it."""
_ORANGE: Final = "#e0605e"


@dataclass(frozen=True)
class WellMixed:
    """What theory says of the same epidemic among people who are well mixed and do nothing about it.

    Attributes
    ----------
    r0 : basic reproduction number
    size, size_deviation : part of the susceptible who are infected in a major outbreak, and its standard deviation
    peak : greatest part of the people infected at a time; nan where people are exposed first, or times not exponential
    extinction : probability that it dies out early; nan if some infect more than others
    growth : at first [1/day]; nan if nothing grows
    """

    r0: float
    size: float
    size_deviation: float
    peak: float
    extinction: float
    growth: float


def well_mixed(scenario: Scenario) -> WellMixed | None:
    """What theory says.

    None where people do something about it or live in several rooms, and where it passes on in collisions.
    """
    world = scenario.world
    assert isinstance(world, Epidemic)
    values = world.values()
    started = Simulation(scenario, threads=1).world
    told = {} if started is None else started.summary()
    r0 = told.get("r0_well_mixed")
    plain = not scenario.schedule and not any(values.get(name) for name in _MEASURES)
    if r0 is None or not plain or not told["people"] or len(places_of(scenario).rooms) > 1:
        return None
    people, ill = told["people"], told["final_size"]
    susceptible = told["counts"].get("susceptible", 0) / people
    mild, weak = 1.0 - world.symptomatic, world.asymptomatic_infectiousness
    mean = world.symptomatic + mild * weak
    square = world.symptomatic + mild * weak**2
    law = world.infectious
    spread = {"fixed": 0.0, "exponential": 1.0, "gamma": 1.0 / law.shape}[law.law]
    variation = math.sqrt((1.0 + spread) * square / mean**2 - 1.0) if mean else 0.0
    size = theory.final_size(r0, susceptible, ill / people) / susceptible if susceptible else 0.0
    alike = weak == 1.0 or mild == 0.0
    waits = "exposed" in told["counts"] and world.exposed.mean > 0.0
    exposed = (world.exposed.mean, world.exposed.law, world.exposed.shape) if waits else None
    return WellMixed(
        r0,
        size,
        theory.final_size_deviation(r0, people, variation) if r0 > 1.0 and susceptible > 0.9 else math.nan,
        theory.peak_infected(r0, susceptible) if not waits and law.law == "exponential" else math.nan,
        theory.extinction_probability(r0, law.law, ill, law.shape) if alike else math.nan,
        theory.epidemic_growth(r0, law.mean, law.law, law.shape, exposed) if r0 > 1.0 else math.nan,
    )


def epidemic_figure(plan: Plan, outcome: Outcome) -> Figure:
    """Who is susceptible, infected and over it in time; size, peak and growth of major outbreaks beside theory."""
    found, scenario = outcome.found, plan.scenario
    world = scenario.world
    assert isinstance(world, Epidemic)
    law, major = well_mixed(scenario), found.values["world.major"] > 0.0
    title = f"{headline(plan, outcome)}\n{_extinct(major, law)}"
    color = {kind.name: kind.color for kind in scenario.kinds}
    fans = [
        Fan("susceptible", color.get("susceptible", "#4c9be8"), _sum(found, ("susceptible",))),
        Fan("infected", color.get("infectious", _ORANGE), _sum(found, _INFECTED)),
        Fan("recovered or dead", color.get("recovered", "#7f8c8d"), _sum(found, _OVER)),
    ]
    shown = _until_over(found)
    # Of outbreaks that are small one half of the time, a median over all would show nothing.
    rows = major if np.any(major) else ~major
    fans = [Fan(fan.name, fan.color, fan.values[rows, shown]) for fan in fans]
    return ensemble_figure(
        found.times[shown] / world.day,
        [("people", fans), ("infected people", [fans[1]])],
        _piles(found, major, law),
        title,
        "day",
    )


def _until_over(found: Gathered) -> slice:
    """The times up to the end of the last outbreak."""
    last = float(np.max(found.values["time"]))
    return slice(max(int(np.searchsorted(found.times, last)) + 2, 2))


def _extinct(major: NDArray[np.bool_], law: WellMixed | None) -> str:
    """How many never became an epidemic."""
    small = int(np.sum(~major))
    share = f"{100 * small / major.size:.3g} %"
    if law is not None and math.isfinite(law.extinction):
        share += f"; well mixed {100 * law.extinction:.3g} %"
    return f"{small} of {major.size} outbreaks stayed small ({share}); the others are shown"


def _sum(found: Gathered, names: tuple[str, ...]) -> NDArray[np.float64]:
    nothing = np.zeros((found.seeds.size, found.times.size))
    return np.asarray(np.sum([found.series.get(name, nothing) for name in names], axis=0))


def _piles(found: Gathered, major: NDArray[np.bool_], law: WellMixed | None) -> list[Pile]:
    """Numbers that are told of major outbreaks alone have no value in the others."""

    def of_major(name: str) -> NDArray[np.float64]:
        return np.where(major, found.values[f"world.{name}"], math.nan)

    law = law or WellMixed(*[math.nan] * 6)
    size = _marks("Kermack and McKendrick", law.size, law.size_deviation)
    peak = _marks("well mixed", law.peak)
    over = np.where(found.values["world.over"] > 0.0, of_major("days"), math.nan)
    return [
        Pile("part infected in the end", "", of_major("attack_rate"), size),
        Pile("greatest part infected at a time", "", of_major("peak_fraction"), peak),
        Pile("day of the peak", "day", of_major("peak_day")),
        Pile("R of the first tenth", "", of_major("r0_estimate"), _marks("well mixed", law.r0)),
        Pile("growth at first", "1/day", of_major("growth_per_day"), _marks("well mixed", law.growth)),
        Pile("day when it was over", "day", over),
    ]


def _marks(name: str, value: float, deviation: float = math.nan) -> list[Mark]:
    """A mark with its value in its name, if there is one."""
    return [Mark(f"{name} {value:.3g}", value, deviation)] if math.isfinite(value) else []
