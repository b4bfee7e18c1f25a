"""An epidemic among people who move about."""

from gasbox.worlds.epidemic.outbreak import Outbreak

__all__ = ["Outbreak"]
