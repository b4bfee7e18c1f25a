"""Set-up: the search for a Python, the stamp, the pins, the browser."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import chromium
import set_up

FAKE = '#!/bin/sh\nif [ "$1" = --version ]; then echo "Python {version}"; else echo {answer}; fi\n'


def fake_python(folder: Path, name: str, version: str, new_enough: bool) -> None:
    path = folder / name
    path.write_text(FAKE.format(version=version, answer=new_enough))
    path.chmod(0o755)


def search(repository: Path, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run the search where only `folder` and the shell's own commands are on the path."""
    for command in ("sh", "head"):
        (folder / command).symlink_to(str(shutil.which(command)))
    script = ["sh", str(repository / "scripts" / "find_python.sh")]
    return subprocess.run(script, env={"PATH": str(folder), **environment}, capture_output=True, text=True)


def test_an_old_python_is_refused_with_its_version(repository: Path, tmp_path: Path) -> None:
    fake_python(tmp_path, "python3", "3.9.2", new_enough=False)
    done = search(repository, tmp_path)
    assert done.returncode == 1
    assert "3.11 or later" in done.stderr
    assert "3.9.2" in done.stderr


def test_a_named_python_is_taken_before_all_others(repository: Path, tmp_path: Path) -> None:
    fake_python(tmp_path, "python3.13", "3.13.0", new_enough=True)
    fake_python(tmp_path, "mine", "3.12.1", new_enough=True)
    assert search(repository, tmp_path, PYTHON="mine").stdout == "mine\n"


def test_a_later_python_is_found_beside_an_old_one(repository: Path, tmp_path: Path) -> None:
    fake_python(tmp_path, "python3", "3.9.2", new_enough=False)
    fake_python(tmp_path, "python3.12", "3.12.1", new_enough=True)
    assert search(repository, tmp_path).stdout == "python3.12\n"


def test_the_stamp_holds_until_a_requirement_changes(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    inputs = (tmp_path / "pyproject.toml", tmp_path / "constraints.txt")
    for path in inputs:
        path.write_text("numpy==2.0\n")
    monkeypatch.setattr(set_up, "INPUTS", inputs)
    stamp = tmp_path / "stamp.json"
    assert set_up.installed_extras(stamp) is None
    stamp.write_text(json.dumps({"digest": set_up.digest(), "extras": ["dev"]}))
    assert set_up.installed_extras(stamp) == {"dev"}
    inputs[1].write_text("numpy==2.1\n")
    assert set_up.installed_extras(stamp) is None


@pytest.mark.parametrize("content", ["", "{", "[]", '{"digest": 1}', "null"])
def test_a_damaged_stamp_means_set_up_again(tmp_path: Path, content: str) -> None:
    stamp = tmp_path / "stamp.json"
    stamp.write_text(content)
    assert set_up.installed_extras(stamp) is None


def test_without_ensurepip_the_command_to_run_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(set_up.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(SystemExit, match=r"apt-get install python3\.\d+-venv"):
        set_up.make_venv()


def test_only_a_whole_environment_of_this_place_works(tmp_path: Path) -> None:
    assert not set_up.works(tmp_path / "bin" / "python")
    assert not set_up.works(Path(sys.base_prefix) / "bin" / "python3")


def test_pins_are_names_and_versions_only(repository: Path) -> None:
    lines = (repository / "constraints.txt").read_text("utf-8").splitlines()
    pins = [line for line in lines if not line.startswith("#")]
    assert all(re.fullmatch(r"[a-z0-9-]+==[0-9][0-9a-z.]*", pin) for pin in pins)
    names = [pin.partition("==")[0] for pin in pins]
    assert names == sorted(names)
    assert {"numpy", "numba", "nicegui", "pytest"} <= set(names)


def test_a_browser_can_be_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    browser = tmp_path / "my-browser"
    browser.write_text("#!/bin/sh\n")
    browser.chmod(0o755)
    monkeypatch.setenv("GASBOX_CHROMIUM", str(browser))
    assert chromium.find_chromium() == str(browser)


def test_without_a_browser_the_command_to_run_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chromium.shutil, "which", lambda name: None)
    assert chromium.find_chromium() is None
    assert not chromium.install_chromium()
    assert "install" in chromium.advice()


def test_every_target_is_documented_and_reachable(repository: Path) -> None:
    help_text = subprocess.run(
        ["make", "help"], cwd=repository, capture_output=True, text=True, check=True, env=os.environ
    ).stdout
    for target in ["run", "test", "setup", "lint", "bench", "validate", "screenshots", "lock", "clean"]:
        assert f"make {target} " in help_text
        subprocess.run(["make", "--dry-run", target], cwd=repository, capture_output=True, check=True)


@pytest.mark.parametrize("script", [".ci/run", "scripts/find_python.sh"])
def test_shell_scripts_parse(repository: Path, script: str) -> None:
    subprocess.run(["bash", "-n", str(repository / script)], check=True)
    assert os.access(repository / script, os.X_OK)
