"""What a recording says once: the H5MD metadata, the box, and where the run came from."""

from __future__ import annotations

import json

import h5py
import numpy as np

from gasbox.geometry import Rectangle
from gasbox.recording import places
from gasbox.scenario import Forced, Scenario
from gasbox.version import __version__

__all__ = ["may_grow", "write_header"]


def write_header(file: h5py.File, scenario: Scenario) -> None:
    """Write all that does not depend on time."""
    _metadata(file)
    _box(file, scenario)
    _origin(file, scenario)


def may_grow(scenario: Scenario) -> bool:
    """Whether a barostat may change the size of the box: only that of a periodic rectangle under forces."""
    geometry = scenario.geometry()
    return (
        isinstance(scenario.dynamics, Forced) and isinstance(geometry, Rectangle) and not geometry.is_walled
    )


def _metadata(file: h5py.File) -> None:
    h5md = file.create_group("h5md")
    h5md.attrs["version"] = np.array(places.H5MD_VERSION, np.int32)
    # H5MD asks for an author; the name of the account is nobody's business.
    h5md.create_group("author").attrs["name"] = np.bytes_("unknown")
    creator = h5md.create_group("creator")
    creator.attrs["name"] = np.bytes_("gasbox")
    creator.attrs["version"] = np.bytes_(__version__)


def _box(file: h5py.File, scenario: Scenario) -> None:
    geometry = scenario.geometry()
    box = file.create_group(f"{places.PARTICLES}/box")
    box.attrs["dimension"] = 2
    box.attrs["boundary"] = np.array([b"periodic" if periodic else b"none" for periodic in geometry.periodic])
    if not may_grow(scenario):
        box.create_dataset("edges", data=geometry.size)


def _origin(file: h5py.File, scenario: Scenario) -> None:
    own = file.create_group(places.OWN)
    own.attrs["format"] = places.FORMAT
    own.attrs["version"] = __version__
    own.attrs["seed"] = np.int64(scenario.seed)
    own.attrs["scenario_hash"] = scenario.hash()
    own.attrs["species"] = json.dumps([kind.name for kind in scenario.kinds])
    own.create_dataset("scenario", data=scenario.to_json(), dtype=h5py.string_dtype())
    file.create_dataset(places.CHANGES, shape=(0,), maxshape=(None,), dtype=h5py.string_dtype())
