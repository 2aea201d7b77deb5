#!/usr/bin/python3
"""Strengths and energy balance of the specimens of this case:

    cases/ice_specimens/measure.py results/ice_specimens      prints the rows of expected.csv, and more

The folder contains the results of any of the decks compression, bending, indentation, punch; missing ones are skipped.

compressive strength   largest mean force on both platens over the first cross-section
flexural strength      largest load of both lines before the first bond breaks, as the stress at the surface of a beam: 3 F a/(b h²), a from support to load
punch                  mean pressure under the punch over the compressive strength, at the end
indentation            contact force over the area of the sphere's cap below the first surface, mean over the rows in which that is 0.3 to 0.8 m²
energy error           largest total.energy_balance_error over the external work
"""

import csv
import math
import sys
from pathlib import Path

STRENGTH = 2.3e6  # [Pa] of all decks
SIDE = 0.1  # [m] of the prism
ARM, WIDTH, HEIGHT = 0.6, 0.2, 0.2  # [m] of the beam
PUNCH = 0.16, 0.07  # [m] width, depth of the block
RADIUS, SPEED, GAP = 0.6, 2.0, 0.001  # [m] [m/s] [m] of the sphere
AREAS = 0.3, 0.8  # [m²]


def history(folder):
    """Rows of history.csv by their headings without units."""
    with open(Path(folder) / "history.csv", newline="") as file:
        return [{key.split(" [")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def energy_error(rows, *works):
    work = max(abs(sum(row[name] for name in works)) for row in rows)
    return max(abs(row["total.energy_balance_error"]) for row in rows) / work


def compression(folder):
    """(strain [-] of the whole prism, mean stress [Pa]) of each row."""
    ends = 0.19  # [m] between the layers that are moved
    ramp, end_speed = 2.4e-3, 0.035

    def travel(time):
        return 2 * end_speed * (time - ramp / 2 if time > ramp else time * time / (2 * ramp))

    return [(travel(row["time"]) / ends, 0.5 * (row["ice.bottom.force_z"] - row["ice.top.force_z"]) / SIDE**2) for row in history(folder)]


def bending(folder):
    """(time [s], stress [Pa] at the surface of a beam under these loads, broken bonds) of each row."""
    scale = 3 * ARM / (WIDTH * HEIGHT**2)
    return [(row["time"], -scale * (row["ice.load_left.force_z"] + row["ice.load_right.force_z"]), row["ice.broken_bonds"]) for row in history(folder)]


def punch(folder):
    """(depth over width [-], mean pressure over the compressive strength [-]) of each row."""
    width, depth = PUNCH
    ramp, speed = 4e-3, 0.15
    found = []
    for row in history(folder):
        time = row["time"]
        travel = speed * (time - ramp / 2 if time > ramp else time * time / (2 * ramp))
        found.append((travel / width, -row["block.punch.force_z"] / (width * depth) / STRENGTH))
    return found


def indentation(folder):
    """(area [m²] of the cap, mean pressure [Pa]) of each row in which the sphere is deeper than 2 cm."""
    found = []
    for row in history(folder):
        depth = SPEED * row["time"] - GAP
        if depth > 0.02:
            area = math.pi * (2 * RADIUS * depth - depth**2)
            found.append((area, row["sphere.force_z"] / area))
    return found


def measure(folder):
    folder, found = Path(folder), {}
    if (folder / "compression").is_dir():
        found["compressive strength [MPa]"] = max(stress for _, stress in compression(folder / "compression")) / 1e6
        found["compression energy error [-]"] = energy_error(history(folder / "compression"), "ice.top.work", "ice.bottom.work")
    if (folder / "bending").is_dir():
        found["flexural strength [MPa]"] = max(stress for _, stress, broken in bending(folder / "bending") if broken == 0) / 1e6
        found["bending energy error [-]"] = energy_error(history(folder / "bending"), "ice.load_left.work", "ice.load_right.work")
    if (folder / "punch").is_dir():
        found["punch [-]"] = punch(folder / "punch")[-1][1]
        found["punch energy error [-]"] = energy_error(history(folder / "punch"), "block.punch.work")
    if (folder / "indentation").is_dir():
        curve = [pressure for area, pressure in indentation(folder / "indentation") if AREAS[0] < area < AREAS[1]]
        found["indentation pressure [MPa]"] = sum(curve) / len(curve) / 1e6
        local = [pressure / (7.4e6 * area**-0.7) for area, pressure in indentation(folder / "indentation") if AREAS[0] < area < AREAS[1]]
        found["indentation over 7.4 A^-0.7 [-]"] = max(local)
        found["indentation energy error [-]"] = energy_error(history(folder / "indentation"), "sphere.contact_work")
    return found


if __name__ == "__main__":
    for path in sys.argv[1:]:
        for name, value in measure(path).items():
            print(f"{name:36}{value:.6g}")
