#!/usr/bin/env python3
"""Energy of free impactors with 0.1 to 30 times the mass of a particle that strike elastic blocks, with and without friction: 180 runs at random.

    benchmarks/contact/light_impactors.py [--program PROGRAM]      about eight minutes

Writes results/light_impactors.csv: the largest energy of impactor and block in the run relative to that before, how the run ended, and the steps in which
motion and impulses did not agree. Prints how many runs rose. Exit code 1: a run ended early.
"""

import argparse
import csv
import itertools
import json
import random
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHAPES = {
    "sphere": "sphere: {diameter: 4 mm, edge_length: 0.8 mm}",
    "box": "box: {size: [4 mm, 3 mm, 2 mm], edge_length: 1 mm}",
    "cylinder": "cylinder: {diameter: 3 mm, height: 4 mm, edge_length: 1 mm}",
}
MATERIALS = {
    "bond-based": "model: bond-based, youngs_modulus: 1 GPa",
    "ordinary-state": "model: ordinary-state, youngs_modulus: 1 GPa, poissons_ratio: 0.3",
    "linear-peridynamic-solid": "model: linear-peridynamic-solid, youngs_modulus: 1 GPa, poissons_ratio: 0.3",
    "correspondence": "model: correspondence, youngs_modulus: 1 GPa, poissons_ratio: 0.3",
    "correspondence, silling": "model: correspondence, youngs_modulus: 1 GPa, poissons_ratio: 0.3, stabilisation: silling",
}
RATIOS, FRICTIONS = (0.1, 1, 30), (0, 0.2, 0.5, 1)
PARTICLE = 1000 * 1e-3**3  # [kg]

DECK = """
time: {{end: 0.25 ms}}
bodies:
  block:
    shape: {{box: {{size: [14 mm, 14 mm, 6 mm]}}}}
    spacing: 1 mm
    material: {{{material}, density: 1000}}
impactors:
  light:
    surface: {{{shape}}}
    mass: {mass}
    inertia: {inertia}
    position: {position}
    velocity: {velocity}
    angular_velocity: {spin}
    free_dofs: [x, y, z, rx, ry, rz]
contact:
  impactors: {{friction: {friction}}}
output:
  frames: 0
  history_interval: 1 us
"""


def deck_of(shape, material, ratio, friction, draw):
    mass = ratio * PARTICLE
    speed = draw.uniform(15, 40)
    return DECK.format(
        material=MATERIALS[material], shape=SHAPES[shape], mass=mass, inertia=[mass * (1e-3 * draw.uniform(1, 1.5)) ** 2 for _ in range(3)], friction=friction,
        position=[draw.uniform(-2e-3, 2e-3), draw.uniform(-2e-3, 2e-3), 6.2e-3], velocity=[draw.uniform(-speed, speed), draw.uniform(-speed, speed), -speed],
        spin=[draw.uniform(-1, 1) * speed / 2e-3 for _ in range(3)],
    )  # fmt: skip


def energies(history):
    rows = list(csv.DictReader(history.open()))
    if not any(float(row["light.force_z [N]"]) for row in rows):
        raise SystemExit("an impactor missed the block")
    return [float(row["light.kinetic_energy [J]"]) + float(row["block.kinetic_energy [J]"]) + float(row["block.elastic_energy [J]"]) for row in rows]


def outcome(program, deck):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "deck.yaml").write_text(deck)
        done = subprocess.run([program, "run", folder / "deck.yaml", "--out", folder / "out", "--no-report"], capture_output=True, text=True, check=False)
        if done.returncode not in (0, 3):
            raise SystemExit(done.stderr)
        of_time = energies(folder / "out/history.csv")
        report = json.loads((folder / "out/run.json").read_text())
    disagreed = next((int(warning.split()[1]) for warning in report["warnings"] if "did not agree" in warning), 0)
    return {"exit code": done.returncode, "largest energy": f"{max(of_time) / of_time[0]:.5f}", "steps without agreement": disagreed}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    given = arguments.parse_args()
    draw = random.Random(183)
    rows = []
    for case in itertools.product(SHAPES, MATERIALS, RATIOS, FRICTIONS):
        rows.append(dict(zip(("shape", "material", "mass ratio", "friction"), case)) | outcome(given.program, deck_of(*case, draw)))
    with (ROOT / "benchmarks/results/light_impactors.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, rows[0])
        table.writeheader()
        table.writerows(rows)
    risen = [row for row in rows if float(row["largest energy"]) > 1 + 1e-3]
    early = sum(row["exit code"] != 0 for row in rows)
    print(f"{len(rows)} runs: {len(risen)} rose by more than 0.1 %, {early} ended early, {sum(row['steps without agreement'] > 0 for row in rows)} had steps without agreement")
    for row in risen:
        print("  ", *row.values())
    return 1 if early else 0


if __name__ == "__main__":
    raise SystemExit(main())
