"""The sections, one module each; every module has a ``SECTION``."""
