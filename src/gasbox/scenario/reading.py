"""Reads scenarios: from text, from files, from the shipped ones."""

from __future__ import annotations

import gzip
import io
import json
import zlib
from pathlib import Path
from typing import Any, Final

from gasbox.errors import FileError, Problem, ScenarioError
from gasbox.scenario.problems import near, short
from gasbox.scenario.scenario import Scenario

__all__ = ["load", "parse", "shipped"]

_SHIPPED: Final = Path(__file__).parent / "shipped"
_GZIP: Final = b"\x1f\x8b"
_LARGEST: Final = 4 * 2**30
"""Most bytes [byte] of a text; a compressed file can hold a thousand times its size."""


def shipped() -> tuple[str, ...]:
    """Names of the scenarios that come with gasbox."""
    return tuple(sorted(path.stem for path in _SHIPPED.glob("*.json")))


def load(name_or_path: str | Path) -> Scenario:
    """The scenario of that name among the shipped ones, or in that file (``.json``, ``.json.gz``).

    Raises
    ------
    FileError
        There is no such name or file, or it cannot be read.
    ScenarioError
        With all problems of the file.
    """
    if isinstance(name_or_path, str) and name_or_path in shipped():
        path = _SHIPPED / f"{name_or_path}.json"
    else:
        path = Path(name_or_path)
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        names = ", ".join(shipped())
        likely = near(path.stem, shipped())
        raise FileError(
            f"there is no file {short(str(name_or_path))} and no shipped scenario of that name{likely}; "
            f"shipped: {names}"
        ) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise FileError(f"cannot read {short(str(name_or_path))}: {reason}") from None
    return parse(data, source=str(name_or_path))


def parse(data: str | bytes | dict[str, Any], source: str = "scenario", largest: int = _LARGEST) -> Scenario:
    """The scenario that a text, the bytes of a file (compressed or not) or a dictionary holds.

    Parameters
    ----------
    source : how messages call it
    largest : most bytes that a compressed text may unpack to

    Raises
    ------
    FileError
        The compressed data are damaged or too large.
    ScenarioError
        With all problems.
    """
    try:
        return Scenario.model_validate(
            _decode(data, source, largest) if isinstance(data, str | bytes) else data
        )
    except ScenarioError as error:
        raise ScenarioError(error.problems, source) from None
    except RecursionError:
        raise ScenarioError(
            [Problem("", "lists in lists in lists", "is nested too deeply")], source
        ) from None


def _decode(data: str | bytes, source: str, largest: int) -> Any:
    if isinstance(data, bytes) and data.startswith(_GZIP):
        data = _unpack(data, source, largest)
    try:
        text = data if isinstance(data, str) else data.decode("utf-8-sig")
        return json.loads(text, parse_constant=_refuse_constant, object_pairs_hook=_without_doubles)
    except UnicodeDecodeError:
        raise ScenarioError([Problem("", "bytes that are no text", "must be JSON text in UTF-8")]) from None
    except json.JSONDecodeError as error:
        found = f"at line {error.lineno}, column {error.colno}: {error.msg}"
        raise ScenarioError([Problem("", found, "must be JSON text")]) from None
    except ValueError as error:
        # Python refuses to read numbers of thousands of digits.
        raise ScenarioError([Problem("", short(str(error), bare=True), "must be JSON text")]) from None


def _unpack(data: bytes, source: str, largest: int) -> bytes:
    try:
        with gzip.GzipFile(fileobj=io.BytesIO(data)) as file:
            text = file.read(largest + 1)
    except (OSError, EOFError, zlib.error) as error:
        raise FileError(f"{source}: the compressed data are damaged: {error}") from None
    if len(text) > largest:
        raise FileError(f"{source}: unpacks to more than {largest} bytes")
    return text


def _refuse_constant(name: str) -> Any:
    raise ScenarioError([Problem("", name, "JSON has no such number; all numbers must be finite")])


def _without_doubles(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    entries = dict(pairs)
    if len(entries) < len(pairs):
        keys = [key for key, _ in pairs]
        double = next(key for key in keys if keys.count(key) > 1)
        raise ScenarioError(
            [Problem("", f"the key {short(double)} twice in one object", "each key only once")]
        )
    return entries
