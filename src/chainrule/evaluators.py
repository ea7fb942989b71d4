"""A description's generated functions as NumPy universal functions, found or made on first use.

Every evaluator broadcasts over leading axes, takes ``out=``, float64 and float32, strided and zero-size input, and
releases the GIL. Integers are taken as float64. An entry that is nan or infinite makes the results of its own
configuration nan and touches no other.
"""

from __future__ import annotations

import ctypes
import importlib.util
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule import compile as compiling
from chainrule.compile import Built
from chainrule.description import Model
from chainrule.errors import InputError

Array = NDArray[Any]
Shape = tuple[int, ...]


@dataclass(frozen=True)
class Evaluator:
    """One generated function.

    Attributes:
        name: the function's name, such as ``jacobian_pose``.
        summary: what it computes.
        inputs: names and shapes of the inputs' own (last) axes.
        outputs: names and shapes of the outputs' own axes.
        operations: arithmetic operations in one evaluation; a sine or cosine counts one.
        compiled: whether a compiled kernel (a ``numpy.ufunc``) stands behind it, or the NumPy code.
    """

    name: str
    summary: str
    inputs: tuple[tuple[str, Shape], ...]
    outputs: tuple[tuple[str, Shape], ...]
    operations: int
    compiled: bool
    function: Callable[..., Any] = field(repr=False)
    _addresses: tuple[int, int] = field(default=(0, 0), repr=False)
    _owner: Any = field(default=None, repr=False)
    _short: Callable[..., Any] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        short: Callable[..., Any] = self._general
        if self.compiled:
            from chainrule import _gufunc

            shapes = tuple(shape for _, shape in (*self.inputs, *self.outputs))
            short = _gufunc.call(*self._addresses, len(self.inputs), shapes, self._owner, self._general)
        object.__setattr__(self, "_short", short)

    def __call__(self, *arrays: Any, out: Any = None) -> Any:
        """Evaluate; leading axes broadcast. ``out`` is an array, or a tuple with one (or None) for each output.

        Raises:
            InputError: a wrong shape, or numbers that are not real.
        """
        outs = () if out is None else out if isinstance(out, tuple) else (out,)
        if len(arrays) != len(self.inputs) or len(outs) not in (0, len(self.outputs)):
            raise self._refusal([np.asarray(array) for array in arrays], out, ValueError("wrong number of arrays"))
        return self._short(*arrays, *outs)

    def _general(self, *arrays: Any) -> Any:
        """Inputs and perhaps outputs through NumPy's own machinery, with every refusal in words."""
        count = len(self.inputs)
        given = len(arrays) == count + len(self.outputs)
        outs = arrays[count:] if given else ()
        out: Any = None if not given else outs if len(outs) > 1 else outs[0]
        try:
            ready = [_real(array) for array in (arrays[:count] if given else arrays)]
        except ValueError:
            raise InputError(
                f"{self.name}: a ragged nested sequence was given; arrays of real numbers are accepted"
            ) from None
        try:
            if len(ready) != count:
                raise ValueError("wrong number of inputs")
            return self.function(*ready) if out is None else self.function(*ready, out=out)
        except (TypeError, ValueError) as error:
            raise self._refusal(ready, out, error) from None

    def _refusal(self, arrays: list[Any], out: Any, error: Exception) -> InputError:
        """One line saying which array is wrong and what would be accepted."""
        if len(arrays) != len(self.inputs):
            names = ", ".join(name for name, _ in self.inputs)
            return InputError(f"{self.name}: {len(arrays)} inputs given; it takes {len(self.inputs)} ({names})")
        leading = []
        for array, (name, shape) in zip(arrays, self.inputs, strict=True):
            if array.dtype.kind != "f":
                return InputError(f"{self.name}: {name} has type {array.dtype}; real numbers are accepted")
            if array.shape[-len(shape) :] != shape or array.ndim < len(shape):
                return InputError(
                    f"{self.name}: {name} has shape {array.shape}; (..., {', '.join(map(str, shape))}) is accepted"
                )
            leading.append(array.shape[: array.ndim - len(shape)])
        try:
            lead = np.broadcast_shapes(*leading)
        except ValueError:
            return InputError(f"{self.name}: the leading axes {leading} do not broadcast together")
        if out is not None:
            wanted = ", ".join(f"{name} {lead + shape}" for name, shape in self.outputs)
            return InputError(
                f"{self.name}: out does not fit; a writable float array (or a tuple of them) of {wanted} is accepted"
            )
        return InputError(f"{self.name}: {error}")

    def bind(self, *arrays: Array) -> Callable[[], None]:
        """A call without arguments that evaluates one configuration from fixed arrays into fixed arrays.

        For control loops in Python: write into the inputs, call, read the outputs. No allocation, no checks.

        Args:
            arrays: inputs, then outputs, each of exactly its own shape, all float64 or all float32.

        Raises:
            InputError: wrong number, shape or type, or an output that is not writable.
        """
        ports = [*self.inputs, *self.outputs]
        if len(arrays) != len(ports):
            raise InputError(f"{self.name}: {len(arrays)} arrays given; bind takes {', '.join(n for n, _ in ports)}")
        kind = arrays[0].dtype if isinstance(arrays[0], np.ndarray) else None
        if kind not in (np.float64, np.float32):
            raise InputError(f"{self.name}: bind takes NumPy arrays, all float64 or all float32")
        for k, (array, (name, shape)) in enumerate(zip(arrays, ports, strict=True)):
            if (
                not isinstance(array, np.ndarray)
                or array.dtype != kind
                or array.shape != shape
                or not array.flags.aligned
            ):
                raise InputError(f"{self.name}: bind needs {name} as an aligned {kind} array of shape {shape}")
            if k >= len(self.inputs) and not array.flags.writeable:
                raise InputError(f"{self.name}: bind cannot write {name}, which is read-only")
        if not self.compiled:
            inputs, outputs = arrays[: len(self.inputs)], arrays[len(self.inputs) :]

            def evaluate() -> None:
                self.function(*inputs, out=outputs)

            return evaluate
        from chainrule import _gufunc

        bound: Callable[[], None] = _gufunc.bind(self._addresses[kind == np.float32], tuple(arrays), self._owner)
        return bound


def _real(array: Any) -> Array:
    """As a float array: integers become float64, and what is not a number is left for the refusal."""
    ready: Array = np.asarray(array)
    return ready.astype(np.float64) if ready.dtype.kind in "iub" or ready.dtype == np.float16 else ready


class Evaluators:
    """The evaluators of one model, made group by group on first use."""

    def __init__(self, model: Model, progress: Callable[[str], None] = lambda line: None) -> None:
        self._model = model
        self._progress = progress
        self._found: dict[str, Evaluator] = {}
        self._loaded: set[str] = set()

    def group(self, group: str) -> Mapping[str, Evaluator]:
        """Every evaluator of a group: ``kinematics`` or a task's name."""
        if group not in self._loaded:
            self._found |= load(compiling.find(self._model, group, self._progress))
            self._loaded.add(group)
        return self._found

    def get(self, group: str, name: str) -> Evaluator | None:
        """One evaluator of a group, or None where the model has no such function."""
        found = self._found.get(name)
        return found if found is not None else self.group(group).get(name)


def load(built: Built) -> dict[str, Evaluator]:
    """The evaluators of a unit's library, or of its NumPy module where there is no library."""
    if built.library is None:
        module = _module(built.unit, built.numpy_module)
        return {name: _from_numpy(name, spec, getattr(module, name)) for name, spec in built.functions.items()}
    library = ctypes.CDLL(str(built.library))
    return {name: _from_library(name, spec, built.prefix, library) for name, spec in built.functions.items()}


def _ports(spec: Mapping[str, Any], which: str) -> tuple[tuple[str, Shape], ...]:
    return tuple((str(name), tuple(int(extent) for extent in shape)) for name, shape in spec[which])


def _from_library(name: str, spec: Mapping[str, Any], prefix: str, library: ctypes.CDLL) -> Evaluator:
    from chainrule import _gufunc

    inputs, outputs = _ports(spec, "inputs"), _ports(spec, "outputs")
    symbol = f"{prefix}_{name}_batch"
    addresses = tuple(
        ctypes.cast(getattr(library, symbol + suffix), ctypes.c_void_p).value or 0 for suffix in ("", "f")
    )
    signature = "->".join(
        ",".join(f"({','.join(map(str, shape))})" for _, shape in ports) for ports in (inputs, outputs)
    )
    function = _gufunc.make(
        name, spec["summary"], signature, len(inputs), len(outputs), addresses[0], addresses[1], library
    )
    return Evaluator(
        name,
        spec["summary"],
        inputs,
        outputs,
        int(spec["operations"]),
        True,
        function,
        (addresses[0], addresses[1]),
        library,
    )


def _from_numpy(name: str, spec: Mapping[str, Any], code: Callable[..., Any]) -> Evaluator:
    inputs, outputs = _ports(spec, "inputs"), _ports(spec, "outputs")

    def function(*arrays: Array, out: Any = None) -> Any:
        for array, (_, shape) in zip(arrays, inputs, strict=True):
            if array.dtype.kind != "f" or array.shape[-len(shape) :] != shape:
                raise ValueError("wrong input")
        with np.errstate(all="ignore"):  # as the kernels: inf and nan are answers, not events
            results = code(*arrays)
        results = results if isinstance(results, tuple) else (results,)
        if out is None:
            ready = tuple(result[()] for result in results)
        else:
            targets = out if isinstance(out, tuple) else (out,)
            ready = tuple(_stored(result, target) for result, target in zip(results, targets, strict=True))
        return ready if len(ready) > 1 else ready[0]

    return Evaluator(name, spec["summary"], inputs, outputs, int(spec["operations"]), False, function)


def _stored(result: Array, target: Any) -> Any:
    """The result, or ``target`` with the result in it, under the rules of NumPy's universal functions."""
    if target is None:
        return result[()]
    if not (
        isinstance(target, np.ndarray)
        and target.shape == result.shape
        and target.flags.writeable
        and np.can_cast(result.dtype, target.dtype, "same_kind")
    ):
        raise ValueError("wrong out")
    target[...] = result
    return target


def _module(name: str, path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"chainrule._numpy.{name}", path)
    if spec is None or spec.loader is None:
        raise ImportError(f"{path} is not a Python module")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
