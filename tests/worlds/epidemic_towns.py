"""Scenarios of people, for tests."""

from gasbox.scenario import STAGES, parse

BUSY = {
    "exposed": {"law": "gamma", "mean": 1, "shape": 3},
    "infectious": {"law": "gamma", "mean": 3},
    "symptomatic": 0.7,
    "asymptomatic_infectiousness": 0.5,
    "fatality": 0.1,
    "distancing": {"strength": 2, "fraction": 0.5, "trigger": 20},
    "quarantine": {"probability": 0.5, "delay": 0.5, "trigger": 5, "box": {"x": [20.5, 23], "y": [4, 8]}},
    "travel": {"rate": 0.2, "restricted_to": 0.05, "trigger": 30},
    "central": {"visits": 0.3, "stay": 0.3, "size": 0.2},
    "vaccination": {"before": 0.1, "per_day": 0.01, "efficacy": 0.8},
}


def town(stages=STAGES, ill=5, people=150, seed=3, **more):
    """Two rooms side by side in which all measures are taken."""
    counts = {"susceptible": people - ill, "infectious": ill}
    given = {
        "container": {"width": 23.5, "height": 12},
        "species": [
            {"name": name, "radius": 0.1, "count": counts.get(name, 0), "region": {"x": [0, 20]}}
            for name in stages
        ],
        "dynamics": {
            "kind": "walk",
            "time_step": 0.05,
            "speed": 6,
            "reach": 1.5,
            "rooms": {"columns": 2, "gap": 1, "region": {"x": [0, 20]}},
        },
        "world": {
            "kind": "epidemic",
            "transmission": {"by": "closeness", "radius": 1, "probability_per_day": 1.0},
            **BUSY,
        },
        "seed": seed,
    }
    return parse({**given, **more})


def world(**more):
    """The section of the epidemic, with some of it replaced."""
    return {**town().to_dict()["world"], **more}


def discs(**more):
    """Hard discs that infect by contact."""
    return parse(
        {
            "container": {"width": 20, "height": 14},
            "species": [
                {"name": "susceptible", "radius": 0.3, "count": 60, "temperature": 1},
                {"name": "infectious", "radius": 0.3, "count": 4, "temperature": 1},
                {"name": "recovered", "radius": 0.3},
            ],
            "dynamics": {"kind": "event-driven"},
            "world": {
                "kind": "epidemic",
                "interval": 0.25,
                "transmission": {"by": "contact", "probability": 0.5},
                "infectious": {"law": "exponential", "mean": 5},
            },
            "frame_interval": 0.5,
            "seed": 3,
            **more,
        }
    )
