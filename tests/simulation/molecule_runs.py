"""Small gases of molecules that every dynamics can run."""

from __future__ import annotations

from typing import Any

from gasbox.scenario import Scenario, parse

DYNAMICS: dict[str, dict[str, Any]] = {
    "stepped": {"kind": "stepped", "time_step": 0.01},
    "event-driven": {"kind": "event-driven"},
    "forced": {"kind": "forced", "time_step": 0.002},
}
BOX = {"width": 24, "height": 20, "periodic": ["x", "y"]}
BENT = {
    "name": "bent",
    "atoms": [
        {"position": [0, 0], "mass": 4, "radius": 0.6},
        {"position": [0.8, 0.4], "radius": 0.4},
        {"position": [-0.8, 0.4], "species": "disc"},
    ],
    "bonds": [{"atoms": [0, 1]}, {"atoms": [0, 2]}],
    "count": 20,
    "temperature": 1,
}
SPRING = {
    "name": "spring",
    "atoms": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 1]}],
    "bonds": [{"atoms": [0, 1], "stiffness": 200}, {"atoms": [1, 2], "stiffness": 200}],
    "angles": [{"atoms": [0, 1, 2], "stiffness": 20}],
    "count": 6,
    "temperature": 1,
}


def molecular(kind: str, *molecules: dict[str, Any], **more: Any) -> Scenario:
    """Molecules (bent ones if none are given) and single discs."""
    return parse(
        {
            "seed": 3,
            "container": BOX,
            "species": [{"name": "disc", "radius": 0.5, "count": 10, "temperature": 1}],
            "molecules": list(molecules) or [BENT],
            "dynamics": DYNAMICS[kind],
            "frame_interval": 0.1,
            **more,
        }
    )
