"""The version, in one place (checked against the changelog by a test)."""

__version__ = "0.1.0"
