"""Benchmarks: chainrule beside its peers, in one run, in one table. Start them with ``python -m benchmarks``."""
