"""Which controls the settings of an epidemic have, and how far their sliders go. Without any page."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from gasbox.scenario.setting import Setting

__all__ = ["GROUPS", "Dial", "Group", "Label", "dials"]

_CASES: Final = 100.0
"""Where sliders of numbers of cases end at least."""
_WIDEST: Final = 100.0
"""Where sliders end that may go to the greatest value, if that is greater."""


@dataclass(frozen=True)
class Label:
    """How a slider is called, and where it ends.

    Attributes
    ----------
    top : its end at first; None: the greatest value
    cases : whether it is a number of cases: whole, and ends at a part of all people
    """

    text: str
    top: float | None = None
    cases: bool = False


@dataclass(frozen=True)
class Group:
    """Settings under one heading.

    Attributes
    ----------
    measure : name in the world's ``active`` that says whether it has begun; empty of what always acts
    strength : setting that is 0 where the measure does nothing all the same; empty if there is none
    labels : name of a setting -> what its slider is called, and where it ends
    """

    title: str
    measure: str
    strength: str
    labels: Mapping[str, Label]


GROUPS: Final[tuple[Group, ...]] = (
    Group(
        "Disease",
        "",
        "",
        {
            "probability_per_day": Label("infection rate", 1.0),
            "probability": Label("infection at contact"),
            "radius": Label("infection radius", 0.0),
            "exposed_days": Label("exposed for", 14.0),
            "infectious_days": Label("infectious for", 20.0),
            "symptomatic": Label("with symptoms"),
            "asymptomatic_infectiousness": Label("infectivity without"),
            "fatality": Label("deaths among them"),
        },
    ),
    Group(
        "Hygiene & distance",
        "distancing",
        "distancing",
        {
            "hygiene": Label("risk left by hygiene"),
            "distancing": Label("keeping distance", 4.0),
            "distancing_fraction": Label("who takes part"),
            "distancing_trigger": Label("begins at cases", cases=True),
        },
    ),
    Group(
        "Quarantine",
        "quarantine",
        "quarantine_probability",
        {
            "quarantine_probability": Label("cases that are found"),
            "quarantine_delay": Label("found after", 10.0),
            "quarantine_trigger": Label("begins at cases", cases=True),
        },
    ),
    Group(
        "Travel & places",
        "travel",
        "",
        {
            "travel_rate": Label("journeys", 0.5),
            "travel_restricted_to": Label("restricted to", 0.5),
            "travel_trigger": Label("restricted at cases", cases=True),
            "central_visits": Label("visits to the centre", 2.0),
            "central_stay": Label("length of a visit", 2.0),
        },
    ),
    Group(
        "Vaccination",
        "",
        "",
        {
            "vaccination_per_day": Label("vaccinated", 0.2),
            "vaccination_efficacy": Label("that protects"),
        },
    ),
)
"""Headings in the order in which they are shown."""


@dataclass(frozen=True)
class Dial:
    """One slider. Its places go from 0 to 1.

    Attributes
    ----------
    low, high : values at its ends
    whole : whether its values are whole numbers
    steep : whether the value goes with the square of the place, so that small values have room
    """

    name: str
    label: str
    setting: Setting
    low: float
    high: float
    steep: bool
    whole: bool = False

    @property
    def unit(self) -> str:
        """As it stands beside the value."""
        return {"1/day": "/ day", "day": "days", "length": ""}.get(self.setting.unit, self.setting.unit)

    @property
    def hint(self) -> str:
        """What it means, with its unit and what it may be."""
        one = self.setting
        unit = f" [{one.unit}]" if one.unit else ""
        return f"{one.meaning[:1].upper()}{one.meaning[1:]}{unit}, from {one.least:g} to {one.greatest:g}"

    def place(self, value: float) -> float:
        """Where the slider stands for a value; values beyond its ends stand at them."""
        share = (value - self.low) / (self.high - self.low)
        share = min(max(share, 0.0), 1.0)
        return round(math.sqrt(share) if self.steep else share, 3)

    def value(self, place: float) -> float:
        """The value for a place of the slider, with no more digits than a hand can mean."""
        share = place * place if self.steep else place
        exact = self.low + share * (self.high - self.low)
        if self.whole:
            return float(round(exact))
        return max(self.setting.least, float(f"{exact:.2g}"))


def dials(
    settings: Mapping[str, Setting], values: Mapping[str, float], people: int
) -> list[tuple[Group, list[Dial]]]:
    """The groups that have any settings, with their sliders.

    Parameters
    ----------
    settings : all that there are, of `Epidemic.SETTINGS`
    values : of those that this epidemic has, at its start
    people : how many there are
    """
    found = [(group, _of_group(group, settings, values, people)) for group in GROUPS]
    known = {name for group in GROUPS for name in group.labels}
    rest = Group(
        "More", "", "", {name: Label(name.replace("_", " ")) for name in values if name not in known}
    )
    found.append((rest, _of_group(rest, settings, values, people)))
    return [(group, mine) for group, mine in found if mine]


def _of_group(
    group: Group, settings: Mapping[str, Setting], values: Mapping[str, float], people: int
) -> list[Dial]:
    return [
        _dial(name, label, settings[name], values[name], people)
        for name, label in group.labels.items()
        if name in values and name in settings
    ]


def _dial(name: str, label: Label, setting: Setting, value: float, people: int) -> Dial:
    low = setting.least if setting.unit != "length" else 0.0
    if label.cases:
        high = min(_rounded_up(max(_CASES, 0.1 * people)), setting.greatest)
        return Dial(name, label.text, setting, low, high, steep=True, whole=True)
    if label.top is None:
        return Dial(name, label.text, setting, low, min(setting.greatest, _WIDEST), steep=False)
    high = min(_rounded_up(max(label.top, 2.5 * value)), setting.greatest)
    return Dial(name, label.text, setting, low, high, steep=name != "radius")


def _rounded_up(value: float) -> float:
    """To 1, 2, or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(unit * power for unit in (1.0, 2.0, 5.0, 10.0) if unit * power >= 0.999999 * value)
