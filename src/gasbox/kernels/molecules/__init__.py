"""Kernels for molecules: rigid bodies of discs."""
