"""An epidemic among people who move about."""

from gasbox.worlds.epidemic.epidemic import Epidemic

__all__ = ["Epidemic"]
