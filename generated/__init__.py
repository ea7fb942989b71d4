"""Generated code: C99 and NumPy, one folder per model. Written by ``python -m chainrule.derive``."""
