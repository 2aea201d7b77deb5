#!/usr/bin/python3
"""Impulse, peak force and duration of the impact:

    cases/ice_sphere/measure.py results/ice_sphere [more folders]

impulse       of the plate, along its normal, over (mass of the particles) × (initial speed): 1 without rebound, 2 for full rebound
peak, at      the largest mean over a row of history.csv (0.1 or 0.05 ms), and the middle of that row, from first contact
duration      from the first row with a force to the end of the last one, if the sphere stays intact
over Hertz    peak and duration over those of Hertz contact of the same ice with a rigid plane: an elastic sphere of radius R, mass m and speed v
              has F = 5/4 m v²/d, t = 2.943 d/v with d = (15 m v²/(16 E* √R))^(2/5), E* = E/(1 - ν²) (H. Hertz; K. L. Johnson, Contact
              Mechanics, 1985, section 11.4). m is the mass of the particles.
"""

import csv
import json
import sys
from pathlib import Path

import numpy as np

YOUNG, POISSON, RADIUS = 1.8e9, 0.25, 0.5  # [Pa] [-] [m]


def hertz(mass, speed):
    """Largest force [N], duration [s], largest approach [m]."""
    modulus = YOUNG / (1 - POISSON**2)
    approach = (15 * mass * speed**2 / (16 * modulus * np.sqrt(RADIUS))) ** 0.4
    return 1.25 * mass * speed**2 / approach, 2.943 * approach / speed, approach


def blow(folder):
    """Ends of the rows [s], their lengths [s], mean normal force on the plate in each [N], mass [kg] and speed [m/s] of the ice at t = 0."""
    with open(Path(folder) / "history.csv", newline="") as file:
        names, *rows = csv.reader(file)
    column = dict(zip(names, np.array(rows, float).T))
    run = json.loads((Path(folder) / "run.json").read_text())
    velocity = np.array(run["setup"]["bodies"]["ice"]["velocity"])
    speed = np.linalg.norm(velocity)
    force = np.column_stack([column[f"plate.force_{axis} [N]"] for axis in "xyz"]) @ velocity / speed
    times = column["time [s]"]
    return times, np.diff(times, prepend=0), force, run["bodies"]["ice"]["mass [kg]"], speed, run


def measure(folder):
    times, steps, force, mass, speed, run = blow(folder)
    touched = np.flatnonzero(force > 0)
    largest, long, _ = hertz(mass, speed)
    begin = times[touched[0]] - steps[touched[0]]
    duration = times[touched[-1]] - begin
    body = run["bodies"]["ice"]
    whole = body["intact_bonds"] == body["bonds"]
    return {
        "impulse [-]": (force * steps).sum() / (mass * speed),
        "peak [N]": force.max(),
        "at [s]": times[force.argmax()] - steps[force.argmax()] / 2 - begin,
        "peak over Hertz [-]": force.max() / largest,
        "duration [s]": duration if whole else None,
        "duration over Hertz [-]": duration / long if whole else None,
        "broken bonds [-]": 1 - body["intact_bonds"] / body["bonds"],
    }


if __name__ == "__main__":
    for folder in sys.argv[1:]:
        print(folder)
        for name, value in measure(folder).items():
            print(f"    {name:<26}{'–' if value is None else f'{value:.7g}'}")
