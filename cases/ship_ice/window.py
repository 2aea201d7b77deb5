#!/usr/bin/python3
"""Measures a run of window.yaml: window.py RESULTS

Writes window.csv: the mean of F_x on the ship with its standard error (`perimpact statistics`) from first contact to the end and from where the full breadth
of the ship is in the ice, the dominant period, the load peaks of measure.py, and the energy balance.
"""

import csv
import subprocess
import sys
from pathlib import Path

from measure import bow_length, history, report_of, times_of_loads, travel_in_ice

HERE = Path(__file__).resolve().parent
PERIMPACT = HERE / "../../build/release/perimpact"
TABLE = HERE / "window.csv"


def statistics(folder, begin):
    """The row of statistics.csv of F_x on the ship from then on [s]."""
    subprocess.run([PERIMPACT, "statistics", folder, "--from", f"{begin:.2f}", "--columns", "ship.force_x"], check=True, stdout=subprocess.DEVNULL)
    with open(folder / "statistics.csv", newline="", encoding="utf-8") as lines:
        (row,) = csv.DictReader(lines)
    return row


def measure(folder):
    """The rows of window.csv."""
    rows, hull = history(folder), report_of(folder)["setup"]["impactors"]["ship"]["surface"]["hull"]
    time, force, way = rows["time [s]"], rows["ship.force_x [N]"], travel_in_ice(rows)
    numbers = {"travel [m]": way[-1], "end [s]": time[-1]}
    for name, begin in (("whole", time[way > 0][0]), ("full breadth", time[way > bow_length(hull)][0])):
        found, late = statistics(folder, begin), time >= begin
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
    return numbers | {
        "contact work [J]": -rows["ship.contact_work [J]"][-1],
        "energy balance error [J]": abs(rows["total.energy_balance_error [J]"]).max(),
        "plastic dissipation [J]": rows["sheet.plastic_dissipation [J]"][-1],
    }


def main():
    numbers = measure(Path(sys.argv[1]))
    with open(TABLE, "w", newline="", encoding="utf-8") as lines:
        writer = csv.writer(lines, lineterminator="\n")
        writer.writerow(["quantity", "value"])
        writer.writerows([name, f"{value:.6g}"] for name, value in numbers.items())
    for name, value in numbers.items():
        print(f"{name:45s} {value:.6g}")


if __name__ == "__main__":
    main()
