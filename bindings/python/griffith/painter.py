"""Pictures of a world as arrays, through EGL."""
import ctypes
import os

import numpy

from . import _library


class Painter:
    """Draws pictures like `griffith render`, without a window.

    Args:
        world: a world before any fracture.
        size: (width, height) [pixels].
        camera: a camera of the scene; the first if None.
        view: view as for `griffith render --view`, such as "utilization+fracture_planes"; the scene's view if None.

    Use it in the thread that made it.
    """

    def __init__(self, world, size=(1280, 720), camera=None, view=None):
        names = [os.fsencode(name) if name else None for name in (camera, view)]
        self._handle = _library.create("painter_create", world._handle, *size, *names)

    def __del__(self):
        if "_handle" in self.__dict__:
            _library.destroy("painter_destroy", self._handle)

    def paint(self, world):
        """Returns the picture of the world as a new array (height, width, 4) of bytes: red, green, blue and
        opacity."""
        pixels = _library.CArray()
        _library.call("painter_paint", self._handle, world._handle, ctypes.byref(pixels))
        height, width = pixels.count, pixels.shape[0]
        memory = (ctypes.c_uint8 * (height * width * 4)).from_address(pixels.data)
        return numpy.frombuffer(memory, numpy.uint8).reshape(height, width, 4).copy()
