"""The recording: frames in an H5MD file, each of which can be read and resumed."""

from gasbox.recording.complaints import is_hdf5
from gasbox.recording.measurements import Measurements
from gasbox.recording.recorder import Recorder
from gasbox.recording.recording import Recording, open_recording

__all__ = ["Measurements", "Recorder", "Recording", "is_hdf5", "open_recording"]
