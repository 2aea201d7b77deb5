#!/usr/bin/env python3
"""Prints the numbers of README.md from results folders of this case: cases/submarine_surfacing/measure.py FOLDER [more folders] [--update]

With --update they are written into results.csv too, by the name of the folder.

sail, hull      largest downward force of the ice, mean over 0.1 s, and the rise of the submarine at that time; that on the hull as it meets the
                sheet, and later
fragments       connected components of intact bonds at the end
energy          largest energy balance error, also over the energy exchanged (docs/theory/energy.md); work of the submarine on the ice
"""

import csv
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/results"))
from csv_reader import history  # noqa: E402
from interval_means import window_means  # noqa: E402
from results_folder import options, records, report_of, run  # noqa: E402

HERE = Path(__file__).resolve().parent
TABLE = "results.csv"
LAST = 0.3  # [s] at the end, over which the balance is averaged
MEAN = 0.1  # [s] averaging time of forces: contacts of single particles are impulses
MEETS = 4.0  # [m] rise until which the hull meets the sheet: its first peak is before
GRAVITY = 9.81


def ice_on(columns, part=""):
    """Times [s], and means of the force of the ice, downward [N]."""
    middles, means = window_means(columns["time [s]"], columns[f"submarine{part}.force_z [N]"], MEAN)
    return middles, -means


def energy_balance_error(columns):
    """The largest of all rows [J], and relative to the energy exchanged, as in docs/theory/energy.md."""
    works = [name for name in columns if name.endswith((".contact_work [J]", ".work [J]"))]
    largest = abs(columns["total.energy_balance_error [J]"]).max()
    return largest, largest / sum(abs(columns[name]).max() for name in works)


def measure(folder):
    """Numbers of a run by name."""
    columns, report = history(folder), report_of(folder)
    time, height = columns["time [s]"], columns["submarine.position_z [m]"]
    rise = height - height[0]
    found = {}
    for part, (low, high) in {"sail": (0, np.inf), "hull": (0, MEETS), "hull later": (MEETS, np.inf)}.items():
        times, force = ice_on(columns, f".{part.split()[0]}")
        risen = np.interp(times, time, rise)
        force = np.where((risen >= low) & (risen < high), force, -np.inf)
        found |= {f"{part} [N]": force.max(), f"{part}: at a rise of [m]": risen[force.argmax()]}
    ice = report["bodies"]["ice"]
    fragments = ice["fragments"]
    found |= {
        "bonds broken at 1 s [-]": np.interp(1, time, columns["ice.broken_bonds [-]"]) / ice["bonds"],
        "bonds broken [-]": 1 - ice["intact_bonds"] / ice["bonds"],
        "fragments above 1 % [-]": fragments["above_1_percent"],
        "largest fragment [kg]": fragments["largest [kg]"],
        "fragments of two and more particles [-]": fragments["fragments"],
        "single particles [-]": fragments["single_particles"] / ice["particles"],
    }
    found["energy balance error [J]"], found["over the energy exchanged [-]"] = energy_balance_error(columns)
    if "ice.plastic_dissipation [J]" in columns:
        found["plastic dissipation [J]"] = columns["ice.plastic_dissipation [J]"][-1]
    found |= {"work on the ice [J]": -columns["submarine.contact_work [J]"][-1], "steps [-]": report["steps"], "timers [s]": sum(report["timers [s]"].values())}
    return found if np.ptp(columns["submarine.velocity_z [m/s]"]) == 0 else found | equilibrium(columns, report)


def equilibrium(columns, report):
    """Of a submarine free in heave, means over the last 0.3 s: displaced mass, mass, force of the ice as a mass, velocity, damping and deceleration."""
    floating, time = report["impactors"]["submarine"]["floating"], columns["time [s]"]
    last = time > time[-1] - LAST
    mass, setup = floating["mass [kg]"], report["setup"]["impactors"]["submarine"]["floating"]
    velocity = columns["submarine.velocity_z [m/s]"][last]
    displaced, load = columns["submarine.displaced_mass [kg]"][last].mean(), -columns["submarine.force_z [N]"][last].mean() / GRAVITY
    heavy = mass + floating["added_mass [kg]"]
    return {
        "displaced mass [kg]": displaced,
        "mass [kg]": mass,
        "force of the ice as a mass [kg]": load,
        "remainder [kg]": displaced - mass - load,
        "remainder over mass [-]": (displaced - mass - load) / mass,
        "velocity [m/s]": velocity.mean(),
        "damping as a mass [kg]": setup["damping"] * heavy * velocity.mean() / GRAVITY,
        "deceleration as a mass [kg]": -heavy * (velocity[-1] - velocity[0]) / np.ptp(time[last]) / GRAVITY,
        "draft [m]": floating["draft [m]"],
        "draft of the submarine alone [m]": floating["draft_at_rest [m]"],
    }


def update(found):
    """Replaces the rows of these runs in results.csv; `found`: name of the run → numbers of measure()."""
    kept = [row for row in records(HERE, TABLE) if row["run"] not in found] if (HERE / TABLE).exists() else []
    new = [{"run": name, "quantity": quantity, "value": f"{value:.6g}"} for name, numbers in found.items() for quantity, value in numbers.items() if quantity != "timers [s]"]
    with open(HERE / TABLE, "w", newline="", encoding="utf-8") as lines:
        writer = csv.DictWriter(lines, ("run", "quantity", "value"), lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(kept + new, key=lambda row: row["run"]))


def main():
    parser = options(__doc__, nargs="+")
    parser.add_argument("--update", action="store_true", help="write results.csv")
    given = parser.parse_args()
    found = {folder.name: measure(folder) for folder in given.results}
    for folder, numbers in found.items():
        print(folder)
        for name, value in numbers.items():
            print(f"    {name:<42}{value:.6g}")
    if given.update:
        update(found)


if __name__ == "__main__":
    run(main)
