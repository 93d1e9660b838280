"""Steradian on many machines: frames, golden suites and classes on the workers of a Dask scheduler (README.md)."""
