"""What can be set in an epidemic while it runs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from gasbox.scenario.setting import Setting

__all__ = ["OF_CLOSENESS", "OF_CONTACT", "OF_EXPOSED", "OF_VACCINATION", "OF_WALKERS", "SETTINGS"]

_MANY: Final = 1e6
_CASES: Final = "people with symptoms at a time"

SETTINGS: Final[Mapping[str, Setting]] = {
    "probability_per_day": Setting("rate of infection within the radius", 0.0, 100.0, "1/day"),
    "radius": Setting("radius of infection", 1e-6, 1e6, "length"),
    "probability": Setting("probability of infection in a contact", 0.0, 1.0),
    "hygiene": Setting("factor on the probability of infection", 0.0, 1.0),
    "infectious_days": Setting("mean infectious time, of who is infected from now on", 0.01, 1000.0, "day"),
    "exposed_days": Setting("mean time until one is infectious, likewise", 0.01, 1000.0, "day"),
    "symptomatic": Setting("part of the infected with symptoms", 0.0, 1.0),
    "asymptomatic_infectiousness": Setting("infectiousness without symptoms, over that with", 0.0, 1.0),
    "fatality": Setting("part of those with symptoms who die", 0.0, 1.0),
    "vaccination_per_day": Setting("rate of vaccination", 0.0, 100.0, "1/day"),
    "vaccination_efficacy": Setting("probability that a vaccination makes immune", 0.0, 1.0),
    "distancing": Setting("how firmly people keep away from each other", 0.0, 20.0),
    "distancing_fraction": Setting("part of the people who do so", 0.0, 1.0),
    "distancing_trigger": Setting(f"{_CASES} from which on they do", 0.0, _MANY),
    "quarantine_probability": Setting("probability that one with symptoms is found", 0.0, 1.0),
    "quarantine_delay": Setting("time until then", 0.0, 1000.0, "day"),
    "quarantine_trigger": Setting(f"{_CASES} from which on they are looked for", 0.0, _MANY),
    "travel_rate": Setting("journeys of one person", 0.0, 100.0, "1/day"),
    "travel_restricted_to": Setting("the same, once travel is restricted", 0.0, 100.0, "1/day"),
    "travel_trigger": Setting(f"{_CASES} from which on it is; 0 never", 0.0, _MANY),
    "central_visits": Setting("visits of one person to the central place", 0.0, 100.0, "1/day"),
    "central_stay": Setting("how long a visit lasts", 0.0, 1000.0, "day"),
}

OF_CLOSENESS: Final = frozenset({"probability_per_day", "radius"})
"""Settings of transmission by closeness alone."""
OF_CONTACT: Final = frozenset({"probability"})
"""Settings of transmission by contact alone."""
OF_WALKERS: Final = frozenset(
    name for name in SETTINGS if name.startswith(("distancing", "quarantine", "travel", "central"))
)
"""Settings that only people under dynamics "walk" can follow."""
OF_EXPOSED: Final = frozenset({"exposed_days"})
"""Settings that need a species "exposed"."""
OF_VACCINATION: Final = frozenset({"vaccination_per_day", "vaccination_efficacy"})
"""Settings that need a species "vaccinated"."""
