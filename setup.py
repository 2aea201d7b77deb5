"""The Python package by pip: CMake builds the extension module, setuptools packs it (docs/guide/python.md)."""

import os
import shlex
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).parent.resolve()


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        folder = Path(self.build_temp).resolve()
        prefix = Path(self.get_ext_fullpath(extension.name)).resolve().parents[1]
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "PERIMPACT_GROUPED": "ON",
            "PERIMPACT_TESTS": "OFF",
            "PERIMPACT_CLI": "OFF",
            "PERIMPACT_PYTHON": "ON",
            "PERIMPACT_PYTHON_FOLDER": ".",
            "Python_EXECUTABLE": sys.executable,
        }
        subprocess.run(["cmake", "-G", "Ninja", "-S", HERE, "-B", folder, *(f"-D{key}={value}" for key, value in options.items()), *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count())
        subprocess.run(["cmake", "--build", folder, "--target", "python_core", "--parallel", jobs], check=True)
        subprocess.run(["cmake", "--install", folder, "--component", "python", "--prefix", prefix], check=True)


setup(
    package_dir={"": "python/src"},
    packages=["perimpact"],
    package_data={"perimpact": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("perimpact._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
