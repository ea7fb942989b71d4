"""Redundant arms along a task: the law of a step, and what follows a path with it."""
