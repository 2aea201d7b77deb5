"""What packages the container and the Spack recipe install is what scripts/install_dependencies.sh does.

    packages.py FOLDER
"""

import re
import sys
from pathlib import Path

# Debian's package of each build dependency: its name in Spack, and the package of its shared library that a program at run time needs.
# Header-only and build tools need none.
KNOWN = {
    "g++": ("cxx", "libgomp1"),
    "cmake": ("cmake", None),
    "ninja-build": ("ninja", None),
    "libfmt-dev": ("fmt", "libfmt9"),
    "libyaml-cpp-dev": ("yaml-cpp", "libyaml-cpp0.7"),
    "libudunits2-dev": ("udunits", "libudunits2-0"),
    "libcli11-dev": ("cli11", None),
    "zlib1g-dev": ("zlib-api", "zlib1g"),
    "libhdf5-dev": ("hdf5", "libhdf5-103-1"),
}
# of the Python package: what scripts/install_dependencies.sh installs for the tests, and its name in Spack
PYTHON = {"python3": "python", "pybind11-dev": "py-pybind11", "python3-numpy": "py-numpy"}


def faults_of(root):
    script = (root / "scripts/install_dependencies.sh").read_text(encoding="utf-8")
    lists = {name: words.split() for name, words in re.findall(r"^(\w+)=\((.*?)\)$", script, re.MULTILINE)}
    build = set(lists["build"])
    if build != set(KNOWN):
        yield f"scripts/install_dependencies.sh builds with {sorted(build)}, but this test knows {sorted(KNOWN)}; add the new one to container, recipe and test"
    yield from (f"{each} is not among the tests' packages of scripts/install_dependencies.sh" for each in PYTHON if each not in lists["tests"])

    container = (root / "packaging/Dockerfile").read_text(encoding="utf-8")
    if "scripts/install_dependencies.sh run" not in container:
        yield "packaging/Dockerfile does not build with the packages of scripts/install_dependencies.sh"
    last = container.split("FROM ")[-1]
    installed = set(re.search(r"--no-install-recommends ([^&]*)", last)[1].split())
    wanted = {library for _, library in KNOWN.values() if library}
    if installed != wanted:
        yield f"packaging/Dockerfile installs {sorted(installed)} for running, but the program needs {sorted(wanted)}"

    recipe = (root / "packaging/spack/packages/perimpact/package.py").read_text(encoding="utf-8")
    named = set(re.findall(r'depends_on\("([\w-]+)', recipe))
    wanted = {name for name, _ in KNOWN.values()} | set(PYTHON.values())
    if named != wanted:
        yield f"the Spack recipe depends on {sorted(named)}, but the build on {sorted(wanted)}"


def main():
    faults = list(faults_of(Path(sys.argv[1])))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
