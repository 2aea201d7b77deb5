#!/usr/bin/python3
"""Draws the pictures of loads.md: the force on a column that is driven through a sheet of ice, its spectrum, and the channel that it leaves.

    docs/guide/loads_figure.py build/release/perimpact             half a minute on one processor; needs numpy and matplotlib
    docs/guide/loads_figure.py build/release/perimpact RESULTS     draws from the results of an earlier run of the same deck
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scripts/results"))
from vtp_reader import read_vtp, series  # noqa: E402

DECK = """\
# A column of 2 m across is driven through a sheet of ice, which is fixed at both sides and at its far end. Plane stress: the ice can be
# crushed, not bent.
title: A column cuts a channel into a sheet of ice
time: {end: 2 s}
bodies:
  ice:
    shape: {box: {size: [12, 8, 0.3]}}
    spacing: 0.1
    plane: stress
    material: {model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.33, density: 900, critical_stretch: 0.003}
    failure: {compression: symmetric}
    particle_sets:
      starboard: {position: [0, -3.85, 0], shape: {box: {size: [12, 0.3, 1]}}}
      port: {position: [0, 3.85, 0], shape: {box: {size: [12, 0.3, 1]}}}
      end: {position: [5.85, 0, 0], shape: {box: {size: [0.3, 7.4, 1]}}}
    boundary_conditions:
      starboard: {fixed: {particle_set: starboard}}
      port: {fixed: {particle_set: port}}
      end: {fixed: {particle_set: end}}
impactors:
  column:
    surface: {cylinder: {diameter: 2, height: 1, axis: z, edge_length: 0.1}}
    mass: 1 kg
    position: [-7.06, 0.02, 0]
    velocity: [4, 0, 0]
    free_dofs: []
contact:
  impactors: {friction: 0.1}
  fragments: {law: none}
output: {folder: results, frames: 40, history_interval: 2 ms}
"""
REMAINS, BROKEN, EDGE = "#b9d3e6", "#3d5a73", "#d1495b"


def statistics(program, results, *options):
    print(subprocess.run([program, "statistics", results, *options], check=True, text=True, capture_output=True).stdout)


def draw_force(results, file):
    rows = np.genfromtxt(results / "history.csv", delimiter=",", names=True, deletechars="")
    windows = np.genfromtxt(results / "windows.csv", delimiter=",", names=True, deletechars="")
    figure, axes = plt.subplots(figsize=(10, 4.2), constrained_layout=True)
    force = -1e-3 * rows[[name for name in rows.dtype.names if name.startswith("column.force_x")][0]]
    mean = -1e-3 * windows[[name for name in windows.dtype.names if name.startswith("column.force_x.mean")][0]]
    time = rows[rows.dtype.names[0]]
    axes.stairs(force[1:], time, color="#9aa7b1", lw=0.6, baseline=None, label="rows of history.csv, 2 ms")
    begin, end = windows[windows.dtype.names[0]], windows[windows.dtype.names[1]]
    axes.stairs(mean, np.append(begin, end[-1]), color=EDGE, lw=2.2, baseline=None, label="means over 0.1 s")
    axes.set(xlabel="time [s]", ylabel="resistance of the ice [kN]", xlim=(0, time[-1]), ylim=(0, None))
    axes.legend(frameon=False)
    figure.savefig(file, dpi=100)


def draw_spectrum(results, file, speed_per_spacing):
    frequency, density = np.loadtxt(results / "spectrum.csv", delimiter=",", skiprows=1).T
    figure, axes = plt.subplots(figsize=(10, 3.6), constrained_layout=True)
    axes.plot(frequency, 1e-6 * density, color=BROKEN, lw=1.3)
    for k in (1, 2, 3, 4, 5):
        axes.axvline(k * speed_per_spacing, color=EDGE, lw=0.9, ls=":", label="multiples of speed/spacing" if k == 1 else None)
    axes.set(xlabel="frequency [Hz]", ylabel="power spectral density [kN²/Hz]", xlim=(0, frequency[-1]), ylim=(0, None))
    axes.legend(frameon=False)
    figure.savefig(file, dpi=100)


def draw_channel(results, file):
    frames = [file for _, file in series(results, "ice")]
    places, fragment = read_vtp(frames[0]).points, read_vtp(frames[-1]).point["fragment"].ravel()
    remains = np.bincount(fragment)[fragment] >= 0.1 * len(fragment)
    columns = np.genfromtxt(results / "fragments/ice_channel_x.csv", delimiter=",", skip_header=1)
    figure, axes = plt.subplots(figsize=(10, 6.2), constrained_layout=True)
    for chosen, colour, label in ((remains, REMAINS, "the sheet that remains"), (~remains, BROKEN, "broken out: floes and single particles")):
        axes.scatter(places[chosen, 0], places[chosen, 1], s=27, marker="s", linewidths=0, color=colour, label=label)
    edges = np.append(columns[:, 0] - 0.05, columns[-1, 0] + 0.05)
    for column, label in ((1, "edges of the channel"), (2, None)):
        axes.stairs(columns[:, column], edges, color=EDGE, lw=1.8, baseline=None, label=label)
    axes.set(xlabel="x of the undeformed sheet [m]", ylabel="y [m]", aspect="equal", xlim=(-6, 6), ylim=(-4, 4))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.1), ncol=3, frameon=False, markerscale=1.6)
    figure.savefig(file, dpi=100)


def main():
    program = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        results = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(folder) / "results"
        if len(sys.argv) < 3:
            (Path(folder) / "deck.yaml").write_text(DECK)
            subprocess.run([program, "run", "deck.yaml"], cwd=folder, check=True)
        statistics(program, results, "--columns", "column.force_x", "--windows", "18", "--from", "0.2", "--segment", "0.52", "--channel", "ice:x", "--channel-to", "0")
        draw_force(results, HERE / "figures/loads_force.png")
        draw_spectrum(results, HERE / "figures/loads_spectrum.png", 4 / 0.1)
        draw_channel(results, HERE / "figures/loads_channel.png")


main()
