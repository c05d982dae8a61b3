"""Running simulations."""
import contextlib
import ctypes
import json
import os

from . import _library
from .frame import Frame
from .scene import Scene, _plain


def _monitor(progress, problems):
    """Returns a C monitor that calls progress(stage); an exception in it cancels the work and is kept in `problems`."""

    def enter(name, _):
        try:
            progress(name.decode())
        except BaseException as problem:  # it cannot pass through C: World raises it
            problems.append(problem)

    return _library.CMonitor(_library.StageFunction(enter), _library.CancelledFunction(lambda _: bool(problems)), None)


class World:
    """A simulation of a scene. Results depend only on the scene, shots, edits and number of steps.

    Args:
        scene: a Scene, a dictionary or the path of a scene file.
        progress: called with the name of each stage while the world is built; an exception in it cancels the build.
        record: keep shots, edits and hashes for save_recording().
    """

    def __init__(self, scene, *, progress=None, record=False):
        scene = scene if isinstance(scene, Scene) else Scene(scene)
        problems = []
        monitor = _monitor(progress, problems) if progress else None
        try:
            self._handle = _library.create("world_create", scene._handle, ctypes.byref(monitor) if monitor else None)
        except _library.Cancelled:
            if problems:
                raise problems[0] from None
            raise
        if record:
            _library.call("world_start_recording", self._handle)

    def __del__(self):
        if "_handle" in self.__dict__:
            _library.destroy("world_destroy", self._handle)

    @property
    def frame(self):
        """Current state as arrays and numbers."""
        return Frame(self)

    @property
    def state_hash(self):
        """Hash of all positions, velocities and topology, as `griffith simulate` writes it."""
        return _library.state_hash(self._handle)

    def step(self, count=1):
        """Advances by time steps of the scene. Arrays taken from earlier frames become invalid."""
        _library.call("world_step", self._handle, count)

    def run(self, steps, progress=None):
        """Advances step by step, so that Ctrl+C can interrupt it; returns the world.

        Args:
            steps: number of time steps.
            progress: called with (steps made, steps) after each.
        """
        for made in range(1, steps + 1):
            self.step()
            if progress:
                progress(made, steps)
        return self

    def steps(self, count):
        """Yields the frame after each of `count` steps."""
        for _ in range(count):
            self.step()
            yield self.frame

    def fire(self, **shot):
        """Fires a projectile now. Arguments are the fields of a scene's projectiles: position [m], direction, speed
        [m/s], mass [kg], radius [m], shape, count, interval [s]."""
        _library.call("world_fire_json", self._handle, json.dumps(_plain(shot)).encode())

    def push(self, position, impulse):
        """Pushes the material at a position [m], or the point of the surface nearest to it, with an impulse [N·s], in
        the next step. The piece may deform and break."""
        _library.call("world_push", self._handle, _library.vector(position), _library.vector(impulse))

    def grab(self, position, target, frequency=3, damping_ratio=0.7, strength=10):
        """Grabs the material at a position [m], or the point of the surface nearest to it: a spring pulls it to the
        target [m].

        Args:
            frequency: of the piece on the spring [Hz], 0.01 to 100.
            damping_ratio: 0 to 10.
            strength: greatest force, in weights of the piece, 0.01 to 1e6.
        """
        spring = _library.CSpring(frequency, damping_ratio, strength)
        _library.call("world_grab", self._handle, _library.vector(position), _library.vector(target), spring)

    def move_grab(self, target):
        """Moves the target of the grab [m]."""
        _library.call("world_move_grab", self._handle, _library.vector(target))

    def release(self):
        """Ends the grab, if there is one."""
        _library.call("world_release", self._handle)

    def set_material(self, body=0, **fields):
        """Changes fields of the material of the scene's body number `body`, such as young_modulus=3e10 [Pa]. If one is
        rejected, none is changed."""
        trial = self.copy()
        for world in (trial, self):  # rejected values never reach this world
            for name, value in fields.items():
                text = json.dumps(_plain(value)).encode()
                _library.call("world_set_material", world._handle, body, name.encode(), text)

    def copy(self):
        """Returns a copy that continues identically: a snapshot or a branch. It is not recorded."""
        other = object.__new__(World)
        other._handle = _library.create("world_copy", self._handle)
        return other

    __copy__ = copy

    def __deepcopy__(self, memo):
        return self.copy()

    def restore(self, snapshot):
        """Restores the state of a copy. Ends a recording."""
        _library.call("world_restore", self._handle, snapshot._handle)

    def save_recording(self, path):
        """Writes the run for `griffith replay` and bug reports; needs record=True."""
        _library.call("world_save_recording", self._handle, os.fsencode(path))

    def __repr__(self):
        return f"<griffith.World at step {int(self.frame.step)}>"


@contextlib.contextmanager
def thread_limit(threads):
    """Limits the threads of all worlds inside a `with` block. Results do not depend on it."""
    limit = _library.create("thread_limit_create", threads)
    try:
        yield
    finally:
        _library.destroy("thread_limit_destroy", limit)
