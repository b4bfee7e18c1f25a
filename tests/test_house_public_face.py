"""The public face: what `import gasbox` offers, its errors, and its version."""

from __future__ import annotations

import doctest
import inspect
import re
from pathlib import Path

import gasbox
from gasbox import errors, version


def test_version_is_the_newest_of_the_changelog(repository: Path) -> None:
    headings = re.findall(r"^## \[(\d[^\]]*)\]", (repository / "CHANGELOG.md").read_text("utf-8"), re.M)
    assert headings[0] == version.__version__
    assert gasbox.__version__ == version.__version__


def test_public_names() -> None:
    assert sorted(gasbox.__all__) == [
        "DynamicsError",
        "FileError",
        "GasboxError",
        "Scenario",
        "ScenarioError",
        "Simulation",
        "UsageError",
        "__version__",
        "load",
        "run",
        "shipped",
    ]
    assert all(hasattr(gasbox, name) for name in gasbox.__all__)


def test_the_example_of_the_package_runs() -> None:
    result = doctest.testmod(gasbox)
    assert result.attempted > 0
    assert result.failed == 0


def test_the_tree_of_errors_shows_every_error() -> None:
    defined = {
        name
        for name, value in vars(errors).items()
        if inspect.isclass(value) and issubclass(value, Exception) and value.__module__ == errors.__name__
    }
    drawn = set(re.findall(r"\b\w+Error\b", str(errors.__doc__)))
    assert drawn == defined
    assert defined <= set(errors.__all__)
    assert all(issubclass(vars(errors)[name], errors.GasboxError) for name in defined)
