"""What HDF5 says about a file, in plain sentences."""

from __future__ import annotations

import errno
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from gasbox.errors import FileError

__all__ = ["is_hdf5", "reading", "refuse_foreign", "writing"]

_SIGNATURE: Final = b"\x89HDF\r\n\x1a\n"

_IN_USE: Final = (errno.EAGAIN, errno.EACCES)


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Turns what goes wrong while writing to `path` into a FileError."""
    try:
        yield
    except OSError as error:
        raise FileError(f"cannot write the recording {path}: {_reason(error, path)}") from None


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Turns what goes wrong while reading `path` into a FileError."""
    try:
        yield
    except FileNotFoundError:
        raise FileError(f"there is no file {path}") from None
    except IsADirectoryError:
        raise FileError(f"{path} is a folder, not a recording") from None
    except (OSError, KeyError, ValueError, RuntimeError, TypeError, AttributeError) as error:
        if isinstance(error, OSError) and (error.errno is not None or "unable to lock" in str(error)):
            raise FileError(f"cannot read the recording {path}: {_reason(error, path)}") from None
        raise FileError(f"the recording {path} is damaged or cut short: {error}") from None


def is_hdf5(path: Path) -> bool:
    """Whether the file begins as HDF5 files do; a damaged one still does."""
    with path.open("rb") as file:
        return file.read(len(_SIGNATURE)) == _SIGNATURE


def refuse_foreign(path: Path) -> None:
    """A recording may replace a recording, but no other file: a slip of the keyboard costs no scenario.

    Raises
    ------
    FileError
        Something that is not HDF5 stands there, or its folder is missing.
    """
    if path.is_dir():
        raise FileError(f"cannot write the recording {path}: it is a folder")
    if not path.parent.is_dir():
        raise FileError(f"cannot write the recording {path}: there is no folder {path.parent}")
    if path.is_file() and path.stat().st_size and not is_hdf5(path):
        raise FileError(f"{path} exists and is not a recording; choose another name or delete it")


def _reason(error: OSError, path: Path) -> str:
    if error.errno in _IN_USE and "lock" in str(error):
        return "another program has it open (is it still being written?)"
    if error.errno == errno.ENOSPC:
        return "no space is left on the disk"
    if error.errno in (errno.EACCES, errno.EPERM):
        return "permission denied"
    return str(error)
