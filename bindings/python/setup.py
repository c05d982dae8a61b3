"""Puts the shared library of the source tree's build into the package, where there is one."""
import pathlib
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
BUILD = HERE.parents[1] / "build" / "release"
PROGRAMS = [BUILD / "bindings" / "c" / "libgriffith.so.1", BUILD / "app" / "griffith_surface_reader"]


class BuildWithLibrary(build_py):
    """Builds the package and copies the library next to its modules."""

    def run(self):
        super().run()
        for program in PROGRAMS:
            if program.exists():
                shutil.copy(program, pathlib.Path(self.build_lib) / "griffith" / program.name)


setup(cmdclass={"build_py": BuildWithLibrary})
