"""A gas that goes on under the other rule finds its walls where they were."""

import numpy as np
import pytest

import gasbox
from gasbox.errors import ScenarioError
from gasbox.scenario import parse, with_settings


def under_way():
    """A piston and a swinging wall, some time after the start, under the stepped rule."""
    simulation = gasbox.Simulation(
        parse(
            {
                "container": {"width": 40, "height": 20},
                "walls": {"right": {"motion": {"kind": "piston", "mass": 20, "pressure": 0.5}}},
                "obstacles": [
                    {
                        "shape": "segment",
                        "start": [10, 0],
                        "end": [10, 12],
                        "motion": {"kind": "sinusoid", "amplitude": 1, "period": 7},
                    }
                ],
                "species": [{"name": "gas", "radius": 0.4, "count": 60, "temperature": 1}],
                "dynamics": {"kind": "stepped", "time_step": 0.02},
            }
        )
    )
    simulation.advance(until=3.0)
    return simulation


def test_walls_are_where_they_were():
    before = under_way()
    after = gasbox.Simulation(with_settings(before.snapshot(), {"dynamics.kind": "event-driven"}))
    assert before.state.wall_displacement[1] < -0.05
    np.testing.assert_allclose(after.state.wall_displacement, before.state.wall_displacement, atol=1e-12)
    np.testing.assert_allclose(after.state.wall_velocity, before.state.wall_velocity, atol=1e-12)


@pytest.mark.small
def test_remembered_walls_have_their_shape():
    snapshot = under_way().snapshot().to_dict()
    snapshot["snapshot"]["memory"]["walls"].pop()
    with pytest.raises(ScenarioError, match=r"snapshot\.memory\.walls"):
        parse(snapshot)


def test_between_all_dynamics_and_back():
    """A swinging side and a membrane for the second species."""
    step = {"dynamics.time_step": "0.005"}
    kinds = [
        ("event-driven", {}),
        ("forced", step),
        ("stepped", step),
        ("forced", step),
        ("event-driven", {}),
    ]
    simulation = gasbox.Simulation(
        parse(
            {
                "container": {"width": 40, "height": 20},
                "walls": {"right": {"motion": {"kind": "sinusoid", "amplitude": 1, "period": 7}}},
                "obstacles": [
                    {"shape": "segment", "start": [20, 0], "end": [20, 20], "passes": {"species": ["b"]}}
                ],
                "species": [
                    {"name": name, "radius": 0.4, "count": 30, "temperature": 1} for name in ("a", "b")
                ],
                "dynamics": {"kind": "event-driven"},
            }
        )
    )
    for time, (kind, settings) in enumerate(kinds, 1):
        simulation.advance(until=float(time))
        expected = np.sin(2 * np.pi * time / 7)
        assert simulation.state.wall_displacement[1] == pytest.approx(expected, abs=1e-9)
        simulation = gasbox.Simulation(
            with_settings(simulation.snapshot(), {"dynamics.kind": kind, **settings})
        )
        assert simulation.state.wall_displacement[1] == pytest.approx(expected, abs=1e-9)
    assert simulation.dynamics.tallies.wall_passed[4, 1].sum() > 0
