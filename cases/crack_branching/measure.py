#!/usr/bin/python3
"""Times and positions of the crack in a run of this case:

    cases/crack_branching/measure.py results/crack_branching [more folders]      prints the rows of expected.csv, and more

Particles with a damage above 0.35 are the wake of the crack: a plane through a full family cuts 0.40 of the bonds of the particles beside it,
the zone ahead of the crack has fewer broken bonds.

starts        the tip, the damaged particle furthest along x, is 1 mm past the end of the notch (times are interpolated between frames)
branches at   smallest x beyond which, in the last frame, each column of particles has damaged ones above and below with three or more undamaged
              ones between them; its time is when the tip was there
far edge      the tip is 1 mm from the edge, where the crack leaves the plate
exit          mean distance from the centre line of the damaged particles that are at most 1 mm from the far edge; "up minus down" is the difference
              between the upper and the lower branch
speeds        of the tip, fitted straight lines: before, from 2 mm past the notch to 2 mm before the branching, after, from 4 mm behind it to 5 mm before the edge
"""

import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from results_folder import options, refuse, run  # noqa: E402
from vtp_reader import pictures  # noqa: E402

DAMAGED = 0.35
NOTCH, EDGE = 0.0, 0.05  # [m] x of the notch's end, of the far edge


def frames(folder):
    """(time [s], reference positions [m], damage) of each frame."""
    for time, body in pictures(folder, "glass"):
        yield time, body.points - body.point["displacement"], body.point["damage"]


def branching(cut, spacing):
    """x [m] beyond which the crack has two branches; None without branching."""
    columns = np.round(cut[:, 0] / spacing, 3)
    found = None
    for column in np.unique(columns)[::-1]:
        y = np.sort(cut[columns == column, 1])
        is_tip = column * spacing > cut[:, 0].max() - 0.002  # here one of two branches may be ahead
        if np.diff(y).max(initial=0) > 3.5 * spacing:
            found = column * spacing
        elif not is_tip:
            break
    return found


def speed(times, fronts, low, high):
    between = (fronts > low) & (fronts < high)
    return np.polyfit(times[between], fronts[between], 1)[0] if between.sum() > 2 else None


def measure(pictures):
    """Name with unit, and value (None: it did not occur), from the output of `frames`."""
    times, fronts = [], []
    for time, points, damage in pictures:
        cut = points[(damage > DAMAGED) & (points[:, 0] > NOTCH)]
        times.append(time)
        fronts.append(cut[:, 0].max(initial=NOTCH))
    times, fronts = np.array(times), np.array(fronts)

    def when(x):
        """Time at which the tip reached x [m]; None if it did not."""
        return np.interp(x, fronts, times) if fronts[-1] >= x else None

    spacing = np.diff(np.unique(np.round(points[:, 0], 7))).min()
    split = branching(cut, spacing)
    start, arrival = when(NOTCH + 0.001), when(EDGE - 0.001)
    exits = [np.abs(cut[(cut[:, 0] > EDGE - 0.001) & (side * cut[:, 1] > 0), 1]) for side in (1, -1)]
    left_on_both = min(map(len, exits)) > 0
    return {
        "starts [s]": start,
        "branches at [m]": None if split is None else split - NOTCH,
        "branches [s]": None if split is None else when(split),
        "far edge [s]": arrival,
        "exit [m]": np.mean([y.mean() for y in exits]) if left_on_both else None,
        "exit up minus down [m]": exits[0].mean() - exits[1].mean() if left_on_both else None,
        "speed before [m/s]": None if split is None else speed(times, fronts, NOTCH + 0.002, split - 0.002),
        "speed after [m/s]": None if split is None else speed(times, fronts, split + 0.004, EDGE - 0.005),
        "mean speed [m/s]": None if arrival is None else (EDGE - NOTCH - 0.002) / (arrival - start),
    }


def show(title, values):
    print(title)
    for name, value in values.items():
        print(f"    {name:<28}{'–' if value is None else f'{value:.4g}'}")


def main():
    for folder in options(__doc__, nargs="+").parse_args().results:
        show(folder, measure(frames(folder)))


if __name__ == "__main__":
    run(main)
