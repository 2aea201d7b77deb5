#!/usr/bin/python3
"""Where the ice goes that the bow displaces: clearing.py RESULTS [--time TIME]

From one output frame: of the particles that were within the waterline of the ship before, by their present distance behind the stem, how far
they have been moved down and aside on average, how many of them are under or beside the hull's waterline now, and how many have lost nine tenths of their bonds.
Lindqvist's potential energy of submerged ice takes the mean depth T (B + T)/(B + 2T).
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent / "../ship_ice"))
from measure import bow_length, breadth_of_waterline, history, options, report_of, run  # noqa: E402  which makes scripts/results importable
from vtp_reader import picture_at  # noqa: E402

ZONE = 10.0  # [m] along the ship


def main():
    arguments = options(__doc__)
    arguments.add_argument("--time", type=float, default=1e9, help="[s]; the last frame where absent")
    given = arguments.parse_args()
    time, sheet = picture_at(given.results, "sheet", given.time)
    displacement, damage = sheet.point["displacement"], sheet.point["damage"]
    before = sheet.points - displacement
    rows, setup = history(given.results), report_of(given.results)["setup"]["impactors"]["ship"]
    travel = np.interp(time, rows["time [s]"], rows["ship.position_x [m]"][0] - rows["ship.position_x [m]"])
    stem = setup["position"][0] - travel
    behind = sheet.points[:, 0] - stem
    hull = setup["surface"]["hull"]
    beam, draft = hull["breadth"], hull["draft"]

    def is_within(points):
        return np.abs(points[:, 1]) < breadth_of_waterline(hull, points[:, 0] - stem) / 2

    within, within_now = is_within(before), is_within(sheet.points)
    print(f"{time:.1f} s; mean depth of Lindqvist's submerged ice {draft * (beam + draft) / (beam + 2 * draft):.1f} m")
    print("| behind the stem [m] | moved down [m] | aside [m] | deepest [m] | still within the waterline | single particles |\n|---|---|---|---|---|---|")
    for begin in np.arange(0, bow_length(hull), ZONE):
        chosen = within & (behind >= begin) & (behind < begin + ZONE)
        if not chosen.any():
            continue
        moved = displacement[chosen]
        print(f"| {begin:.0f} to {begin + ZONE:.0f} | {-moved[:, 2].mean():.1f} | {np.abs(moved[:, 1]).mean():.1f} | {-sheet.points[chosen, 2].min():.1f} | {100 * within_now[chosen].mean():.0f} % | {100 * (damage[chosen] > 0.9).mean():.0f} % |")


if __name__ == "__main__":
    run(main)
