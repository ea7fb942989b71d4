"""Postures, cusps, nodes and aspects of arms with three revolute joints that position a point."""
