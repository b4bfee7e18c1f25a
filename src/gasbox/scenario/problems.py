"""From pydantic's errors to problems that name the path, what was found and what is allowed."""

from __future__ import annotations

import difflib
import json
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from pydantic_core import ErrorDetails

from gasbox.errors import Problem
from gasbox.scenario.values import LEAST

__all__ = ["KnownKeys", "near", "path_of", "short", "translate"]

KnownKeys = Mapping[tuple[str, ...], tuple[str, ...]]
"""Path without indices -> the keys known there."""

_UNIONS: Final[Mapping[str, tuple[str, ...]]] = {
    "dynamics": ("stepped", "event-driven", "forced", "walk"),
    "container": ("rectangle", "circle", "polygon", "regular-polygon"),
    "obstacles": ("segment", "polygon", "disc"),
    "motion": ("constant", "path", "sinusoid", "piston"),
    "thermostat": ("langevin", "velocity-rescaling", "aim", "off"),
    "barostat": ("aim", "off"),
    "world": ("pong", "epidemic", "demon"),
    "transmission": ("closeness", "contact"),
}
"""Key of a union -> its tags. pydantic puts the tag into the location; a person never wrote it there."""
_TAGS: Final = frozenset(tag for tags in _UNIONS.values() for tag in tags)


def short(value: Any, bare: bool = False) -> str:
    """`value` on one line of at most 60 printable characters; strings in quotes unless `bare`."""
    if bare and isinstance(value, str):
        text = value
    elif isinstance(value, dict):
        text = "an object" if value else "an empty object"
    elif isinstance(value, list | tuple) and len(value) > 6:
        text = f"a list of {len(value)}"
    else:
        try:
            text = json.dumps(value, ensure_ascii=False)
        except (TypeError, ValueError, RecursionError):
            text = type(value).__name__
    text = "".join(letter if letter.isprintable() else "?" for letter in text[:200])
    return text if len(text) <= 60 else f"{text[:57]}..."


def path_of(location: Iterable[int | str]) -> str:
    """``("species", 1, "radius")`` as ``species[1].radius``."""
    path = ""
    for step in location:
        path += f"[{step}]" if isinstance(step, int) else f".{short(step, bare=True)}"
    return path.removeprefix(".")


def near(word: str, known: Iterable[str]) -> str:
    """``(did you mean "radius"?)`` if `word` looks like one that is known; otherwise empty."""
    matches = difflib.get_close_matches(word[:100].lower(), list(known), n=2, cutoff=0.6)
    return f" (did you mean {' or '.join(map(json.dumps, matches))}?)" if matches else ""


def translate(error: ErrorDetails, known: KnownKeys) -> Problem:
    """One error of pydantic as a `Problem`."""
    location = _without_tags(error["loc"])
    path = path_of(location)
    kind, context = error["type"], error.get("ctx", {})
    if kind == "missing":
        return Problem(path, "nothing", "is required")
    if kind == "extra_forbidden":
        place = tuple(step for step in location[:-1] if isinstance(step, str))
        # The names of walls are keys of a scenario's own making.
        keys = known.get(place[:1] + place[2:] if place[:1] == ("walls",) else place, ())
        return Problem(path, "an unknown key", f"known: {', '.join(keys)}{near(str(location[-1]), keys)}")
    if kind == "union_tag_not_found":
        return Problem(f"{path}.{_tag(context)}", "nothing", f"must be one of {_tags_of(location)}")
    if kind == "union_tag_invalid":
        return Problem(f"{path}.{_tag(context)}", short(context.get("tag")), f"must be {_expected(context)}")
    return Problem(path, short(error["input"]), _allowed(kind, context, error["msg"]))


def _without_tags(location: tuple[int | str, ...]) -> tuple[int | str, ...]:
    """The location without tags: one follows the key of a union, or the index of an entry."""
    return tuple(
        step
        for place, step in enumerate(location)
        if not (
            step in _TAGS
            and place
            and (location[place - 1] in _UNIONS or isinstance(location[place - 1], int))
        )
    )


def _tag(context: dict[str, Any]) -> str:
    return str(context.get("discriminator", "kind")).strip("'")


def _expected(context: dict[str, Any]) -> str:
    return str(context.get("expected_tags")).replace("'", '"')


def _tags_of(location: tuple[int | str, ...]) -> str:
    """All tags of a union for which none was given."""
    key = next(step for step in reversed(location) if isinstance(step, str))
    return ", ".join(json.dumps(tag) for tag in _UNIONS[key] if tag not in ("aim", "off"))


def _allowed(kind: str, context: dict[str, Any], message: str) -> str:
    rule = _RULES.get(kind)
    return rule(context) if rule else message[:1].lower() + message[1:]


def _at_least(context: dict[str, Any]) -> str:
    least = context["ge"]
    return f"must be greater than 0 (at least {LEAST:g})" if least == LEAST else f"must be at least {least:g}"


def _literal(context: dict[str, Any]) -> str:
    return "must be " + str(context["expected"]).replace("'", '"')


_RULES: Final[dict[str, Callable[[dict[str, Any]], str]]] = {
    "float_type": lambda _: "must be a number",
    "int_type": lambda _: "must be a whole number",
    "int_from_float": lambda _: "must be a whole number",
    "string_type": lambda _: "must be text",
    "string_unicode": lambda _: "must be text of valid characters",
    "tuple_type": lambda _: "must be a list",
    "list_type": lambda _: "must be a list",
    "dict_type": lambda _: "must be an object {...}",
    "model_type": lambda _: "must be an object {...}",
    "model_attributes_type": lambda _: "must be an object {...}",
    "finite_number": lambda _: "must be a finite number",
    "greater_than_equal": _at_least,
    "greater_than": lambda context: f"must be greater than {context['gt']:g}",
    "less_than_equal": lambda context: f"must be at most {context['le']:g}",
    "less_than": lambda context: f"must be less than {context['lt']:g}",
    "literal_error": _literal,
    "string_pattern_mismatch": lambda _: 'must be a colour like "#4c9be8"',
    "string_too_short": lambda context: f"must have at least {context['min_length']} character",
    "string_too_long": lambda context: f"must have at most {context['max_length']} characters",
    "too_short": lambda context: f"must have at least {context['min_length']}",
    "too_long": lambda context: f"must have at most {context['max_length']}",
    "value_error": lambda context: str(context.get("error", "is not allowed")),
}
