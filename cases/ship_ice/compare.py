#!/usr/bin/python3
"""Runs of variants.sh against resistance formulas: compare.py RESULTS [RUN ...]

RESULTS: folder that variants.sh filled; RUN: folders of other runs, for the table alone. Prints a table, and draws figures/sweeps.png: mean resistance over all the travel against speed, thickness and
strength of the ice, with the results of resistance.py without friction; and the runs among Lindqvist's h-v curves. Strength and thickness are those of run.json.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import loads_of, measure  # noqa: E402
from resistance import ShipInIce, iso_19906, lindqvist, riska  # noqa: E402

HERE = Path(__file__).resolve().parent
SWEEPS = (  # field of ShipInIce, its axis, how a value is shown, the runs that vary it
    ("speed", "speed [m/s]", 1, ("deck", "speed_4.5", "speed_6")),
    ("thickness", "thickness of the ice [m]", 1, ("thickness_1.5", "deck", "thickness_2.5", "thickness_3")),
    ("strength", "flexural strength [MPa]", 1e6, ("stretch_2e-4", "deck", "stretch_5e-4")),
)
FORMULAS = (
    ("Lindqvist, crushing and bending", "#b3312c", lambda ship: lindqvist(ship)["crushing"] + lindqvist(ship)["bending"]),
    ("Lindqvist, whole", "#e8a15a", lambda ship: lindqvist(ship)["total"]),
    ("Riska", "#7d7d7d", lambda ship: riska(ship)["total"]),
    ("ISO 19906, breaking", "#4d8f5b", lambda ship: iso_19906(ship)["breaking"]),
)


def ship_of(folder):
    """The ship and the ice of a run, as input of the formulas."""
    report = json.loads((Path(folder) / "run.json").read_text())
    setup = report["setup"]
    return ShipInIce(
        speed=abs(setup["impactors"]["ship"]["velocity"][0]),
        thickness=setup["bodies"]["sheet"]["shape"]["box"]["size"][2],
        strength=report["bodies"]["sheet"]["failure"]["flexural_strength [Pa]"],
        friction=setup["contact"]["impactors"]["friction"],
    )


def finished(folder):
    file = Path(folder) / "run.json"
    return file.exists() and json.loads(file.read_text())["outcome"] == "finished"


def table(folders):
    print("| run | V [m/s] | H [m] | σ_f [MPa] | first peak [MN] | mean [kN] | largest 1 s [kN] | load peaks | through-cracks | R_c + R_b | R (Lindqvist) | Riska | H_B |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    for folder in folders:
        ship, run = ship_of(folder), measure(folder)
        formulas = " | ".join(f"{force(ship) / 1e3:.0f}" for _, _, force in FORMULAS)
        print(f"| {folder.name} | {ship.speed:.2f} | {ship.thickness:g} | {ship.strength / 1e6:.2f} | {run['first peak'] / 1e6:.2f} | {run['mean of all'] / 1e3:.0f}"
              f" | {run['largest 1 s'] / 1e3:.0f} | {loads_of(run)} | {run['cracks']} | {formulas} |")


def draw_sweep(axis, folder, field, unit, names):
    base = ship_of(folder / "deck")
    runs = [(getattr(ship_of(folder / name), field), measure(folder / name)["mean of all"]) for name in names]
    values = np.array(sorted(runs))
    line = np.linspace(0.8 * values[:, 0].min(), 1.1 * values[:, 0].max(), 60)
    for name, colour, force in FORMULAS:
        axis.plot(line / unit, [force(replace(base, **{field: value})) / 1e6 for value in line], color=colour, label=name)
    axis.plot(values[:, 0] / unit, values[:, 1] / 1e6, "o-", color="#20506e", linewidth=2, label="runs, mean over 20 m")
    axis.set_ylim(0, 5.5)


def draw_h_v(axis, folder, names):
    """Thickness in which a net thrust sustains a speed, by Lindqvist's breaking terms; a run is a point labelled with its mean."""
    base = ship_of(folder / "deck")
    speeds, heights = np.linspace(0.3, 3.6, 40), np.linspace(1, 3.4, 40)

    def breaking(speed, height):
        ship = replace(base, speed=speed, thickness=height)
        parts = lindqvist(ship)
        return (parts["crushing"] + parts["bending"]) * (1 + 1.4 * speed / np.sqrt(9.81 * height)) / 1e6

    lines = axis.contour(speeds, heights, [[breaking(v, h) for v in speeds] for h in heights], levels=(0.5, 1, 1.5, 2, 3, 4), colors="#b3312c", linewidths=1)
    axis.clabel(lines, fmt="%g MN", fontsize=8)
    for name in names:
        ship, mean = ship_of(folder / name), measure(folder / name)["mean of all"]
        axis.plot(ship.speed, ship.thickness, "o", color="#20506e")
        axis.annotate(f"{mean / 1e6:.2f} MN", (ship.speed, ship.thickness), xytext=(6, 4), textcoords="offset points", fontsize=9, color="#20506e")
    axis.set_ylabel("thickness of the ice [m]")


def draw(folder, file):
    figure, axes = plt.subplots(2, 2, figsize=(11, 8.6))
    for axis, (field, label, unit, names) in zip(axes.flat, SWEEPS):
        draw_sweep(axis, folder, field, unit, [name for name in names if finished(folder / name)])
        axis.set_xlabel(label)
        axis.set_ylabel("resistance without friction [MN]")
    at_one_strength = dict.fromkeys(name for field, *_, names in SWEEPS for name in names if field != "strength" and finished(folder / name))
    draw_h_v(axes[1, 1], folder, at_one_strength)
    axes[1, 1].set_xlabel(SWEEPS[0][1])
    axes[1, 1].set_title("h-v: lines, Lindqvist's crushing and bending with speed", fontsize=10)
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="upper center", ncol=3, fontsize=9, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.94))
    figure.savefig(file, dpi=85)


def main():
    folder, *others = (Path(name) for name in sys.argv[1:])
    order = dict.fromkeys([name for *_, names in SWEEPS for name in names] + ["friction_0.1", "panels_uniform_3", "hardening_0.2", "six_layers"])
    table([folder / name for name in order if finished(folder / name)] + others)
    draw(folder, HERE / "figures" / "sweeps.png")


if __name__ == "__main__":
    main()
