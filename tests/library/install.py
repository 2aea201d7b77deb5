"""Installs fccda from a build, relocates it, and builds the examples against it.

    install.py PLACES.json      {"build", "source", "folder", "compiler"}: folder gets fccda/ and examples/
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

# typical user flags: warnings in the library's headers are errors, no -march, default floating-point contraction of g++
FLAGS = "-O2 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"
C_FLAGS = "-O2 -Wall -Wextra -Wpedantic -Wshadow -Werror"
FORTRAN_FLAGS = "-std=f2018 -O2 -Wall -Wextra -pedantic -Werror"


def main():
    places = json.loads(Path(sys.argv[1]).read_text())
    folder = Path(places["folder"])
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run(["cmake", "--install", places["build"], "--component", "fccda", "--prefix", folder / "first"], check=True, stdout=subprocess.DEVNULL)
    (folder / "first").rename(folder / "fccda")
    configure = ["cmake", "-G", "Ninja", "-S", f"{places['source']}/examples", "-B", folder / "examples", f"-DCMAKE_PREFIX_PATH={folder / 'fccda'}"]
    configure += [f"-DCMAKE_CXX_COMPILER={places['compiler']}", "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_FLAGS={FLAGS}"]
    configure += [f"-DCMAKE_C_FLAGS={C_FLAGS}", f"-DCMAKE_Fortran_FLAGS={FORTRAN_FLAGS}"]
    configure += ["-DCMAKE_NO_SYSTEM_FROM_IMPORTED=ON"]  # otherwise the compiler suppresses warnings of installed headers
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", folder / "examples", "--parallel", "2"], check=True)


main()
