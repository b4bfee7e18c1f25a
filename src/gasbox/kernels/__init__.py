"""Compiled kernels: arrays in, arrays out, status codes back. No checks here; the floors above make them."""
