# SPDX-License-Identifier: BSD-3-Clause
"""What pyproject.toml cannot say: the package notes where pip found it, so that it finds program, library and launcher there, and nothing
is written into the folder itself, which may belong to somebody else."""

import atexit
import pathlib
import tempfile

from setuptools import setup
from setuptools.command.build import build
from setuptools.command.build_py import build_py
from setuptools.command.egg_info import egg_info

HERE = pathlib.Path(__file__).resolve().parent
SCRATCH = tempfile.TemporaryDirectory(prefix="barreno-package-")
atexit.register(SCRATCH.cleanup)


class BuildAside(build):
    def initialize_options(self):
        super().initialize_options()
        self.build_base = SCRATCH.name


class InfoAside(egg_info):
    def initialize_options(self):
        super().initialize_options()
        self.egg_base = SCRATCH.name


class NotePlace(build_py):
    def run(self):
        super().run()
        note = pathlib.Path(self.build_lib) / "barreno" / "installed_from.txt"  # as barreno/places.py reads it
        note.write_text(f"{HERE}\n", encoding="utf-8")


setup(cmdclass={"build": BuildAside, "build_py": NotePlace, "egg_info": InfoAside})
