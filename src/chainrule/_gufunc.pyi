"""NumPy universal functions around generated kernels, given the kernels' addresses: types of the C module."""

from collections.abc import Callable
from typing import Any, Literal

import numpy as np

def make(
    name: str, doc: str, signature: str, nin: int, nout: int, batch: int, batchf: int, owner: object, /
) -> np.ufunc:
    """A NumPy universal function of a kernel's two batch entries."""

def call(
    batch: int, batchf: int, nin: int, shapes: tuple[Any, ...], owner: object, general: Callable[..., Any], /
) -> Callable[..., Any]:
    """A call of a kernel with a short way for one configuration."""

def bind(batch: int, arrays: tuple[Any, ...], owner: object, /) -> Callable[[], None]:
    """One configuration of a kernel on fixed arrays."""

def cpu() -> Literal["avx512", "avx2", "plain"]:
    """The best instruction set of this processor."""
