#!/usr/bin/env python3
"""Draws the figures of this case from its two results folders, that of the given speed and that of the free rise:

    cases/submarine_surfacing/figures.py results/submarine_surfacing results/submarine_surfacing_free

writes figures/surfacing.png, figures/forces.png and figures/equilibrium.png beside this script, and prints the numbers of README.md.
"""

import csv
import json
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/pictures"))
from render import Scene  # noqa: E402
from vtp_reader import read_vtp  # noqa: E402

INSTANTS = 0.6, 2.4, 4.4, 10.0  # [s] of the free rise: the sail bends the ice, stands in it, the hull lifts it, at rest
CROWN, SAIL_TOP, KEEL = 4.0, 7.0, -4.0  # [m] over the axis
MEAN = 0.1  # [s] that forces are averaged over: each push of a particle is a single blow
GRAVITY = 9.81
COLOURS = LinearSegmentedColormap.from_list("damage", ["#eaf3fa", "#a9cbe3", "#e8a15a", "#b3312c"])
RED, BLUE, GREY = "#b3312c", "#2f6f9f", "0.45"

plt.rcParams.update({"font.size": 12, "axes.spines.top": False, "axes.spines.right": False})


def history(folder):
    with open(folder / "history.csv", newline="") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, float).T))


def averaged(columns, name):
    """Mean over MEAN seconds about each row; rows are means already, so impulses stay."""
    rows = max(1, round(MEAN / (columns["time [s]"][2] - columns["time [s]"][1])))
    return np.convolve(columns[name], np.ones(rows) / rows, "same")


def frame(folder, name, time):
    """The picture nearest to that time."""
    series = xml.parse(folder / "frames" / f"{name}.pvd").getroot().iter("DataSet")
    nearest = min(series, key=lambda entry: abs(float(entry.get("timestep")) - time))
    return read_vtp(folder / "frames" / nearest.get("file")), float(nearest.get("timestep"))


def picture(folder, time, spacing, fold=2):
    ice, at = frame(folder, "ice", time)
    boat, _ = frame(folder, "submarine", time)
    scene = Scene(direction=(0.75, -0.95, 0.75), up=(0, 0, 1), pixels_per_metre=9.4 * fold, width=640 * fold, height=430 * fold, centre=(1, 0, 0.2))
    scene.add_panels(boat.points, boat.panels, colour=(0.36, 0.40, 0.44), edge_colour=(0.30, 0.33, 0.37), edge_width=0.03)
    scene.add_balls(ice.points, 0.62 * spacing, COLOURS(np.clip(ice.point["damage"], 0, 1))[:, :3])
    return scene.picture(fold), at


def draw_surfacing(folder, spacing):
    figure, axes = plt.subplots(2, 2, figsize=(12, 8.2), layout="constrained")
    for axis, time in zip(axes.flat, INSTANTS):
        image, at = picture(folder, time, spacing)
        axis.imshow(image, interpolation="none")
        axis.set_title(f"{at:.1f} s", loc="left", fontsize=13)
        axis.axis("off")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), COLOURS)
    figure.colorbar(scale, ax=axes, shrink=0.35, aspect=14, label="damage of particles")
    figure.savefig(CASE / "figures/surfacing.png", dpi=90)
    plt.close(figure)


def draw_forces(given):
    """Over the height of the boat, which is time times its speed."""
    height = given["submarine.position_z [m]"] - given["submarine.position_z [m]"][0]
    figure, axis = plt.subplots(figsize=(10.5, 4.6), layout="constrained")
    for part, colour in (("sail", BLUE), ("hull", RED)):
        axis.plot(height, -averaged(given, f"submarine.{part}.force_z [N]") / 1e6, color=colour, lw=2, label=f"on the {part}")
    axis.plot(height, given["submarine.water_force_z [N]"] / 1e6, color=GREY, lw=1.5, ls="--", label="net lift of the water")
    axis.axhline(0, color="0.8", lw=0.8)
    axis.set(xlabel="rise [m]", ylabel="vertical force [MN]", title="Ice on the submarine, downward, at a given speed", ylim=(-3, None))
    axis.legend(frameon=False)
    figure.savefig(CASE / "figures/forces.png", dpi=95)
    plt.close(figure)


def draw_equilibrium(free, mass):
    time = free["time [s]"]
    carried = -averaged(free, "submarine.force_z [N]") / GRAVITY
    figure, axis = plt.subplots(figsize=(10.5, 4.6), layout="constrained")
    inside = time < time[-1] - MEAN / 2
    axis.plot(time, free["submarine.displaced_mass [kg]"] / 1e3, color=BLUE, lw=2.2, label="water displaced")
    axis.plot(time[inside], (mass + carried[inside]) / 1e3, color=RED, lw=1.6, label="mass and the push of the ice")
    axis.axhline(mass / 1e3, color=GREY, lw=1, ls="--", label="mass")
    axis.set(xlabel="time [s]", ylabel="mass [t]", title="Rising by its own buoyancy until it carries itself and the ice on it")
    axis.legend(frameon=False)
    figure.savefig(CASE / "figures/equilibrium.png", dpi=95)
    plt.close(figure)


def main():
    folders = [Path(argument) for argument in sys.argv[1:3]]
    given, free = map(history, folders)
    reports = [json.loads((folder / "run.json").read_text()) for folder in folders]
    floating = reports[1]["impactors"]["submarine"]["floating"]
    (CASE / "figures").mkdir(exist_ok=True)
    draw_forces(given)
    draw_equilibrium(free, floating["mass [kg]"])
    draw_surfacing(folders[1], reports[1]["setup"]["bodies"]["ice"]["spacing"])

    rise = given["submarine.position_z [m]"] - given["submarine.position_z [m]"][0]
    for part in ("sail", "hull"):
        force = -averaged(given, f"submarine.{part}.force_z [N]")
        print(f"given speed: {part} {force.max() / 1e6:.2f} MN at a rise of {rise[force.argmax()]:.2f} m")
    for name, columns, report in zip(("given speed", "free"), (given, free), reports):
        share = columns["ice.broken_bonds [-]"][-1] / report["bodies"]["ice"]["bonds"]
        print(f"{name}: {100 * share:.1f} % of the bonds broken, {report['wall [s]']:.0f} s on {report['threads']} thread, {report['steps']} steps")
    for part in ("sail", "hull"):
        force = -averaged(free, f"submarine.{part}.force_z [N]")
        print(f"free: {part} {force.max() / 1e6:.2f} MN at {free['time [s]'][force.argmax()]:.2f} s")
    last = free["time [s]"] > free["time [s]"][-1] - 1
    carried = -free["submarine.force_z [N]"][last].mean() / GRAVITY
    displaced = free["submarine.displaced_mass [kg]"][last].mean()
    print(f"free, last second: displaces {displaced / 1e3:.1f} t, mass {floating['mass [kg]'] / 1e3:.1f} t, ice pushes with {carried / 1e3:.1f} t, left over "
          f"{(displaced - floating['mass [kg]'] - carried) / 1e3:.1f} t; rises at {free['submarine.velocity_z [m/s]'][last].mean() * 1e3:.0f} mm/s")
    print(f"draught {floating['draught [m]']:.3f} m, of the boat alone {floating['draught_at_rest [m]']:.3f} m")


main()
