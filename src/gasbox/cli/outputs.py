"""Where results may be written: checked before a run, not after hours of it."""

from __future__ import annotations

from pathlib import Path

from gasbox.errors import FileError, UsageError

__all__ = ["check_figure", "check_outputs", "check_place"]

_SNAPSHOT_ENDINGS = (".json", ".json.gz")
_FIGURE_ENDINGS = (".png", ".svg", ".pdf")


def check_outputs(source: Path, record: Path | None, snapshot: Path | None, resuming: bool) -> None:
    """Refuse outputs that would replace what is read, or could not be written.

    Parameters
    ----------
    source : the file that is read
    resuming : whether `source` is a snapshot or recording; a snapshot may be replaced by a later one

    Raises
    ------
    FileError, UsageError
    """
    if record is not None and _is_same(record, source):
        raise UsageError(f"--record would replace {source}, which this run starts from; choose another name")
    if snapshot is None:
        return
    if not resuming and _is_same(snapshot, source):
        raise UsageError(f"--snapshot would replace the scenario {source}; choose another name")
    if not snapshot.name.endswith(_SNAPSHOT_ENDINGS):
        raise UsageError(f"--snapshot {snapshot}: a snapshot ends in {' or '.join(_SNAPSHOT_ENDINGS)}")
    check_place(snapshot)


def check_figure(path: Path) -> None:
    """Refuse a figure that could not be written.

    Raises
    ------
    FileError, UsageError
    """
    if path.suffix not in _FIGURE_ENDINGS:
        raise UsageError(f"{path}: a figure ends in {', '.join(_FIGURE_ENDINGS)}")
    check_place(path)


def check_place(path: Path) -> None:
    """Refuse a file that could not be written.

    Raises
    ------
    FileError
    """
    if path.is_dir():
        raise FileError(f"cannot write {path}: it is a folder")
    if not path.parent.is_dir():
        raise FileError(f"cannot write {path}: there is no folder {path.parent}")


def _is_same(first: Path, second: Path) -> bool:
    return first.exists() and second.exists() and first.samefile(second)
