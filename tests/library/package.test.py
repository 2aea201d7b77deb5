"""The installed package, and fccda alone. The first argument is places.json (install.py)."""

import json
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


def places(scene):
    return {name: Path(place) for name, place in json.loads(Path(scene.program).read_text()).items()}


@claim("every header of fccda is installed, and no others")
def headers(scene):
    at = places(scene)
    source, include = at["source"] / "src", at["folder"] / "fccda/include"
    ours = {path.relative_to(source) for folder in ("base", "mesh", "mesh_io", "marine", "fccda") for path in (source / folder).rglob("*.h*")}
    installed = {path.relative_to(include / "fccda") for path in include.rglob("*") if path.is_file()}
    scene.assertGreater(len(ours), 40)
    scene.assertEqual(installed, ours)


@claim("the package exports C++20, OpenMP, zlib and its include folder, and no paths of the build machine")
def package(scene):
    at = places(scene)
    files = sorted((at["folder"] / "fccda").rglob("*.cmake"))
    text = "\n".join(path.read_text() for path in files)
    interface = dict(re.findall(r'^  INTERFACE_(\w+) "(.*)"$', text, re.MULTILINE))
    scene.assertEqual(
        interface,
        {"COMPILE_FEATURES": "cxx_std_20", "INCLUDE_DIRECTORIES": "${_IMPORT_PREFIX}/include/fccda", "LINK_LIBRARIES": r"OpenMP::OpenMP_CXX;\$<LINK_ONLY:ZLIB::ZLIB>"},
    )
    scene.assertEqual(re.findall(r"find_dependency\((\w+)", text), ["OpenMP", "ZLIB"])
    for place in (at["build"], at["source"]):
        scene.assertNotIn(str(place), text)
    scene.assertIsNone(re.search(r"-march|-mtune|-ffp|-fno-", text))


@claim("fccda configures alone, with its tests, and needs only its folder, cmake/ and tests/ of the tree")
def alone(scene):
    at = places(scene)
    build = scene.folder / "build"
    configure = ["cmake", "-G", "Ninja", "-S", at["source"] / "src/fccda", "-B", build, f"-DCMAKE_CXX_COMPILER={at['compiler']}", "-DFCCDA_TESTS=ON"]
    done = subprocess.run(configure, capture_output=True, text=True)
    scene.assertEqual(done.returncode, 0, done.stderr)
    targets = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], capture_output=True, text=True, check=True).stdout
    for target in ("fccda_library", "fccda_tests", "install"):
        scene.assertRegex(targets, rf"(?m)^{target}: ")
    scene.assertNotRegex(targets, r"(?m)^(perimpact|io|cli)[_:]")
    cache = (build / "CMakeCache.txt").read_text()
    for library in ("yaml-cpp", "fmt_DIR", "UDUNITS"):
        scene.assertNotIn(library, cache)


main()
