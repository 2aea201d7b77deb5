#!/usr/bin/python3
"""Measures a run that is long enough for a mean: long_run.py RESULTS [--table NAME]

Writes a table beside this script: the mean of F_x on the ship with its standard error (`perimpact statistics`) from first contact to the end and from where the full breadth
of the ship is in the ice, the dominant period, the load peaks of measure.py, the energy balance, and the size of the floes in the window at the end.
"""

import csv
from pathlib import Path

import numpy as np
from measure import begin_of_full_breadth, history, options, records, refuse, report_of, run, times_of_loads, travel_in_ice  # which makes scripts/results importable
from load_statistics import load_statistics

HERE = Path(__file__).resolve().parent


def sizes_of_floes(folder):
    """[m] side of a square of the same area, of the largest floe and of the one that half of the mass of all floes is not smaller than; without single particles and
    the rest of the sheet, the largest fragment; not-a-number where there is no floe."""
    sheet = report_of(folder)["setup"]["bodies"]["sheet"]
    per_area = sheet["material"]["density"] * sheet["shape"]["box"]["size"][2]
    mass = np.sort([float(row["mass [kg]"]) for row in records(folder, "fragments/sheet_end.csv")])[::-1][1:]
    if len(mass) == 0:
        return np.nan, np.nan
    median = mass[np.searchsorted(np.cumsum(mass), 0.5 * mass.sum())]
    return tuple(np.sqrt(np.array([mass[0], median]) / per_area))


def measure(folder):
    """Values of the table by their names."""
    rows = history(folder)
    time, force, way = rows["time [s]"], rows["ship.force_x [N]"], travel_in_ice(rows)
    full_breadth = begin_of_full_breadth(folder)
    if full_breadth is None:
        refuse(f"{folder} ends after {way[-1]:.1f} m, before the bow is in the ice. Continue the run with --resume.")
    numbers = {"travel [m]": way[-1], "end [s]": time[-1]}
    for name, begin in (("whole", time[way > 0][0]), ("full breadth", full_breadth)):
        found, late = load_statistics(folder, "ship.force_x", f"{begin:.2f}"), time >= begin
        peaks = times_of_loads(time[late], force[late])
        numbers |= {
            f"{name}, from [s]": begin,
            f"{name}, mean F_x [N]": float(found["mean"]),
            f"{name}, standard error [N]": float(found["standard_error"]),
            f"{name}, standard error is a lower bound": float(found["standard_error_is_bound"]),
            f"{name}, standard deviation [N]": float(found["standard_deviation"]),
            f"{name}, largest F_x [N]": float(found["maximum"]),
            f"{name}, dominant period [s]": float(found["dominant_period [s]"] or "nan"),
            f"{name}, load peaks": len(peaks),
        }
    largest, median = sizes_of_floes(folder)
    return numbers | {
        "floes, side of the largest [m]": largest,
        "floes, median side by mass [m]": median,
        "contact work [J]": -rows["ship.contact_work [J]"][-1],
        "energy balance error [J]": abs(rows["total.energy_balance_error [J]"]).max(),
        "plastic dissipation [J]": rows["sheet.plastic_dissipation [J]"][-1],
    }


def main():
    arguments = options(__doc__)
    arguments.add_argument("--table", default="window.csv", help="window.csv (default); paper.csv of paper.yaml, paper_layers_4.csv of the same with four layers")
    given = arguments.parse_args()
    numbers = measure(given.results)
    with open(HERE / given.table, "w", newline="", encoding="utf-8") as lines:
        writer = csv.writer(lines, lineterminator="\n")
        writer.writerow(["quantity", "value"])
        writer.writerows([name, f"{value:.6g}"] for name, value in numbers.items())
    for name, value in numbers.items():
        print(f"{name:45s} {value:.6g}")


if __name__ == "__main__":
    run(main)
