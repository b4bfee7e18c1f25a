"""Epidemics in crowds, for tests."""

import numpy as np

from gasbox.scenario import STAGES, parse
from gasbox.simulation import Simulation

AREA, RADIUS = 100.0, 2.0


SHORT = ("susceptible", "infectious", "recovered")


def per_pair(r0, people, radius=RADIUS):
    """Rate at which one person infects another one nearby, of whom there are few in a circle."""
    return r0 * AREA / ((people - 1) * np.pi * radius**2)


def stirred(r0, people, interval=0.1, radius=RADIUS):
    """R0 of `mixed`: in each look who is near is infected with 1 - exp(-h), not h, h being rate times interval.

    Who escapes k infectious people, each of whom is near with a probability a, does so with (1 - a (1 - exp(-h)))^k.
    """
    h = per_pair(r0, people, radius) * interval
    return r0 * -np.expm1(-h) / h


def mixed(r0, law, people, seed, ill=1, interval=0.1, stages=SHORT, radius=RADIUS, **world):
    """A crowd in which everybody is somewhere else at each look; one day is the mean infectious time."""
    count = {"susceptible": people - ill, "infectious": ill}
    rate = per_pair(r0, people, radius)
    return parse(
        {
            "container": {"width": 10, "height": 10, "periodic": ["x", "y"]},
            "species": [{"name": name, "radius": 0.001, "count": count.get(name, 0)} for name in stages],
            # Four steps between two looks, each over almost half of the box and in a new direction.
            "dynamics": {
                "kind": "walk",
                "time_step": interval / 4,
                "speed": 4.7 / (interval / 4),
                "turning": 5.0 / (interval / 4),
            },
            "world": {
                "kind": "epidemic",
                "transmission": {"by": "closeness", "radius": radius, "probability_per_day": rate},
                "infectious": {"law": law, "mean": 1.0},
                "interval": interval,
                **world,
            },
            "seed": seed,
        }
    )


def fixed_time_course(r0, seeds, days):
    """Infectious part of the people on some days; each is infectious for one day: s' = -R0 s i, by short steps."""
    steps = 1000
    s = np.full(steps + 1 + round(max(days) * steps), 1.0 - seeds)  # from one day before the start
    i = np.zeros_like(s)
    i[steps] = seeds
    for k in range(steps, s.size - 1):
        s[k + 1] = s[k] * np.exp(-r0 * i[k] / steps)
        i[k + 1] = s[k + 1 - steps] - s[k + 1] + (seeds if k + 1 < 2 * steps else 0.0)
    return i[np.round(np.asarray(days) * steps).astype(int) + steps]


def slow(people, seed, speed, rate=0.2, **world):
    """A town of 10 x 10 with walls, where a day is 1 and everybody is infectious for 5 days."""
    return parse(
        {
            "container": {"width": 10, "height": 10},
            "species": [
                {
                    "name": name,
                    "radius": 0.001,
                    "count": {"susceptible": people - 10, "infectious": 10}.get(name, 0),
                }
                for name in STAGES
            ],
            "dynamics": {"kind": "walk", "time_step": 0.1, "speed": speed, "turning": 1, "reach": 1.2},
            "world": {
                "kind": "epidemic",
                "transmission": {"by": "closeness", "radius": 0.8, "probability_per_day": rate},
                "exposed": {"law": "fixed", "mean": 0.2},
                "infectious": {"law": "fixed", "mean": 5},
                **world,
            },
            "seed": seed,
        }
    )


def to_the_end(scenario, longest=400.0):
    """The simulation, once nobody is infected any more."""
    simulation = Simulation(scenario)
    while simulation.time < longest and not simulation.world.summary()["over"]:
        simulation.advance(until=simulation.time + 2.0)
    return simulation


def attack_rate(scenario):
    """Part of the susceptible who are infected in the end."""
    return to_the_end(scenario).world.summary()["attack_rate"]
