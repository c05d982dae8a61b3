"""A world between two steps, as numbers and NumPy arrays."""
import ctypes
import itertools
from typing import NamedTuple

import numpy

from . import _library


class Info(NamedTuple):
    """Describes an array or a number of a frame."""

    name: str
    unit: str
    meaning: str


_DTYPES = ["<f8", "<f4", "<i8", "<i4", "|u1"]
_SHORT_NAMES = {"tet_nodes": "tets", "tet_stress": "stress"}


def _python_name(name):
    """Drops "node_", so that node arrays have short names: frame.utilization."""
    return _SHORT_NAMES.get(name, name[5:] if name.startswith("node_") else name)


def _describe_all(kind):
    found = (_library.describe(kind, index) for index in itertools.count())
    return [Info(*info) for info in itertools.takewhile(lambda info: info is not None, found)]


#: Arrays of a frame: Info by the name of the attribute.
ARRAYS = {_python_name(info.name): info for info in _describe_all("array")}
#: Numbers of a frame: Info by the name of the attribute.
VALUES = {info.name: info for info in _describe_all("value")}
#: Quantities that Frame.quantity() computes: Info by name.
QUANTITIES = {info.name: info for info in _describe_all("quantity")}
_INDICES = {name: index for index, name in enumerate(ARRAYS)}


class _Memory:
    """Shares the library's memory with NumPy and keeps its world alive."""

    def __init__(self, world, view):
        self._world = world
        shape = tuple(view.shape[: view.dimensions])
        size = numpy.dtype(_DTYPES[view.type]).itemsize
        inner = (shape[1] * size, size) if len(shape) == 2 else (size,) * len(shape)
        self.__array_interface__ = {
            "version": 3,
            "typestr": _DTYPES[view.type],
            "data": (view.data or 0, True),
            "shape": (view.count, *shape),
            "strides": (view.stride, *inner),
        }


class Frame:
    """Current state of a world.

    Attributes are read-only NumPy arrays (griffith.ARRAYS) and numbers (griffith.VALUES). Arrays are views of the
    simulation's memory: valid until the world's next step, shot, edit or restore. Copy arrays to keep them:
    `frame.positions.copy()`.
    """

    __slots__ = ("_world",)

    def __init__(self, world):
        self._world = world

    def __getattr__(self, name):
        if name in _INDICES:
            return self._array(name)
        if name in VALUES:
            value = ctypes.c_double()
            _library.call("world_value", self._world._handle, name.encode(), ctypes.byref(value))
            return value.value
        raise AttributeError(f"a frame has no {name!r}; griffith.ARRAYS and griffith.VALUES list its attributes")

    def __dir__(self):
        return [*super().__dir__(), *ARRAYS, *VALUES]

    def __repr__(self):
        return f"<griffith.Frame of step {int(self.step)}: {len(self.tets)} tetrahedra, {int(self.bodies)} bodies>"

    def quantity(self, name):
        """Computes one of griffith.QUANTITIES, as views and exported files show it: a new array, one entry per node or
        tetrahedron."""
        if name not in QUANTITIES:
            raise KeyError(f"{name!r} is no quantity; griffith.QUANTITIES lists them")
        view = _library.CArray()
        _library.call("world_quantity", self._world._handle, name.encode(), ctypes.byref(view))
        return self._numbers(view).copy()

    def _numbers(self, view):
        if view.count == 0:
            return numpy.empty((0, *view.shape[: view.dimensions]), _DTYPES[view.type])
        return numpy.asarray(_Memory(self._world, view))

    def _array(self, name):
        view = _library.CArray()
        if name.startswith("surface_"):
            _library.call("world_update_surfaces", self._world._handle)
        _library.call("world_array", self._world._handle, _INDICES[name], ctypes.byref(view))
        return self._numbers(view)
