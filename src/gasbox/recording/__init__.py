"""The recording: frames in an H5MD file, each of which can be read and resumed."""

from gasbox.recording.recorder import Recorder
from gasbox.recording.recording import Recording, open_recording

__all__ = ["Recorder", "Recording", "open_recording"]
