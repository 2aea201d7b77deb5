#!/usr/bin/python3
"""Runs hertz.yaml with other spacings, masses, speeds and steps, and prints the tables of energy.md:

    docs/theory/energy/hertz.py BINARY FOLDER [LARGEST]    up to LARGEST particles across (60)

Largest force and duration are compared with Hertz (K. L. Johnson, Contact Mechanics, 1985, section 11.4): two balls of the radii R1 and R2, one of them
rigid, with the reduced mass m and the speed v of approach have F = 5/4 m v²/d, t = 2.943 d/v, d = (15 m v²/(16 E* √R))^(2/5), 1/R = 1/R1 + 1/R2,
E* = E/(1 - ν²). The force is the mean of a row along the line of the blow, the duration that for which it is more than 1 % of the largest.
"""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts/results"))
from csv_reader import history  # noqa: E402

DECK = Path(__file__).with_name("hertz.yaml")
YOUNG, POISSON, RADIUS = 1.8e9, 0.25, 0.5 * 2.0 / (0.5 + 2.0)  # [Pa] [-] [m]
ALONG = np.array([1, 2, 3]) / np.sqrt(14)


MATERIAL = "youngs_modulus: 1.8 GPa, poissons_ratio: 0.25, density: 900"


def measure(folder):
    column = history(folder)
    run = json.loads((folder / "run.json").read_text())
    setup = run["setup"]["impactors"]["rigid"]
    soft, hard, speed = run["bodies"]["elastic"]["mass [kg]"], setup["mass"], np.linalg.norm(setup["velocity"])
    mass = soft * hard / (soft + hard)
    approach = (15 * mass * speed**2 / (16 * YOUNG / (1 - POISSON**2) * np.sqrt(RADIUS))) ** 0.4
    force = -np.column_stack([column[f"rigid.force_{axis} [N]"] for axis in "xyz"]) @ ALONG
    times = column["time [s]"]
    pressed = np.flatnonzero(force > 0.01 * force.max())
    energy, brought = column["total.energy [J]"], mass * speed**2 / 2
    return {
        "step": run["time [s]"] / run["steps"],
        "peak": force.max() / (1.25 * mass * speed**2 / approach),
        "duration": (times[pressed[-1]] - times[pressed[0] - 1]) / (2.943 * approach / speed),
        "loss": column["total.contact_dissipation [J]"][-1] / brought,
        "rise": (energy.max() - energy[0]) / energy[0],
        "closing": np.abs(column["total.energy_balance_error [J]"]).max() / brought,
        "momentum": max(np.abs(column[f"total.momentum_{axis} [kg m/s]"] / column[f"total.momentum_{axis} [kg m/s]"][0] - 1).max() for axis in "xyz"),
    }


def main(program, out, largest=60):
    def show(name, across=40, mass=471.2, speed=20, step=None, model=None):
        folder = out / name.replace(" ", "_").replace("/", "_")
        if not (folder / "run.json").exists():
            values = [f"bodies.elastic.spacing={1 / across}", f"impactors.rigid.mass={mass}", f"impactors.rigid.velocity={(speed * ALONG).tolist()}"]
            values += [f"time.end={8e-3 * 20 / speed}", f"output.history_interval={5e-5 * 20 / speed}"]
            values += [f"time.step={step}"] if step else []
            values += [f"bodies.elastic.material={{model: {model}, {MATERIAL}}}"] if model else []
            command = [program, "run", DECK, "--out", folder, "--force", "--threads", "1", "--no-report"]
            subprocess.run(command + [word for value in values for word in ("--set", value)], check=True, stdout=subprocess.DEVNULL)
        found = measure(folder)
        print(f"| {name} | " + " | ".join(f"{key} {value:.4g}" for key, value in found.items()) + " |", flush=True)
        return found["step"]

    for model in ("correspondence", "correspondence, stabilisation: wan", "linear-peridynamic-solid"):
        show(f"40 across, {model}", model=model)
    for across in (20, 30, 40, 60, 80):
        if across <= largest:
            show(f"{across} across", across)
    automatic = show("40 across")
    for part in (2, 4):
        show(f"40 across, step/{part}", step=automatic / part)
    for mass in (47.12, 4712):
        show(f"40 across, {mass} kg", mass=mass)
    for speed in (10, 5):
        show(f"40 across, {speed} m/s", speed=speed)


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]), *map(int, sys.argv[3:]))
