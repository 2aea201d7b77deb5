"""The surfaces of OpenFOAM's tutorials, as Debian's package openfoam-examples installs them: hulls, propellers, buildings, terrain, machine
parts, fragments of pipes. They come from many programs, and few were made for anything like contact. They stay where they are."""

import hashlib
import unittest
from pathlib import Path
from typing import NamedTuple

EXAMPLES = Path("/usr/share/doc/openfoam-examples/examples")
FORMATS = (".stl", ".obj", ".vtk", ".msh", ".inp")


class Named(NamedTuple):
    """One that engineers know, and what must come out of it. Of an open one `strikes` are directions in which it reaches the block before
    its rims do, each with the side that is outside there."""

    name: str  # of the file, without what .gz adds
    spacing: float  # [m] of the particles, a hundredth of the surface or so
    strikes: dict  # direction: outside; None where the surface is closed


CLOSED = [
    Named("DTC-scaled.stl", 0.06, {"+x": None, "-z": None}),
    Named("buildings.obj", 2.5, {"-x": None}),
    Named("building_wtc2.obj", 0.01, {"+z": None, "-y": None}),
    Named("fan.stl", 0.012, {"+x": None, "-z": None}),
    Named("bullet.stl", 2e-4, {"+x": None, "+z": None}),
    Named("flange.stl", 6e-4, {"+x": None, "-y": None, "+z": None}),
    Named("simpleCar.stl", 0.03, {"+x": None, "-y": None}),
]
OPEN = [
    Named("wigley.stl", 0.01, {"+x": "reversed", "-z": "reversed"}),
    Named("wigley-scaled-oriented.stl", 0.006, {"-x": "reversed", "-z": "reversed"}),
    Named("motorBike.obj", 0.025, {"+z": "reversed"}),
    Named("motorBike-passenger-helmet.obj", 0.004, {"+x": "reversed", "+y": "reversed"}),
    Named("propellerTip.obj", 0.0024, {"+x": "normals", "-y": "normals"}),
    Named("propellerStem2.obj", 6e-4, {"-x": "normals", "+z": "normals"}),
    Named("propellerStem3.obj", 1.2e-3, {"+x": "normals", "-z": "normals"}),
]


def expect_installed():
    if not EXAMPLES.is_dir():
        raise unittest.SkipTest("openfoam-examples is not installed")


def all_files():
    """Each content once: many files lie there several times."""
    expect_installed()
    found = {}
    for path in sorted(EXAMPLES.rglob("*")):
        if path.name.removesuffix(".gz").endswith(FORMATS) and path.is_file():
            found.setdefault(hashlib.sha256(path.read_bytes()).digest(), path)
    return list(found.values())


def file_named(name):
    expect_installed()
    return next(path for path in sorted(EXAMPLES.rglob(f"{name}*")) if path.name in (name, name + ".gz") and path.is_file())
