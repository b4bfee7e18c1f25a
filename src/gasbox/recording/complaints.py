"""What HDF5 says about a file, in plain sentences."""

from __future__ import annotations

import errno
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from gasbox.errors import FileError

__all__ = ["is_hdf5", "reading", "refuse_foreign", "refuse_full_disk", "writing"]

_SIGNATURE: Final = b"\x89HDF\r\n\x1a\n"

_SPARE_BYTES: Final = 2**25
"""What HDF5 may need beside the frames: chunks that are begun, and its own tables."""
_IN_USE: Final = (errno.EAGAIN, errno.EACCES)


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Turns what goes wrong while writing to `path` into a FileError."""
    try:
        yield
    except (OSError, RuntimeError) as error:
        raise FileError(f"cannot write the recording {path}: {_reason(error)}") from None


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
            raise FileError(f"cannot read the recording {path}: {_reason(error)}") from None
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


def refuse_full_disk(path: Path, size: int) -> None:
    """Stop before the disk is full: HDF5 leaves a damaged file when it cannot write what it began.

    Parameters
    ----------
    size : of what is to be written [byte]

    Raises
    ------
    FileError
    """
    free = shutil.disk_usage(path).free
    if free < 2 * size + _SPARE_BYTES:
        left = f"only {free / 2**20:.0f} MiB are left on the disk"
        raise FileError(f"{path}: {left}, too little to go on recording; what was written before is intact")


def _reason(error: OSError | RuntimeError) -> str:
    text, number = str(error), getattr(error, "errno", None)
    if number in _IN_USE and "lock" in text:
        return "another program has it open (is it still being written?)"
    if number in (errno.EACCES, errno.EPERM):
        return "permission denied"
    # HDF5 tells a story of several lines, with the system's own words somewhere inside.
    told = re.search(r"error message = '([^']*)'", text)
    return told[1] if told else text.partition("\n")[0]
