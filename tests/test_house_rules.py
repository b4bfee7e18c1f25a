"""House rules that a machine can check: sizes, names, floors, and what must not stand in a file."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

LONGEST_FILE = 300
DRAWERS = {"utils", "util", "helpers", "helper", "tools", "manager", "managers", "misc", "common"}
CODE = {".py", ".js", ".sh"}
BINARY = {".png", ".gz", ".h5", ".ico", ".woff2"}
# Written in pieces, so that this file passes its own test.
FORBIDDEN = {
    "an address of a package index": r"(pypi|pythonhosted)\.(org|io)|index-" + r"url|find-" + r"links",
    "a path of one machine": r"(?<![\w.:/$~}])/(work|home/\w+|root|Users/\w+)/" + r"\w",
    "another address than this machine's": r"https?://(?!127\.0\.0\.1|localhost)" + r"\d+\.\d+\.\d+\.\d+",
}


def tracked_files(root: Path) -> list[Path]:
    """All files that belong to the repository; in an unpacked archive, all that are no leftovers."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True)
    if listed.returncode == 0 and listed.stdout:
        names = [root / name for name in listed.stdout.split("\0") if name]
    else:
        leftovers = re.compile(r"/(\.\w+_cache|\.venv|\.git|\.hypothesis|\.nicegui|__pycache__|out|dist)/")
        names = [path for path in root.rglob("*") if not leftovers.search(path.as_posix())]
    return [path for path in names if path.is_file()]


def test_no_file_outgrows_its_room(repository: Path) -> None:
    lengths = {
        str(path.relative_to(repository)): len(path.read_text("utf-8").splitlines())
        for path in tracked_files(repository)
        if path.suffix in CODE
    }
    assert {name: length for name, length in lengths.items() if length > LONGEST_FILE} == {}


def test_no_drawers(repository: Path) -> None:
    names = [path.relative_to(repository).with_suffix("") for path in tracked_files(repository)]
    assert [name for name in names if DRAWERS & set(name.parts)] == []


@pytest.mark.parametrize("what", FORBIDDEN)
def test_no_file_names(repository: Path, what: str) -> None:
    pattern = re.compile(FORBIDDEN[what])
    found = [
        f"{path.relative_to(repository)}: {match.group()}"
        for path in tracked_files(repository)
        if path.suffix not in BINARY
        for match in pattern.finditer(path.read_text("utf-8"))
    ]
    assert found == []


def test_forbidden_patterns_can_be_found() -> None:
    assert re.search(FORBIDDEN["an address of a package index"], "https://pypi" + ".org/simple")
    assert re.search(FORBIDDEN["a path of one machine"], 'open("/ho' + 'me/ada/gas.json")')
    assert re.search(FORBIDDEN["another address than this machine's"], "http://" + "10.0.0.7:8080")


def test_imports_point_down() -> None:
    done = subprocess.run(
        [Path(sys.executable).parent / "lint-imports", "--no-cache"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_floor_is_in_the_contract(repository: Path) -> None:
    settings = tomllib.loads((repository / "pyproject.toml").read_text("utf-8"))
    layers = settings["tool"]["importlinter"]["contracts"][0]["layers"]
    named = {name.strip().removeprefix("gasbox.") for layer in layers for name in layer.split("|")}
    package = repository / "src" / "gasbox"
    files = {path.stem for path in package.glob("*.py")}
    folders = {path.parent.name for path in package.glob("*/__init__.py")}
    assert (files | folders) - {"__init__", "__main__"} == named


def test_no_two_test_modules_share_a_name(repository: Path) -> None:
    # pytest imports them all by their bare names, so the second one would be shadowed by the first.
    names = [path.name for path in (repository / "tests").rglob("*.py") if path.name != "conftest.py"]
    assert {name for name in names if names.count(name) > 1} == set()


def test_single_letters_in_kernels_are_explained(repository: Path) -> None:
    table = (repository / "docs" / "model.md").read_text("utf-8").partition("### Symbols")[2]
    explained = set(re.findall(r"`(\w)`", table.partition("\n## ")[0]))
    used = {
        str(name.id if isinstance(name, ast.Name) else name.arg)
        for path in (repository / "src" / "gasbox" / "kernels").rglob("*.py")
        for name in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(name, ast.Name | ast.arg)
    }
    assert {name for name in used if len(name) == 1} - {"_"} <= explained


def test_what_is_imported_is_required(repository: Path) -> None:
    project = tomllib.loads((repository / "pyproject.toml").read_text("utf-8"))["project"]
    wanted = project["dependencies"] + project["optional-dependencies"]["bench"]
    required = {re.split(r"[^\w-]", text)[0].lower() for text in wanted}
    # What NiceGUI and pydantic stand on and hand out, at the versions that they choose.
    required |= {"fastapi", "starlette", "uvicorn", "pydantic_core"}
    imported = {
        name.partition(".")[0]
        for path in (repository / "src").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        for name in imported_names(node)
    }
    assert imported - set(sys.stdlib_module_names) - {"gasbox"} <= required


def imported_names(node: ast.AST) -> list[str]:
    """The modules that a statement imports."""
    if isinstance(node, ast.ImportFrom) and node.level == 0:
        return [str(node.module)]
    return [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
