"""Who infects whom, how long it lasts, and whom chance picks."""

from gasbox.kernels.epidemic.chance import draws, durations, pick
from gasbox.kernels.epidemic.contact import contacts
from gasbox.kernels.epidemic.infect import Crowd, Found, infect
from gasbox.kernels.epidemic.look import look

__all__ = ["Crowd", "Found", "contacts", "draws", "durations", "infect", "look", "pick"]
