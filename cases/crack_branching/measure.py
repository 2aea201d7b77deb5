#!/usr/bin/env python3
"""Where and when the crack of a run of this case went:

    cases/crack_branching/measure.py results/crack_branching      prints start, branching, arrival, speed

The crack's front is the particle furthest along x whose damage is above 0.35 (a plane through a full family cuts about half of its bonds; the
front of the process zone has less). It has branched at the first place x where the damaged particles of a column leave an undamaged
gap of at least three spacings between an upper and a lower branch, and the gap widens to the end.
"""

import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/pictures"))
from vtp_reader import read_vtp  # noqa: E402

DAMAGED = 0.35


def frames(folder):
    """(time [s], undeformed points [m], damage) of each picture."""
    for entry in xml.parse(folder / "frames/glass.pvd").getroot().iter("DataSet"):
        body = read_vtp(folder / "frames" / entry.get("file"))
        yield float(entry.get("timestep")), body.points - body.point["displacement"], body.point["damage"]


def measure(folder, notch=0.0, edge=0.05):
    times, fronts = [], []
    for time, points, damage in frames(folder):
        cut = points[damage > DAMAGED]
        times.append(time)
        fronts.append(cut[:, 0].max() if len(cut) else notch)
        last = points, damage
    times, fronts = np.array(times), np.array(fronts)
    points, damage = last
    spacing = np.diff(np.unique(np.round(points[:, 0], 7))).min()
    columns = np.round((points[:, 0] - points[:, 0].min()) / spacing).astype(int)
    split = None
    for column in np.unique(columns[points[:, 0] > notch])[::-1]:
        y = np.sort(points[(columns == column) & (damage > DAMAGED), 1])
        if len(y) < 2 or np.diff(y).max() < 4 * spacing:
            break
        split = points[:, 0].min() + column * spacing
    running = fronts > notch + 2 * spacing
    start = times[running][0] if running.any() else None
    arrived = times[fronts > edge - 2 * spacing]
    result = {"spacing [m]": spacing, "starts [s]": start, "branches at [m past the notch]": None if split is None else split - notch}
    if split is not None:
        result["branches [s]"] = np.interp(split, fronts[running], times[running])
        tips = points[(damage > DAMAGED) & (points[:, 0] > points[:, 0].max() - 3 * spacing)]
        if len(tips):
            result["distance of the branches at the far edge [m]"] = np.abs(tips[:, 1]).mean()
    if len(arrived):
        result["far edge [s]"] = arrived[0]
        result["mean speed [m/s]"] = (edge - notch) / (arrived[0] - start)
    return result


if __name__ == "__main__":
    for name, value in measure(Path(sys.argv[1])).items():
        print(f"{name:<48}{'never' if value is None else f'{value:.4g}'}")
