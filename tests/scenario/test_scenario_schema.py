"""The JSON Schema describes every field and knows every key."""

import pytest

from gasbox.scenario import Scenario, load, schema, shipped

pytestmark = pytest.mark.small


def objects(part):
    if isinstance(part, dict):
        if "properties" in part:
            yield part
        for value in part.values():
            yield from objects(value)
    elif isinstance(part, list):
        for value in part:
            yield from objects(value)


def test_every_field_is_described():
    described = schema()
    found = list(objects(described))
    assert len(found) >= 9
    for entry in found:
        assert entry["additionalProperties"] is False
        for name, field in entry["properties"].items():
            assert "description" in field or "description" in field.get("items", {}), name


def test_every_key_is_known():
    described = schema()
    assert set(described["properties"]) == {
        field.alias or name for name, field in Scenario.model_fields.items()
    }
    for name in shipped():
        assert set(load(name).to_dict()) <= set(described["properties"])
    assert described["required"] == ["container"]
    assert described["anyOf"] == [{"required": ["species"]}, {"required": ["molecules"]}]


def test_ranges_are_those_of_json_schema():
    described = schema()["$defs"]
    count = described["Species"]["properties"]["count"]
    assert (count["type"], count["minimum"], count["maximum"]) == ("integer", 0, 10_000_000)
    assert described["RectangleContainer"]["properties"]["width"]["minimum"] > 0
    assert described["Stepped"]["required"] == ["kind"]
