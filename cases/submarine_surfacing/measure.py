#!/usr/bin/env python3
"""Prints the numbers of README.md from a results folder of this case: cases/submarine_surfacing/measure.py FOLDER"""

import csv
import json
import sys
from pathlib import Path

import numpy as np

LAST = 0.3  # [s] at the end, over which the balance is averaged
MEAN = 0.1  # [s] averaging time of forces: contacts of single particles are impulses
GRAVITY = 9.81


def history(folder):
    with open(folder / "history.csv", newline="") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, float).T))


def ice_on(columns, part=""):
    """Force of the ice, downward [N], averaged about each row; rows are means already, so impulses are conserved."""
    force = -columns[f"submarine{part}.force_z [N]"]
    rows = max(1, round(MEAN / (columns["time [s]"][2] - columns["time [s]"][1])))
    return np.convolve(force, np.ones(rows), "same") / np.convolve(np.ones_like(force), np.ones(rows), "same")


def energy_balance_error(columns):
    """The largest of all rows [J], and relative to the energy exchanged, as in docs/theory/energy.md."""
    works = [name for name in columns if name.endswith((".contact_work [J]", ".work [J]"))]
    largest = abs(columns["total.energy_balance_error [J]"]).max()
    return largest, largest / sum(abs(columns[name]).max() for name in works)


def main():
    folder = Path(sys.argv[1])
    columns, report = history(folder), json.loads((folder / "run.json").read_text())
    time, height = columns["time [s]"], columns["submarine.position_z [m]"]
    for part in (".sail", ".hull"):
        force = ice_on(columns, part)
        most = force.argmax()
        print(f"{folder.name}: {part[1:]} {force[most] / 1e6:.2f} MN at {time[most]:.2f} s, after a rise of {height[most] - height[0]:.2f} m")
    ice = report["bodies"]["ice"]
    fragments, timers = ice["fragments"], sum(report["timers [s]"].values())
    print(f"{folder.name}: {100 * (1 - ice['intact_bonds'] / ice['bonds']):.1f} % of the bonds broken; {fragments['above_1_percent']} fragments above 1 %, "
          f"{fragments['fragments']} of two and more particles, {100 * fragments['single_particles'] / ice['particles']:.1f} % of the particles single")
    error, share = energy_balance_error(columns)
    print(f"{folder.name}: energy balance error {error:.3g} J at most, {share:.1e} of the energy exchanged; {report['steps']} steps in {timers:.0f} s "
          f"on {report['threads']} thread")
    if columns["submarine.velocity_z [m/s]"].ptp() == 0:
        return
    floating = report["impactors"]["submarine"]["floating"]
    last = time > time[-1] - LAST
    pushed = -columns["submarine.force_z [N]"][last].mean() / GRAVITY
    displaced, mass = columns["submarine.displaced_mass [kg]"][last].mean(), floating["mass [kg]"]
    print(f"{folder.name}, last {LAST} s: displaces {displaced / 1e3:.1f} t; mass {mass / 1e3:.1f} t, the ice pushes like {pushed / 1e3:.1f} t, "
          f"{(displaced - mass - pushed) / 1e3:+.1f} t left over ({100 * (displaced - mass - pushed) / mass:+.2f} %); it rises at "
          f"{columns['submarine.velocity_z [m/s]'][last].mean() * 1e3:.0f} mm/s")
    print(f"{folder.name}: draft at the end {floating['draft [m]']:.3f} m, of the submarine alone {floating['draft_at_rest [m]']:.3f} m")


if __name__ == "__main__":
    main()
