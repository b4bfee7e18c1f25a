"""Make `.venv` in the repository's root and install gasbox into it, unless that has been done.

    python3 scripts/set_up.py [EXTRA ...]

A stamp inside `.venv` says what was installed from which pyproject.toml and constraints.txt. It is written
last, so an interrupted set-up is simply done again. Standard library only: nothing else is there yet.
"""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
STAMP = VENV / "gasbox-set-up.json"
CONSTRAINTS = ROOT / "constraints.txt"
INPUTS = (ROOT / "pyproject.toml", CONSTRAINTS)


def venv_python(venv: Path = VENV) -> Path:
    """The interpreter inside the virtual environment."""
    return venv / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def digest(root: Path = ROOT) -> str:
    """What an installation depends on: the requirements, the pins, and where the repository lies."""
    content = hashlib.sha256(str(root).encode())
    for path in INPUTS:
        content.update(path.read_bytes())
    return content.hexdigest()


def installed_extras(stamp: Path = STAMP) -> set[str] | None:
    """The extras that are installed, or None if the stamp is missing, damaged or of other requirements."""
    try:
        noted = json.loads(stamp.read_text("utf-8"))
        return set(noted["extras"]) if noted["digest"] == digest() else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def works(python: Path) -> bool:
    """Whether the virtual environment's own interpreter starts, is new enough, lies here, and has pip."""
    check = (
        "import importlib.util, sys; sys.exit(sys.version_info < (3, 11) "
        f"or sys.prefix != {str(VENV)!r} or importlib.util.find_spec('pip') is None)"
    )
    try:
        return subprocess.run([python, "-c", check], capture_output=True).returncode == 0
    except OSError:
        return False


def make_venv() -> None:
    """A fresh `.venv`; where Python has no `ensurepip` (Debian, Ubuntu), stop with the command to run."""
    if importlib.util.find_spec("ensurepip") is None or importlib.util.find_spec("venv") is None:
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        sys.exit(
            f"This Python {version} cannot make virtual environments: it lacks `venv` or `ensurepip`.\n"
            f"On Debian and Ubuntu, as root or with sudo:  apt-get install python{version}-venv\n"
            "Then run make again."
        )
    print("Making .venv ...", flush=True)
    subprocess.run([sys.executable, "-m", "venv", "--clear", VENV], check=True)


def install(extras: set[str]) -> None:
    """Install the project, editable, at the pinned versions."""
    what = f"{ROOT}[{','.join(sorted(extras))}]" if extras else str(ROOT)
    pip = [venv_python(), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    print("Installing gasbox and what it needs (a minute or two, once) ...", flush=True)
    subprocess.run([*pip, "-c", CONSTRAINTS, "-e", what], check=True)


def main(extras: set[str]) -> None:
    """Bring `.venv` up to date, doing only what is missing."""
    present = installed_extras()
    usable = works(venv_python())
    if usable and present is not None and extras <= present:
        return
    STAMP.unlink(missing_ok=True)
    if not usable:
        make_venv()
        present = None
    wanted = extras | (present or set())
    install(wanted)
    STAMP.write_text(json.dumps({"digest": digest(), "extras": sorted(wanted)}) + "\n", "utf-8")


if __name__ == "__main__":
    try:
        main(set(sys.argv[1:]))
    except subprocess.CalledProcessError as error:
        sys.exit(f"Set-up failed: {' '.join(map(str, error.cmd))} (exit status {error.returncode}).")
    except KeyboardInterrupt:
        sys.exit("Set-up interrupted; run make again to go on.")
