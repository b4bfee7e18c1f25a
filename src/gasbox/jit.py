"""How kernels are compiled: one decorator, one cache folder per state of the sources that a kernel is made of.

numba's own cache does not notice that a helper in *another* file has changed, and would leave the old helper inside
its cached caller. The cache folder of a kernel is therefore named by a hash of its file and of all files of kernels
that this one imports, directly or not: what has nothing to do with a change is not compiled again.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
import numba.core.config

if sys.platform != "win32":
    import fcntl

__all__ = [
    "bare_kernel",
    "cache_folder",
    "inlined_kernel",
    "is_compiling",
    "kernel",
    "mark_compiled",
    "was_compiled",
]

_Function = TypeVar("_Function", bound=Callable[..., Any])
_config: Any = numba.core.config
_njit: Any = numba.njit  # its annotations leave out options that it takes
_KERNEL_FOLDER = Path(__file__).parent / "kernels"
_IMPORTS = re.compile(
    rb"^\s*(?:from (gasbox\.kernels[\w.]*) import|import (gasbox\.kernels[\w.]*))", re.MULTILINE
)


def _cache_root() -> Path:
    if "GASBOX_CACHE" in os.environ:
        return Path(os.environ["GASBOX_CACHE"])
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", str(Path.home()))) / "gasbox"
    return Path(os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))) / "gasbox"


@functools.cache
def _sources() -> dict[str, tuple[bytes, tuple[str, ...]]]:
    """Module -> its source, and the modules of kernels that it names in imports."""
    found = {}
    for path in sorted(_KERNEL_FOLDER.rglob("*.py")):
        parts = ("gasbox", *path.relative_to(_KERNEL_FOLDER.parent).with_suffix("").parts)
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        source = path.read_bytes()
        named = _IMPORTS.findall(source)
        found[name] = source, tuple(sorted({module.decode() for pair in named for module in pair if module}))
    return found


def _made_of(module: str) -> list[str]:
    """A module of kernels, and all that it imports, directly or not; of any other module, all kernels there are."""
    sources = _sources()
    if module not in sources:
        return sorted(sources)
    found, waiting = {module}, [module]
    while waiting:
        for named in sources[waiting.pop()][1]:
            # `from gasbox.kernels import x` may mean the package or a module in it: a module's name comes whole.
            fresh = {one for one in sources if one == named or named.startswith(f"{one}.")} - found
            found |= fresh
            waiting += fresh
    return sorted(found)


@functools.cache
def cache_folder(module: str = "") -> Path:
    """The folder of the compiled kernels of a module, named by a hash of its sources and of numba's version.

    Without a module, that of all kernels together, where it is noted that they have been compiled.
    """
    digest = hashlib.sha256(f"{numba.__version__} {sys.version_info[:2]}".encode())
    digest.update(Path(__file__).read_bytes())
    for name in _made_of(module):
        digest.update(name.encode())
        digest.update(_sources()[name][0])
    return _cache_root() / f"kernels-{digest.hexdigest()[:16]}"


def kernel(function: _Function) -> _Function:
    """Compile `function` without fast-math (bits matter), cached, and with the GIL released."""
    return _compiled(function)


def bare_kernel(function: _Function) -> _Function:
    """As `kernel`, for the inner loops of the engines: arrays are not reference-counted.

    The atomic counts cost more than half the time of an engine whose small functions hand arrays on. Such a kernel
    calls only others of its kind and must not allocate (no new arrays, no sort).
    """
    return _compiled(function, _nrt=False)


def inlined_kernel(function: _Function) -> _Function:
    """As `bare_kernel`, for small functions that shall become part of their callers."""
    return _compiled(function, _nrt=False, forceinline=True)


def _compiled(function: _Function, **options: bool) -> _Function:
    if _config.DISABLE_JIT:
        return function
    previous = _config.CACHE_DIR
    _config.CACHE_DIR = str(cache_folder(function.__module__))
    try:
        compiled = _njit(cache=True, nogil=True, error_model="numpy", **options)(function)
    finally:
        _config.CACHE_DIR = previous
    save = compiled._cache.save_overload

    def save_alone(*arguments: Any) -> None:
        with _alone(cache_folder(function.__module__)):
            save(*arguments)

    compiled._cache.save_overload = save_alone
    return cast(_Function, compiled)


@contextlib.contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Keep other processes from writing to the cache.

    numba reads the index of a function, adds to it and writes it back. Two processes that did so at once, for
    different types of argument, could leave an index that names the code of the other type.
    """
    with (folder / "lock").open("w") as file:
        if sys.platform != "win32":
            # Where a file system knows no locks, go on without.
            with contextlib.suppress(OSError):
                fcntl.flock(file, fcntl.LOCK_EX)
        yield


def is_compiling() -> bool:
    """Whether kernels are compiled; False where NUMBA_DISABLE_JIT leaves them plain Python."""
    return not _config.DISABLE_JIT


def _mark() -> Path:
    # numba keeps the code of each place where the sources stand apart.
    place = hashlib.sha256(str(_KERNEL_FOLDER).encode()).hexdigest()[:8]
    return cache_folder() / f"compiled-{place}"


def was_compiled() -> bool:
    """Whether `mark_compiled` was reached for these kernel sources on this machine."""
    return not is_compiling() or _mark().exists()


def mark_compiled() -> None:
    """Note that all kernels have been compiled and cached."""
    if is_compiling():
        _mark().parent.mkdir(parents=True, exist_ok=True)
        _mark().touch()
