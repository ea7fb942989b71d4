"""The peers, one module each. ``contenders(case, q)`` gives the ways a peer computes a case, or raises Unavailable."""
