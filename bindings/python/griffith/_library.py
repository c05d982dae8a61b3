"""The shared library and the C types of include/griffith/griffith.h."""
import ctypes
import os
import pathlib

from .errors import ArgumentError, Cancelled, Error, InputError, LibraryNotFound

ABI_VERSION = 1
NAME = "libgriffith.so.1"
_HERE = pathlib.Path(__file__).resolve().parent


class CError(ctypes.Structure):
    """griffith_error."""

    _fields_ = [
        ("status", ctypes.c_int32),
        ("where", ctypes.c_char * 512),
        ("problem", ctypes.c_char * 1024),
        ("remedy", ctypes.c_char * 512),
    ]


class CArray(ctypes.Structure):
    """griffith_array."""

    _fields_ = [
        ("data", ctypes.c_void_p),
        ("count", ctypes.c_int64),
        ("stride", ctypes.c_int64),
        ("type", ctypes.c_int32),
        ("dimensions", ctypes.c_int32),
        ("shape", ctypes.c_int32 * 2),
    ]


class CInfo(ctypes.Structure):
    """griffith_array_info and griffith_value_info."""

    _fields_ = [("name", ctypes.c_char_p), ("unit", ctypes.c_char_p), ("meaning", ctypes.c_char_p)]


class CSpring(ctypes.Structure):
    """griffith_spring."""

    _fields_ = [(name, ctypes.c_double) for name in ("frequency", "damping_ratio", "strength")]


StageFunction = ctypes.CFUNCTYPE(None, ctypes.c_char_p, ctypes.c_void_p)
CancelledFunction = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p)


class CMonitor(ctypes.Structure):
    """griffith_monitor."""

    _fields_ = [("stage", StageFunction), ("cancelled", CancelledFunction), ("context", ctypes.c_void_p)]


def _candidates():
    """Yields the places where the library may be, the most explicit first."""
    if os.environ.get("GRIFFITH_LIBRARY"):
        yield os.environ["GRIFFITH_LIBRARY"]
        return
    yield str(_HERE / NAME)
    yield str(_HERE.parents[2] / "build" / "release" / "bindings" / "c" / NAME)
    yield NAME


def _load():
    problems = []
    for place in _candidates():
        if os.sep in place and not os.path.exists(place):
            problems.append(f"{place}: missing")
            continue
        try:
            return ctypes.CDLL(place)
        except OSError as problem:
            problems.append(str(problem))
    raise LibraryNotFound(
        f"{NAME} cannot be loaded: build the project, install it, or name the file in GRIFFITH_LIBRARY\n  "
        + "\n  ".join(problems)
    )


_handle = ctypes.c_void_p
_text = ctypes.c_char_p
_out = ctypes.POINTER(ctypes.c_void_p)
_vector = ctypes.c_double * 3

# Arguments of the functions that return a status; each takes a griffith_error* as its last argument.
_FUNCTIONS = {
    "scene_read": [_text, _out],
    "scene_parse": [_text, _text, _out],
    "scene_copy": [_handle, _out],
    "scene_set": [_handle, _text, _text],
    "scene_get": [_handle, _text, _out],
    "scene_set_mesh": [_handle, _text, ctypes.c_void_p, ctypes.c_int64, ctypes.c_void_p, ctypes.c_int64],
    "world_create": [_handle, ctypes.POINTER(CMonitor), _out],
    "world_copy": [_handle, _out],
    "world_restore": [_handle, _handle],
    "world_step": [_handle, ctypes.c_int32],
    "world_fire_json": [_handle, _text],
    "world_push": [_handle, _vector, _vector],
    "world_grab": [_handle, _vector, _vector, ctypes.POINTER(CSpring)],
    "world_move_grab": [_handle, _vector],
    "world_release": [_handle],
    "world_set_material": [_handle, ctypes.c_int32, _text, _text],
    "world_start_recording": [_handle],
    "world_save_recording": [_handle, _text],
    "world_value": [_handle, _text, ctypes.POINTER(ctypes.c_double)],
    "world_array": [_handle, ctypes.c_int32, ctypes.POINTER(CArray)],
    "world_quantity": [_handle, _text, ctypes.POINTER(CArray)],
    "world_update_surfaces": [_handle],
    "thread_limit_create": [ctypes.c_int32, _out],
    "painter_create": [_handle, ctypes.c_int32, ctypes.c_int32, _text, _text, _out],
    "painter_paint": [_handle, _handle, ctypes.POINTER(CArray)],
}

_library = _load()
for _name, _arguments in _FUNCTIONS.items():
    _function = getattr(_library, "griffith_" + _name)
    _function.argtypes = [*_arguments, ctypes.POINTER(CError)]
    _function.restype = ctypes.c_int32
for _name in ("scene_destroy", "world_destroy", "thread_limit_destroy", "painter_destroy", "string_free"):
    getattr(_library, "griffith_" + _name).argtypes = [_handle]
    getattr(_library, "griffith_" + _name).restype = None
_library.griffith_version.restype = _text
_library.griffith_abi_version.restype = ctypes.c_uint32
_library.griffith_value_count.restype = ctypes.c_int32
for _name in ("value_describe", "array_describe", "quantity_describe"):
    getattr(_library, "griffith_" + _name).argtypes = [ctypes.c_int32]
    getattr(_library, "griffith_" + _name).restype = ctypes.POINTER(CInfo)
_library.griffith_world_state_hash.argtypes = [_handle]
_library.griffith_world_state_hash.restype = ctypes.c_uint64

if _library.griffith_abi_version() != ABI_VERSION:
    raise LibraryNotFound(
        f"{_library._name} has interface {_library.griffith_abi_version()}, this package needs {ABI_VERSION}: "
        "install both from one version of the project"
    )

_EXCEPTIONS = {1: ArgumentError, 2: InputError, 3: Cancelled}


def call(name, *arguments):
    """Calls griffith_<name>; raises the exception of its status."""
    error = CError()
    status = getattr(_library, "griffith_" + name)(*arguments, ctypes.byref(error))
    if status == 0:
        return
    if status == 4:
        raise MemoryError(error.problem.decode())
    texts = (text.decode("utf-8", "replace") for text in (error.where, error.problem, error.remedy))
    raise _EXCEPTIONS.get(status, Error)(*texts)


def create(name, *arguments):
    """Calls griffith_<name>, whose last argument receives a handle; returns the handle."""
    made = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(made))
    return made


def vector(values):
    """Returns three numbers as a double[3]."""
    return _vector(*map(float, values))


def destroy(name, handle):
    """Calls griffith_<name>, which returns nothing."""
    getattr(_library, "griffith_" + name)(handle)


def text_of(handle):
    """Returns the text at a char* of the library and frees it."""
    try:
        return ctypes.string_at(handle).decode()
    finally:
        _library.griffith_string_free(handle)


def state_hash(world):
    """Returns the state's hash as the command line writes it."""
    return f"{_library.griffith_world_state_hash(world):016x}"


def describe(kind, index):
    """Returns name, unit and meaning of a value or an array; None where there is none."""
    info = getattr(_library, f"griffith_{kind}_describe")(index)
    return tuple(text.decode() for text in (info[0].name, info[0].unit, info[0].meaning)) if info else None


def version():
    """Returns the version of the library."""
    return _library.griffith_version().decode()
