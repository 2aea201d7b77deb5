#!/usr/bin/python3
"""Reported and measured memory: what `perimpact check` reports as the peak of a run, and the largest resident set of that run, for bodies of every kind.

    benchmarks/memory/memory.py PERIMPACT [--only NAME] [--size SHARE]  > benchmarks/results/memory_MACHINE.csv

Each run is short: the peak is reached while the body is set up, in a step, or in the output frame at the end. The decks are written to a temporary folder.
"""

import argparse
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

MATERIAL = {
    "elastic": "model: bond-based, youngs_modulus: 1 GPa, density: 1000",
    "brittle": "model: bond-based, youngs_modulus: 1 GPa, density: 1000, critical_stretch: 0.01",
    "state": "model: ordinary-state, youngs_modulus: 1 GPa, poissons_ratio: 0.3, density: 1000",
    "correspondence": "model: correspondence, youngs_modulus: 1 GPa, poissons_ratio: 0.3, density: 1000",
    "plastic": "model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.3, density: 900, plasticity: {}",
}
BALL = ("impactors: {s: {surface: {sphere: {diameter: 0.2, edge_length: 0.02}}, mass: 10, position: [0, 0, {height}], velocity: [0, 0, -10], free: [z]{more}}}\n")
WATER = ", floating: {}"


def box(size, x, y, z):
    x, y, z = (max(4, round(n * size ** (1 / 3))) for n in (x, y, z))
    return f"shape: {{box: {{size: [{x / 100:g}, {y / 100:g}, {z / 100:g}]}}}}, spacing: 0.01", z / 100


def points(folder, size, n):
    """A cubic grid with every point moved by up to a fifth of its spacing."""
    n = max(6, round(n * size ** (1 / 3)))
    chance = random.Random(1)
    with open(folder / "points.csv", "w") as file:
        file.write("x [m],y [m],z [m],volume [m3]\n")
        for k in range(n**3):
            cell = (k % n, k // n % n, k // n**2)
            file.write(",".join(f"{0.01 * (c - n / 2 + chance.uniform(-0.2, 0.2)):.6g}" for c in cell) + ",1e-6\n")
    return "shape: {points: {file: points.csv}}", n / 100


FRAGMENTS = "contact: {fragments: {law: repulsive}}\n"
#        name                                                         body                       material        impactor  rest
BODIES = [
    ("lattice, bond-based", (lambda f, s: box(s, 100, 100, 100)), "elastic", None, ""),
    ("lattice, bond-based, with impactor", (lambda f, s: box(s, 100, 100, 100)), "elastic", "", ""),
    ("lattice, state-based", (lambda f, s: box(s, 100, 100, 100)), "state", None, ""),
    ("lattice, state-based, with impactor", (lambda f, s: box(s, 100, 100, 100)), "state", "", ""),
    ("thin plate, state-based, with impactor in water", (lambda f, s: box(s, 400, 400, 6)), "state", WATER, ""),
    ("lattice, breaking, with impactor", (lambda f, s: box(s, 100, 100, 100)), "brittle", "", ""),
    ("lattice, plasticity, with impactor", (lambda f, s: box(s, 80, 80, 80)), "plastic", "", ""),
    ("lattice, contact of fragments", (lambda f, s: box(s, 100, 100, 100)), "brittle", None, FRAGMENTS),
    ("lattice, contact of fragments, with impactor", (lambda f, s: box(s, 100, 100, 100)), "brittle", "", FRAGMENTS),
    ("ball, state-based", (lambda f, s: (f"shape: {{sphere: {{diameter: {1.2 * s ** (1 / 3):g}}}}}, spacing: 0.01", 1.2 * s ** (1 / 3))), "state", None, ""),
    ("lattice, bond-based, with impactor of many panels", (lambda f, s: box(s, 50, 50, 50)), "elastic", "fine", ""),
    ("lattice, correspondence", (lambda f, s: box(s, 80, 80, 60)), "correspondence", "", ""),
    ("cloud, bond-based", (lambda f, s: points(f, s, 36)), "elastic", None, ""),
    ("cloud, breaking, contact of fragments, with impactor", (lambda f, s: points(f, s, 36)), "brittle", "", FRAGMENTS),
    ("cloud, state-based, with impactor", (lambda f, s: points(f, s, 36)), "state", "", ""),
    ("cloud, correspondence", (lambda f, s: points(f, s, 36)), "correspondence", None, ""),
]


def write_deck(folder, size, body, material, impactor, rest):
    shape, height = body(folder, size)
    deck = (f"title: Memory\ntime: {{end: 0.1 ms}}\noutput: {{frames: 1, folder: r}}\nbodies: {{b: {{{shape}, velocity: [1, 2, 3], material: {{{MATERIAL[material]}}}}}}}\n" + rest)
    if impactor is not None:
        ball = BALL.replace("edge_length: 0.02", "edge_length: 0.0007") if impactor == "fine" else BALL
        deck += ball.replace("{height}", f"{height / 2 + 0.11:g}").replace("{more}", impactor.replace("fine", ""))
    (folder / "deck.yaml").write_text(deck)


def reported(program, folder):
    """[byte], particles"""
    text = subprocess.run([program, "check", "deck.yaml", "--threads", "2"], cwd=folder, check=True, capture_output=True, text=True).stdout
    found = re.search(r"\n  peak +about ([\d.]+) (MB|GB)", text)
    return float(found[1]) * {"MB": 1e6, "GB": 1e9}[found[2]], int(re.search(r"\n  particles +(\d+)", text)[1])


def measured(program, folder):
    """[byte] largest resident set"""
    with subprocess.Popen([program, "run", "deck.yaml", "--threads", "2", "--no-report", "--force"], cwd=folder, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"the run ended with {process.returncode}")
    return 1024 * usage.ru_maxrss


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=lambda path: str(Path(path).resolve()))
    parser.add_argument("--only", default="", help="bodies whose name contains this")
    parser.add_argument("--size", type=float, default=1, help="share of the particles")
    arguments = parser.parse_args()
    print("body,particles,reported [MB],measured [MB],reported/measured [-]")
    for name, body, material, impactor, rest in BODIES:
        if arguments.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            write_deck(Path(folder), arguments.size, body, material, impactor, rest)
            said, particles = reported(arguments.program, folder)
            taken = measured(arguments.program, folder)
        print(f'"{name}",{particles},{said / 1e6:.0f},{taken / 1e6:.0f},{said / taken:.2f}', flush=True)


if __name__ == "__main__":
    main()
