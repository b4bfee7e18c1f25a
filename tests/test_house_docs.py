"""What the documentation says is so: its Python and its commands run, its links and tests exist."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from gasbox.state import FIELDS

ROOT = Path(__file__).resolve().parent.parent
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "benchmarks/README.md")),
    *sorted((ROOT / "docs").glob("*.md")),
]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.M | re.S)
SHOWN_ONLY = ("lab", "bench")
"""Commands that open a page or take minutes: their options are checked, they are not run."""


def blocks(*languages: str) -> list[Any]:
    """All fenced blocks in one of these languages, named by page and number."""
    return [
        pytest.param(text, id=f"{page.name}-{number}")
        for page in PAGES
        for number, (language, text) in enumerate(BLOCK.findall(page.read_text("utf-8")))
        if language in languages
    ]


def commands() -> list[Any]:
    """All lines of shell blocks, without their comments, split into words."""
    lines = [line for block in blocks("sh") for line in block.values[0].splitlines()]
    split = [shlex.split(line, comments=True) for line in lines]
    return [pytest.param(words, id=shlex.join(words)) for words in split if words]


@pytest.mark.parametrize("snippet", blocks("python"))
def test_python_snippet_runs(snippet: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    exec(compile(snippet, "snippet", "exec"), {"__name__": "snippet"})


@pytest.mark.parametrize("snippet", blocks("sh"))
def test_shell_snippet_runs(snippet: str, tmp_path: Path) -> None:
    lines = [shorter(line) for line in snippet.splitlines() if runs(line)]
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    script = ["bash", "-e", "-o", "pipefail", "-c", "\n".join(lines)]
    done = subprocess.run(
        script, cwd=tmp_path, env={**os.environ, "PATH": path}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


def runs(line: str) -> bool:
    """Whether a line of a shell block is run by the tests: gasbox's own commands that come to an end."""
    words = shlex.split(line, comments=True)
    return len(words) > 1 and words[0] == "gasbox" and words[1] not in SHOWN_ONLY


def shorter(line: str) -> str:
    """The same command; if it sweeps its usual grid, which takes minutes of both cores, over a few points."""
    words = shlex.split(line, comments=True)
    if words[1] == "phase-diagram" and "--points" not in words:
        words += ["--points", "2x2", "--particles", "60"]
    return shlex.join(words)


@pytest.mark.parametrize("words", commands())
def test_command_exists(words: list[str]) -> None:
    if words[0] == "gasbox" and words[1:2] in (["lab"], ["bench"]):
        command = [str(Path(sys.executable).parent / "gasbox"), words[1], "--help"]
        help_text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        assert [word for word in words if word.startswith("--") and word not in help_text] == []
    elif words[0] == "make":
        target = [word for word in words if "=" not in word]
        subprocess.run([*target, "--dry-run"], cwd=ROOT, capture_output=True, check=True)


@pytest.mark.parametrize("text", blocks("json"))
def test_json_is_a_scenario(text: str) -> None:
    from gasbox.scenario import parse

    assert parse(text).species


def anchors(page: Path) -> set[str]:
    """The names under which a page's headings can be linked."""
    headings = re.findall(r"^#+ (.*)$", page.read_text("utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    text = page.read_text("utf-8")
    links = re.findall(r"\]\(([^)\s:]+)\)|src(?:set)?=\"([^\":]+)\"", text)
    for target, _, anchor in (link.partition("#") for pair in links for link in pair if link):
        place = page.parent / target if target else page
        assert place.exists(), target
        assert not anchor or anchor in anchors(place), f"{target}#{anchor}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_tests_that_are_named_exist(page: Path) -> None:
    files = list((ROOT / "tests").rglob("test_*.py"))
    defined = {name for path in files for name in re.findall(r"def (test_\w+)", path.read_text("utf-8"))}
    defined |= {path.stem for path in files}
    defined |= {path.relative_to(ROOT).as_posix() for path in (ROOT / "tests").rglob("*.py")}
    named = re.findall(r"`(?:(tests/[\w/]+\.py)(?:::)?)?(test_\w+)?(?:\.py)?`", page.read_text("utf-8"))
    assert [name for pair in named for name in pair if name and name not in defined] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_that_are_named_exist(page: Path) -> None:
    named = re.findall(
        r"`((?:src|tests|scripts|docs|[a-z_]+)/[\w./-]*\w\.(?:py|sh|md|json|yml))`", page.read_text("utf-8")
    )
    places = (ROOT, ROOT / "src" / "gasbox")
    assert [name for name in named if not any((place / name).exists() for place in places)] == []


def test_table_of_fields() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text("utf-8")
    for field in FIELDS:
        shape = "(n, 2)" if field.shape else "(n,)"
        assert f"| `{field.name}` | {shape} | {field.dtype} | {field.unit or '-'} | {field.meaning} |" in text
