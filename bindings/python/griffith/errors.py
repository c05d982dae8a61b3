"""Exceptions of the package."""


class Error(Exception):
    """A failed call of the library, with place, problem and remedy.

    Attributes:
        where: the place: a file, file:line, file#/json/pointer, or the argument.
        problem: description of the error.
        remedy: correction; may be empty.
    """

    def __init__(self, where="", problem="", remedy=""):
        super().__init__(f"{where}: {problem}" + (f" ({remedy})" if remedy else ""))
        self.where = where
        self.problem = problem
        self.remedy = remedy

    def __reduce__(self):
        return type(self), (self.where, self.problem, self.remedy)


class ArgumentError(Error, ValueError):
    """An argument is out of range or an unknown name."""


class InputError(Error, ValueError):
    """A scene, a file or a value cannot be used."""


class Cancelled(Error):
    """The progress function cancelled the work."""


class LibraryNotFound(ImportError):
    """The shared library libgriffith.so.1 is missing or of another version."""
