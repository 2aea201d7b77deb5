#!/usr/bin/python3
"""Angle, time, speed and length of the cracks in a run of this case:

    cases/kalthoff_winkler/measure.py results/kalthoff_winkler [more folders]      prints the rows of expected.csv, and more

A crack consists of the particles in the middle of the thickness (one layer, or the two on either side of z = 0) on the outer side of a notch whose damage
has grown by more than 0.35, and that are connected to the tip of the notch (|x| = 25 mm, y = 0) without gaps wider than 2.5 spacings. A
plane through a full family cuts 0.37 (horizon 3 spacings) to 0.41 (4) of the bonds of the particles beside it: the wake of a crack has more than
0.35, the zone ahead of it less.

angle     Between the notch line and the straight line fitted by orthogonal least squares to the particles of the crack that are 5 mm to 50 mm
          away from the tip, in the first frame in which the crack is 50 mm long (otherwise the last, if it is 25 mm long); mean of left and right.
secant    In the same frame, from the tip of the notch straight to the crack tip (the mean of the particles within 2.5 mm of it).
starts    The first row of history.csv in which more bonds are broken than at t = 0. At a small critical stretch or spacing those are
          under the projectile.
speed     Of the crack tip, a straight line through the frames in which it is 10 mm to 60 mm away from the tip.
length    Straight from the notch tip to the crack tip, at the end.
"""

import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from csv_reader import history  # noqa: E402
from results_folder import options, refuse, run  # noqa: E402
from vtp_reader import pictures  # noqa: E402

DAMAGED = 0.35
TIP = 0.025  # [m] |x| of both notches; they end at y = 0
NEAR, FAR, SHORT = 0.005, 0.050, 0.025  # [m] from the tip
LEFT, RIGHT = -1, 1


def frames(folder):
    """(time [s], reference positions x, y [m], growth of damage) in the middle of the thickness, of each frame."""
    notched = None
    for time, body in pictures(folder, "plate"):
        points = body.points - body.point["displacement"]
        depth = np.abs(points[:, 2])
        middle = depth < depth.min() + 1e-6
        damage = body.point["damage"][middle]
        notched = damage if notched is None else notched
        yield time, points[middle, :2], damage - notched


def crack(points, damage, side):
    """The particles of a crack, seen from the tip of its notch: x outwards, y along the notch line away from the impacted edge [m]."""
    seen = np.column_stack([side * points[:, 0] - TIP, -points[:, 1]])
    gap = 2.5 * np.diff(np.unique(np.round(points[:, 0], 7))).min()
    rest = seen[(damage > DAMAGED) & (seen[:, 0] > 0)]
    together = [np.zeros((1, 2))]  # the tip, then its neighbours ring by ring
    while len(rest) and len(together[-1]):
        near = (np.hypot(*(rest[:, None] - together[-1]).transpose(2, 0, 1)) < gap).any(axis=1)
        together.append(rest[near])
        rest = rest[~near]
    return np.concatenate(together[1:]) if len(together) > 1 else np.zeros((0, 2))


def length(cut):
    return np.hypot(*cut.T).max(initial=0)


def degrees(direction):
    """From the notch line, of a direction pointing outwards."""
    return np.degrees(np.arctan2(abs(direction[0]), np.sign(direction[0]) * direction[1]))


def angle(cut):
    if length(cut) < SHORT:
        return None
    away = np.hypot(*cut.T)
    fitted = cut[(away > NEAR) & (away < FAR)]
    return degrees(np.linalg.svd(fitted - fitted.mean(axis=0), full_matrices=False)[2][0])


def secant(cut):
    return degrees(cut[np.hypot(*cut.T) > length(cut) - 0.0025].mean(axis=0)) if length(cut) > SHORT else None


def of_both(values):
    return None if None in values else float(np.mean(values))


def measure(folder):
    """Name with unit, and value (None: it did not occur)."""
    rows = history(folder)
    clock, broken = rows["time [s]"], rows["plate.broken_bonds [-]"]

    times, cracks = [], []
    for time, points, damage in frames(folder):
        times.append(time)
        cracks.append([crack(points, damage, side) for side in (LEFT, RIGHT)])
    lengths = np.array([[length(cut) for cut in pair] for pair in cracks]).mean(axis=1)
    long_enough = np.flatnonzero(lengths > FAR)
    chosen = cracks[long_enough[0] if len(long_enough) else -1]
    angles = [angle(cut) for cut in chosen]
    running = (lengths > 0.010) & (lengths < 0.060)
    return {
        "angle [deg]": of_both(angles),
        "angle right minus left [deg]": None if None in angles else angles[1] - angles[0],
        "secant [deg]": of_both([secant(cut) for cut in chosen]),
        "starts [s]": clock[broken > broken[0]][0] if broken[-1] > broken[0] else None,
        "speed [m/s]": np.polyfit(np.array(times)[running], lengths[running], 1)[0] if running.sum() > 2 else None,
        "length [m]": lengths[-1],
        "projectile at 65 us [m/s]": np.interp(65e-6, clock, rows["projectile.velocity_y [m/s]"]) if clock[-1] > 65e-6 else None,
    }


def main():
    for folder in options(__doc__, nargs="+").parse_args().results:
        print(folder)
        for name, value in measure(folder).items():
            print(f"    {name:<36}{'–' if value is None else f'{value:.4g}'}")


if __name__ == "__main__":
    run(main)
