"""Griffith: brittle fracture in real time, from Python.

    import griffith

    world = griffith.World("scenes/glass_pane.json")
    world.run(60)
    print(world.frame.utilization.max())

A `Scene` is a value that describes bodies, materials and shots. A `World` is a scene in motion. Its `frame` shows the
simulation's own memory as NumPy arrays, without a copy. Units are SI throughout.
"""
from ._library import version
from .errors import ArgumentError, Cancelled, Error, InputError, LibraryNotFound
from .frame import ARRAYS, QUANTITIES, VALUES, Frame
from .painter import Painter
from .scene import Scene
from .sweep import outcomes, sweep
from .world import World, thread_limit

__version__ = version()
__all__ = [
    "ARRAYS",
    "QUANTITIES",
    "VALUES",
    "ArgumentError",
    "Cancelled",
    "Error",
    "Frame",
    "InputError",
    "LibraryNotFound",
    "Painter",
    "Scene",
    "World",
    "outcomes",
    "sweep",
    "thread_limit",
]
