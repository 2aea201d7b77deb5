#!/usr/bin/python3
"""Where the ice goes that the bow displaces: clearing.py RESULTS [--time TIME]

From one output frame of a run of test 302: of the particles that were within the waterline of the ship before, by their present distance behind the stem, how far
they have been moved down and aside on average, how many of them are under or beside the hull's waterline now, and how many have lost nine tenths of their bonds.
Lindqvist's potential energy of submerged ice takes the mean depth T (B + T)/(B + 2T).
"""

import argparse
from math import radians, tan
from pathlib import Path

import numpy as np
from decks import HERE, UIKKU  # noqa: F401  which makes ../ship_ice importable, and measure.py that of scripts/results
from measure import report_of
from csv_reader import history
from vtp_reader import picture_at

ZONE = 10.0  # [m] along the ship


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("results", type=Path)
    arguments.add_argument("--time", type=float, default=1e9, help="[s]; the last frame where absent")
    given = arguments.parse_args()
    time, sheet = picture_at(given.results, "sheet", given.time)
    displacement, damage = sheet.point["displacement"], sheet.point["damage"]
    before = sheet.points - displacement
    rows, setup = history(given.results), report_of(given.results)["setup"]["impactors"]["ship"]
    travel = np.interp(time, rows["time [s]"], rows["ship.position_x [m]"][0] - rows["ship.position_x [m]"])
    stem = setup["position"][0] - travel
    behind = sheet.points[:, 0] - stem
    half = np.clip((before[:, 0] - stem) * tan(radians(UIKKU.waterline)), 0, UIKKU.beam / 2)
    within = np.abs(before[:, 1]) < half
    print(f"{time:.1f} s; mean depth of Lindqvist's submerged ice {UIKKU.draft * (UIKKU.beam + UIKKU.draft) / (UIKKU.beam + 2 * UIKKU.draft):.1f} m")
    print("| behind the stem [m] | moved down [m] | aside [m] | deepest [m] | still within the waterline | single particles |\n|---|---|---|---|---|---|")
    for begin in np.arange(0, UIKKU.astern, ZONE):
        chosen = within & (behind >= begin) & (behind < begin + ZONE)
        if not chosen.any():
            continue
        moved = displacement[chosen]
        now = np.abs(sheet.points[chosen, 1]) < np.clip(behind[chosen] * tan(radians(UIKKU.waterline)), 0, UIKKU.beam / 2)
        print(f"| {begin:.0f} to {begin + ZONE:.0f} | {-moved[:, 2].mean():.1f} | {np.abs(moved[:, 1]).mean():.1f} | {-sheet.points[chosen, 2].min():.1f} | {100 * now.mean():.0f} % | {100 * (damage[chosen] > 0.9).mean():.0f} % |")


if __name__ == "__main__":
    main()
