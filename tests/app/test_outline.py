"""What a browser is told of the surroundings."""

from __future__ import annotations

import json

import pytest
from surroundings import DIVIDER, walled

from gasbox.app.outline import outline
from gasbox.geometry import Rectangle

pytestmark = pytest.mark.small


def test_a_plain_rectangle() -> None:
    said = outline(Rectangle(60.0, 40.0, True, False))
    assert said["container"] == {"shape": "rectangle", "width": 60, "height": 40, "periodic": [True, False]}
    assert [wall["name"] for wall in said["walls"]] == list(Rectangle(60.0, 40.0, True, False).wall_names)
    assert said["obstacles"] == []
    assert said["gravity"] == [0.0, 0.0]


@pytest.mark.parametrize(
    ("container", "wanted"),
    [
        ({"shape": "circle", "radius": 20}, {"shape": "circle", "radius": 20}),
        (
            {"shape": "polygon", "vertices": [[0, 0], [40, 0], [20, 30]]},
            {"shape": "polygon", "vertices": [[0, 0], [40, 0], [20, 30]]},
        ),
        ({"shape": "regular-polygon", "sides": 6, "radius": 20}, {"shape": "polygon"}),
    ],
)
def test_other_containers(container: dict[str, object], wanted: dict[str, object]) -> None:
    said = outline(walled((3,), container=container).geometry())
    assert wanted.items() <= said["container"].items()
    assert json.loads(json.dumps(said)) == said


def test_each_kind_of_wall_has_its_look() -> None:
    scenario = walled(
        walls={
            "left": {"temperature": 2.0, "name": "stove"},
            "right": {"motion": {"kind": "piston", "mass": 50, "pressure": 0.3}},
            "top": {"motion": {"kind": "sinusoid", "amplitude": 3, "period": 10}},
        },
        obstacles=[
            DIVIDER,
            {"shape": "segment", "start": [10, 0], "end": [10, 40], "passes": ["kind 0"], "name": "membrane"},
            {"shape": "segment", "start": [40, 10], "end": [40, 30], "open": True, "name": "slit"},
            {"shape": "polygon", "vertices": [[50, 5], [55, 5], [52, 9]]},
            {"shape": "disc", "center": [50, 30], "radius": 4},
        ],
        gravity=[0, -0.1],
    )
    said = outline(scenario.geometry())
    walls = {wall["name"]: wall for wall in said["walls"]}
    assert walls["stove"]["temperature"] == 2.0
    assert walls["right"]["motion"] == "piston"
    assert walls["right"]["handle"]
    assert walls["right"]["normal"] == [1.0, 0.0]
    assert walls["top"]["motion"] == "driven"
    assert walls["top"]["reach"] == pytest.approx([-3.0, 3.0])
    assert [walls[name]["line"] for name in ("divider", "membrane", "slit")] == ["solid", "dotted", "dashed"]
    assert walls["divider"]["handle"]
    assert "handle" not in walls["membrane"]
    assert [one["shape"] for one in said["obstacles"]] == ["segment", "segment", "segment", "polygon", "disc"]
    assert [one["wall"] for one in said["obstacles"]] == [4, 5, 6, 7, 8]
    assert said["gravity"] == [0.0, -0.1]
