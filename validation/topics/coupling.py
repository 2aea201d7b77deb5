"""The contact library in other methods: SPH and finite elements."""

import re
import subprocess
import sys

from rows import AtLeast, AtMost, Exactly, Row, Within

TITLE = "Contact in SPH and finite elements"
LONG = False


def said(runner, example, *arguments):
    program = runner.program.parent / "tests/library/installed/examples" / example
    if not program.exists():
        sys.exit(f"error: {program} is missing; `./test.sh -R library` builds the examples")
    folder = runner.folder("coupling", example)
    folder.mkdir(parents=True, exist_ok=True)
    return subprocess.run([program, *map(str, arguments)], cwd=folder, capture_output=True, text=True, check=True).stdout


def measure(runner):
    def number(text, pattern):
        return float(re.search(pattern, text)[1])

    water = said(runner, "sph_splash", 0.04, 8)
    wall, wedge = said(runner, "fem_bar", 50).split("wedge,")
    return {
        "contacts": number(water, r"(\d+) contacts"),
        "inside": number(water, r"inside the hull: (\d+)"),
        "water momentum": number(water, r"gravity: (\S+) of the momentum"),
        "stress": number(wall, r"contact stress.*\((\S+) %\)") / 100,
        "lasts": number(wall, r"contact lasts.*\((\S+) %\)") / 100,
        "impulse": number(wall, r"impulse  .*\((\S+) %\)") / 100,
        "wedge inside": number(wedge, r"nodes inside\s+(\d+)"),
        "wedge momentum": number(wedge, r"momentum balance (\S+)"),
    }


def text(n):
    return """Two programs without peridynamics use the contact library alone ([library](library/README.md)): SPH water that falls
on a hull, and a bar of finite elements that hits a wall and a free wedge, with the wave equation as exact solution for the wall."""


def rows():
    wave = "the wave equation in one dimension"
    return [
        Row("SPH: contacts of water with the hull", "[sph_splash](../examples/sph_splash.cpp)", "contacts", "count", AtLeast(10_000), "otherwise the next row is of little significance"),
        Row("SPH: particles ever inside the hull", "planes of the hull, evaluated by the SPH program", "inside", "count", Exactly(0), "a count"),
        Row("SPH: momentum of water and hull, relative to the impulse of gravity", "gravity", "water momentum", "small", AtMost(1e-12), "rounding of 1200 particles over 800 steps"),
        Row("FEM: contact stress of a bar on a wall", wave + ", ρ c v", "stress", "%", Within(0, 0.005), "mean over the middle of the contact; waves behind the front do not average out"),
        Row("FEM: duration of contact", wave + ", 2 L/c", "lasts", "%", Within(0, 0.02), "the front is spread over several of 50 cells"),
        Row("FEM: impulse", wave + ", 2 m v", "impulse", "%", Within(0, 0.02), "the nodes that stop carry half a cell: 1 % of the bar"),
        Row("FEM: nodes inside a free wedge", "geometry", "wedge inside", "count", Exactly(0), "a count"),
        Row("FEM: momentum of bar and wedge, relative to the impulse", "momentum", "wedge momentum", "small", AtMost(1e-12), "rounding of sums over nodes"),
    ]  # fmt: skip
