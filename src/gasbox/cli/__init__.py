"""The command line: one file a command, and below them what several need."""

from gasbox.cli.main import main

__all__ = ["main"]
