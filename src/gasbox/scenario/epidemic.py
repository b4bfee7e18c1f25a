"""An epidemic among people who move about."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import ConfigDict, Field, Strict

from gasbox.scenario.epidemic_settings import SETTINGS
from gasbox.scenario.setting import Setting
from gasbox.scenario.species import Region
from gasbox.scenario.values import GREATEST, LEAST, NotNegative, Positive, Section

__all__ = [
    "ByCloseness",
    "ByContact",
    "Central",
    "Distancing",
    "Duration",
    "Epidemic",
    "Quarantine",
    "Travel",
    "Vaccination",
]

Share = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0, le=1)]
"""A part of a whole, or a probability."""
Shape = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0.01, le=1000)]
Days = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=LEAST, le=GREATEST)]


class ByCloseness(Section):
    """Whoever is near an infectious person is infected at a steady rate."""

    model_config = ConfigDict(json_schema_extra={"required": ["by"]})

    by: Literal["closeness"] = "closeness"
    """How the disease passes on."""
    radius: Positive = 1.0
    """As near as that [length]."""
    probability_per_day: NotNegative = 0.2
    """Rate of infection by each infectious person within the radius [1/day]: over a short part of a day, the
    probability is as much of it."""


class ByContact(Section):
    """Whoever collides with an infectious person is infected with a probability."""

    model_config = ConfigDict(json_schema_extra={"required": ["by"]})

    by: Literal["contact"] = "contact"
    """How the disease passes on."""
    probability: Share = 0.2
    """Of infection in each collision of hard discs."""


class Duration(Section):
    """How long a stage of the disease lasts, from one person to the next."""

    law: Literal["fixed", "exponential", "gamma"] = "fixed"
    """Its distribution: the same for all, exponential, or gamma."""
    mean: Days = 5.0
    """Its mean [day]."""
    shape: Shape = 4.0
    """Of a gamma distribution: its mean squared over its variance."""


class Distancing(Section):
    """People keep away from each other."""

    strength: Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0, le=20)] = 0.0
    """How firmly they turn away from each other within `dynamics.reach`; 0 not at all, 1 as fast as they walk."""
    fraction: Share = 1.0
    """Of the people, who take part."""
    trigger: NotNegative = 0.0
    """It begins once so many have symptoms at a time, and stays."""


class Quarantine(Section):
    """Who falls ill with symptoms may be found, and is then kept apart until the infection is over."""

    probability: Share = 0.0
    """That one who has symptoms is found."""
    delay: NotNegative = 1.0
    """From the first symptoms until then [day]."""
    trigger: NotNegative = 0.0
    """It begins once so many have symptoms at a time, and stays."""
    box: Region | None = None
    """Where they are kept; without it they stand where they are, and infect nobody either."""


class Travel(Section):
    """People move to another room."""

    rate: NotNegative = 0.0
    """Journeys of one person [1/day]."""
    restricted_to: NotNegative = 0.0
    """The same, once travel is restricted [1/day]."""
    trigger: NotNegative = 0.0
    """Travel is restricted once so many have symptoms at a time, and stays so; 0: never."""


class Central(Section):
    """A place in the middle of each room that people visit, such as a market."""

    visits: NotNegative = 0.0
    """Of one person [1/day]."""
    stay: NotNegative = 0.5
    """How long each lasts, the way not counted [day]."""
    size: Share = 0.1
    """Width of the place over that of the room."""


class Vaccination(Section):
    """Makes susceptible people immune."""

    before: Share = 0.0
    """Part of the susceptible people who are vaccinated at the start."""
    per_day: NotNegative = 0.0
    """Rate at which each of the others is vaccinated [1/day]."""
    efficacy: Share = 1.0
    """Probability that a vaccination makes immune; otherwise it has no effect, and is not repeated."""


class Epidemic(Section):
    """An epidemic among people who move about: its stages are the species of the same names."""

    model_config = ConfigDict(json_schema_extra={"required": ["kind"]})
    SETTINGS: ClassVar[Mapping[str, Setting]] = SETTINGS
    """What can be set while it runs, by a schedule or on the page."""

    kind: Literal["epidemic"] = "epidemic"
    """Kind of world."""
    day: Positive = 1.0
    """Simulated time of a day [time]."""
    interval: Positive | None = None
    """Simulated time between two looks at who infects whom; without it, the time step, or a hundredth of a day
    [time]."""
    transmission: Annotated[ByCloseness | ByContact, Field(discriminator="by")] = ByCloseness()
    """How the disease passes from one to another."""
    exposed: Duration = Duration()
    """Time from infection until one infects others; only with a species `exposed`."""
    infectious: Duration = Duration()
    """Time during which one infects others."""
    symptomatic: Share = 1.0
    """Part of the infected who get symptoms; the others are of the species `asymptomatic`."""
    asymptomatic_infectiousness: Share = 1.0
    """Of those without symptoms, over that of those with."""
    fatality: Share = 0.0
    """Part of those with symptoms who die of it, at the end of the infectious time."""
    hygiene: Share = 1.0
    """Factor on the probability of infection: below 1, people take care."""
    distancing: Distancing = Distancing()
    """How people keep away from each other."""
    quarantine: Quarantine = Quarantine()
    """The ill are kept apart."""
    travel: Travel = Travel()
    """Journeys between rooms."""
    central: Central = Central()
    """A place that people visit."""
    vaccination: Vaccination = Vaccination()
    """Vaccination, before and during the epidemic."""

    def values(self) -> dict[str, float]:
        """Name of a setting -> its value at the start; those that this transmission does not know are left out."""
        said = {
            "hygiene": self.hygiene,
            "infectious_days": self.infectious.mean,
            "exposed_days": self.exposed.mean,
            "symptomatic": self.symptomatic,
            "asymptomatic_infectiousness": self.asymptomatic_infectiousness,
            "fatality": self.fatality,
            "vaccination_per_day": self.vaccination.per_day,
            "vaccination_efficacy": self.vaccination.efficacy,
            "distancing": self.distancing.strength,
            "distancing_fraction": self.distancing.fraction,
            "distancing_trigger": self.distancing.trigger,
            "quarantine_probability": self.quarantine.probability,
            "quarantine_delay": self.quarantine.delay,
            "quarantine_trigger": self.quarantine.trigger,
            "travel_rate": self.travel.rate,
            "travel_restricted_to": self.travel.restricted_to,
            "travel_trigger": self.travel.trigger,
            "central_visits": self.central.visits,
            "central_stay": self.central.stay,
        }
        match self.transmission:
            case ByCloseness(radius=radius, probability_per_day=probability):
                return {"probability_per_day": probability, "radius": radius, **said}
            case ByContact(probability=probability):
                return {"probability": probability, **said}
