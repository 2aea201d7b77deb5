#!/usr/bin/python3
"""What the work of a ship becomes, as contributions to its mean resistance: contributions.py RESULTS [--from TIME] [--to TIME]

The energy balance between two rows of history.csv, divided by the travel between them: each contribution [kN] is the work or the dissipation in a metre of travel.
Together they are the mean of F_x of contact over the travel.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / "../../scripts/results"))
from csv_reader import history  # noqa: E402
from results_folder import options, refuse, run  # noqa: E402

CRUSHING = r".*\.crushing_dissipation"
CONTRIBUTIONS = {  # docs/theory/energy.md; the columns of a body are summed over all bodies; sign: of energy that the ice gains
    "plastic strain of the ice": {r".*\.plastic_dissipation": 1},
    "fracture": {r".*\.fracture_energy": 1},
    "friction between fragments": {r"total\.(friction|dashpot)_dissipation": 1},
    "compaction of fragments": {r"total\.compaction_dissipation": 1},
    "crushing in contact with the hull": {CRUSHING: 1},
    "friction and inelastic contact of the hull": {r"total\.contact_dissipation": 1, CRUSHING: -1},
    "weight and buoyancy": {r".*\.weight_buoyancy_work": -1},
    "water: drag, and motion that damage and contact end": {r".*\.drag_work": -1},
    "waves that leave through absorbing edges": {r".*\.waves_\w+\.work": -1},
    "elastic and kinetic energy of the ice": {r"(?!ship\b).*\.(elastic|kinetic|contact)_energy": 1},
    "energy that leaves with ice behind the window": {r"total\.discarded_energy": 1},
}


def contributions(rows, begin, end):
    """Name → [kN] of the rows from `begin` to `end` [s], the mean of F_x of the ship [kN], and its travel [m]."""
    chosen = [k for k, time in enumerate(rows["time [s]"]) if begin <= time <= end]
    if len(chosen) < 2:
        refuse(f"history.csv has fewer than two rows from {begin:g} to {end:g} s.")
    change = {name.split(" [")[0]: column[chosen[-1]] - column[chosen[0]] for name, column in rows.items()}
    begins, ends = rows["ship.position_x [m]"][[chosen[0], chosen[-1]]]
    if begins == ends:
        refuse(f"the ship does not move from {begin:g} to {end:g} s.")
    travel = abs(ends - begins)

    def sum_of(patterns):
        return sum(sign * value for pattern, sign in patterns.items() for column, value in change.items() if re.fullmatch(pattern, column))

    found = {name: sum_of(patterns) / travel / 1e3 for name, patterns in CONTRIBUTIONS.items()}
    return found, -change["ship.contact_work"] / travel / 1e3, travel


def main():
    arguments = options(__doc__)
    arguments.add_argument("--from", dest="begin", type=float, default=0, help="[s]")
    arguments.add_argument("--to", dest="end", type=float, default=float("inf"), help="[s]")
    given = arguments.parse_args()
    parts, ship, travel = contributions(history(given.results), given.begin, given.end)
    print(f"| work of the ship in {travel:.1f} m of travel, by metre | [kN] | share |\n|---|---|---|")
    for name, value in sorted(parts.items(), key=lambda part: -part[1]):
        print(f"| {name} | {value:.0f} | {100 * value / ship:.0f} % |")
    print(f"| all, and the work of the ship | {sum(parts.values()):.1f}, {ship:.1f} | |")


if __name__ == "__main__":
    run(main)
