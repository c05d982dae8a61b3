"""Scenes as values that are edited by attribute and by JSON pointer."""
import collections.abc
import ctypes
import json
import os

import numpy

from . import _library


def _pointer(parent, key):
    """Appends a key to a JSON pointer, escaped as in RFC 6901."""
    return f"{parent}/" + str(key).replace("~", "~0").replace("/", "~1")


def _plain(value):
    """Converts a value for JSON; accepts parts of scenes and NumPy's numbers and arrays."""
    if isinstance(value, Part):
        return value.value()
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    if isinstance(value, dict):
        return {key: _plain(child) for key, child in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(child) for child in value]
    return value


class Part:
    """A part of a scene below a JSON pointer. Reads and writes access the scene itself.

    `part.name` and `part["name"]` are a field, `part[0]` an item of a list. Objects and lists of objects are parts,
    all else is a plain value.
    """

    __slots__ = ("_scene", "_place")

    def __init__(self, scene, place):
        object.__setattr__(self, "_scene", scene)
        object.__setattr__(self, "_place", place)

    def value(self):
        """Returns the part as plain dictionaries, lists, numbers and texts, defaults included."""
        return self._scene.get(self._place)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __setattr__(self, name, value):
        self[name] = value

    def __getitem__(self, key):
        if isinstance(key, int) and key < 0:
            key += len(self)
        place = _pointer(self._place, key)
        value = self._scene.get(place)
        is_part = isinstance(value, dict) or (isinstance(value, list) and any(isinstance(v, dict) for v in value))
        return Part(self._scene, place) if is_part else value

    def __setitem__(self, key, value):
        if isinstance(key, int) and key < 0:
            key += len(self)
        self._scene.set(_pointer(self._place, key), value)

    def __len__(self):
        return len(self.value())

    def __iter__(self):
        value = self.value()
        return iter(value) if isinstance(value, dict) else (self[index] for index in range(len(value)))

    def __repr__(self):
        return f"<griffith.Part {self._place}: {json.dumps(self.value())[:200]}>"

    def __dir__(self):
        value = self.value()
        return [*super().__dir__(), *(value if isinstance(value, dict) else [])]


class Scene:
    """A description of bodies, materials, supports, loads and shots.

    Args:
        source: the path of a scene file, or a dictionary as scenes/README.md describes it ("version" may be left
            out).
        folder: base of relative paths in a dictionary; the current folder if None.

    Fields are edited by attribute, `scene.bodies[0].material.young_modulus = 3e10`, and by JSON pointer,
    `scene["/projectiles/0/speed"] = 20`. Each edit is checked like a file: InputError names the place and the
    correction, and the scene stays unchanged.
    """

    def __init__(self, source, folder=None):
        if isinstance(source, collections.abc.Mapping):
            text = json.dumps({"version": 1, **_plain(dict(source))})
            place = os.fsencode(folder) if folder is not None else None
            handle = _library.create("scene_parse", text.encode(), place)
        else:
            handle = _library.create("scene_read", os.fsencode(source))
        object.__setattr__(self, "_handle", handle)

    def __del__(self):
        if "_handle" in self.__dict__:
            _library.destroy("scene_destroy", self._handle)

    def copy(self):
        """Returns an independent copy."""
        other = object.__new__(Scene)
        object.__setattr__(other, "_handle", _library.create("scene_copy", self._handle))
        return other

    __copy__ = copy

    def __deepcopy__(self, memo):
        return self.copy()

    def get(self, pointer=""):
        """Returns the plain value at a JSON pointer; "" is the whole scene."""
        text = ctypes.c_void_p()
        _library.call("scene_get", self._handle, pointer.encode(), ctypes.byref(text))
        return json.loads(_library.text_of(text))

    def set(self, pointer, value):
        """Sets the field at a JSON pointer."""
        _library.call("scene_set", self._handle, pointer.encode(), json.dumps(_plain(value)).encode())

    def set_mesh(self, name, points, tets):
        """Adds tetrahedra under the name of a file, for bodies with the shape {"mesh": {"path": name}}.

        Args:
            points: (n, 3) coordinates [m].
            tets: (m, 4) indices of points, in either orientation.
        """
        points = numpy.ascontiguousarray(points, dtype=numpy.float64).reshape(-1, 3)
        tets = numpy.ascontiguousarray(tets, dtype=numpy.int32).reshape(-1, 4)
        _library.call(
            "scene_set_mesh", self._handle, name.encode(), points.ctypes.data, len(points), tets.ctypes.data, len(tets)
        )

    def __getitem__(self, pointer):
        return self.get(pointer)

    def __setitem__(self, pointer, value):
        self.set(pointer, value)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return Part(self, "")[name]

    def __setattr__(self, name, value):
        self.set(_pointer("", name), value)

    def __dir__(self):
        return [*super().__dir__(), *self.get()]

    def __eq__(self, other):
        return isinstance(other, Scene) and self.get() == other.get()

    __hash__ = None

    def __repr__(self):
        return f"<griffith.Scene {self.get('/name')!r}: {len(self.get('/bodies'))} bodies>"
