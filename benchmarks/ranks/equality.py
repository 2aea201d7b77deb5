#!/usr/bin/env python3
"""Shipped decks on 1, 2, 3, 4, 7 and 8 processes (ranks) of 1 and 2 threads: state and all result files against those of one process, byte for byte.

    benchmarks/ranks/equality.py [DECK ...]    writes results/ranks_equality.csv; some 20 minutes on two cores

The decks are reduced in spacing and time, but until impactors have been in contact and bonds have broken. history.csv has a row every ten steps, with exact
sums over all particles; state_hash, of the end, is that of all positions, velocities and bonds. Exit code 1: something differs, or a
deck does not do what it is to show. 2: a run fails.
"""

import argparse
import csv
import os
import random
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks/plate"))
import programs  # noqa: E402

CASES = ROOT / "cases"
PLATE = {"bodies.plate.spacing": "2 mm", "bodies.plate.shape.box.size": "[200 mm, 100 mm, 8 mm]", "time.step": "0.18 us"}
TOUGH = {"bodies.plate.material.critical_stretch": 0.002}
PROPELLER = {"bodies.ice.spacing": 0.1, "time.end": "20 ms", "bodies.ice.material.critical_stretch": 3.2e-4}


def plate(steps, *more):
    changes = PLATE | {"time.end": f"{0.18 * steps:g} us", "output.history_interval": "1.8 us", "output.frames": 4}
    for change in more:
        changes |= change
    return "plate_impact/deck.yaml", changes


def points(folder):
    """A plate of scattered points in the place of that of the deck."""
    scatter = random.Random(7)
    file = Path(folder) / "points.csv"
    with file.open("w") as out:
        out.write("x [m],y [m],z [m],volume [m3]\n")
        for i in range(100):
            for j in range(50):
                for k in range(4):
                    x, y, z = (0.002 * (number + 0.5 + scatter.uniform(-0.2, 0.2)) for number in (i, j, k))
                    out.write(f"{x - 0.1:.9g},{y - 0.05:.9g},{z - 0.004:.9g},8e-9\n")
    return {"bodies.plate.shape": f"{{points: {{file: {file}}}}}", "bodies.plate.spacing": None, "impactors.cylinder.position": "[0, 75.5 mm, 0]"}


# name: deck, changes, whether bonds break
DECKS = {
    "plate": (*plate(300), False),
    "kalthoff": ("kalthoff_winkler/deck.yaml", PLATE | {"bodies.plate.shape.box.size": "[202 mm, 100 mm, 8 mm]", "time.end": "72 us", "output.history_interval": "1.8 us",
                                                        "output.frames": 4}, True),
    "ship, with fragments and water": ("ship_ice/deck.yaml", {"time.end": "1 s", "output.history_interval": "2.35 ms",
                                                              "output.frames": 4}, True),
    "propeller": ("propeller_ice/deck.yaml", PROPELLER | {"output.frames": 4}, True),
    "correspondence": (*plate(300, {"bodies.plate.material.model": "correspondence"}, TOUGH), True),
    "hardening": (*plate(300, {"bodies.plate.failure": "{compression_hardening: 0.3}"}, TOUGH), True),
    "plastic ice": ("ice_sphere/crushed.yaml", {"bodies.ice.spacing": 0.1, "time.end": "30 ms", "output.frames": 4}, True),
    "a cloud": (*plate(300, TOUGH), True),
    "two impactors": (*plate(300, TOUGH, {"impactors.ball": "{surface: {sphere: {diameter: 20 mm, edge_length: 2 mm}}, mass: 30 g, position: [30 mm, 5 mm, 14.5 mm], "
                                                            "velocity: [0, 0, -60 m/s], free_dofs: [z]}"}), True),
}  # fmt: skip


def run(program, name, folder, out, ranks, threads):
    """The report of the run, and its other files by name."""
    deck, changes, _ = DECKS[name]
    if name == "a cloud":
        changes = changes | points(folder)
    words = [word for key, value in changes.items() if value is not None for word in ("--set", f"{key}={value}")]
    deck = CASES / deck
    if None in changes.values():  # keys of the deck that go
        lines = deck.read_text().splitlines(keepends=True)
        gone = [key.rsplit(".")[-1] + ":" for key, value in changes.items() if value is None]
        deck = Path(folder) / "deck.yaml"
        deck.write_text("".join(line for line in lines if not line.lstrip().startswith(tuple(gone))))
    launcher = programs.mpirun(ranks) if ranks > 1 else []
    command = [*launcher, program, "run", deck, "--out", out, "--no-report", "--threads", str(threads), *words]
    programs.run(command, os.sched_getaffinity(0), programs.AS_ROOT | {"OMP_WAIT_POLICY": "passive"})
    return programs.results_of(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("decks", nargs="*", choices=[[], *DECKS], help="all by default")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    parser.add_argument("--out", type=Path, default=ROOT / "benchmarks/results/ranks_equality.csv")
    arguments = parser.parse_args()
    arguments.program = arguments.program.resolve()
    table, differs = [], False
    for name in arguments.decks or DECKS:
        with tempfile.TemporaryDirectory() as folder:
            one, wanted = run(arguments.program, name, folder, Path(folder) / "one", 1, 1)
            breaks = DECKS[name][2]
            if not programs.has_values(wanted["history.csv"], ".contacts [-]") or programs.has_values(wanted["history.csv"], ".broken_bonds [-]") != breaks:
                sys.exit(f"{name}: without contact, or {'no bonds' if breaks else 'bonds'} break")
            for ranks in 1, 2, 3, 4, 7, 8:
                for threads in 1, 2:
                    if (ranks, threads) == (1, 1):
                        continue
                    report, files = run(arguments.program, name, folder, Path(folder) / f"{ranks}_{threads}", ranks, threads)
                    unequal = [file for file in wanted.keys() | files.keys() if wanted.get(file) != files.get(file)]
                    equal = not unequal and report["state_hash"] == one["state_hash"]
                    differs = differs or not equal
                    table.append([name, one["steps"], ranks, threads, report["state_hash"], len(files), "equal" if equal else "differs"])
                    print(*table[-1], *unequal[:5], flush=True)
    with arguments.out.open("w", newline="") as out:
        csv.writer(out).writerows([["deck", "steps", "ranks", "threads", "state_hash", "files", "to one process"], *table])
    return 1 if differs else 0


if __name__ == "__main__":
    programs.exit_with(main)
