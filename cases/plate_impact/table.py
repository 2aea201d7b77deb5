#!/usr/bin/python3
"""Writes the tables of README.md from the results of variants.sh.

    /usr/bin/python3 table.py [RESULTS]          default: results/plate_impact

Prints every number that lies outside its tolerance of expected.csv. Needs numpy.
"""

import csv
import re
from pathlib import Path

import numpy as np
from results import history as history_of  # which makes scripts/results importable
from page_table import write_table
from results_folder import options, report_of, run

HERE = Path(__file__).resolve().parent
RADIUS = 25e-3  # [m] of the cylinder

# folder of the results: its name in the README
PANELS = {f"panel_{size}mm": f"panels of {size} mm" for size in ("2", "1.5", "1", "0.5", "0.1")}
VARIANTS = PANELS | {
    "analytic": "`analytic`: no panels",
    "region_none": "no contact bounds",
    "radius_0": "`radius_ratio: 0`",
    "correction_volume": "`surface_correction: volume`",
    "correction_none": "`surface_correction: none`",
    "published_lattice": "`published: true`",
    "published_repaired": "`detector: published`",
    "published_letter": "`detector: published`, `variant: literal`",
}
DETECTION = {"panel_2mm": "`swept`, triangles of 2 mm", "analytic": "`analytic`", "published_repaired": "`published`, quads of 2 mm",
             "published_letter": "`published`, `variant: literal`, quads of 2 mm"}  # fmt: skip


def at(history, column, time):
    return float(np.interp(time, history["time [s]"], history[column]))


def end_of_contact(history):
    felt = np.flatnonzero(history["cylinder.force_y [N]"])
    return history["time [s]"][felt[-1]] if len(felt) else float("nan")


def drift(history):
    momentum = history["total.momentum_y [kg m/s]"]
    return float(momentum[np.argmax(np.abs(momentum - momentum[0]))])


# quantity of expected.csv: (heading, its unit in the table, how to compute it from a history)
QUANTITIES = {
    "centre.displacement_y at 200 us": ("centre [mm]", 1e-3, lambda h: at(h, "centre.displacement_y [m]", 200e-6)),
    "cylinder.displacement_y at 200 us": ("cylinder [mm]", 1e-3, lambda h: at(h, "cylinder.position_y [m]", 200e-6) - h["cylinder.position_y [m]"][0]),
    "cylinder.velocity_y at 50 us": ("v at 50 µs [m/s]", 1, lambda h: at(h, "cylinder.velocity_y [m/s]", 50e-6)),
    "cylinder.velocity_y at 200 us": ("v at 200 µs [m/s]", 1, lambda h: at(h, "cylinder.velocity_y [m/s]", 200e-6)),
    "cylinder.force_y largest mean over 1 us": ("largest force [MN]", 1e6, lambda h: h["cylinder.force_y [N]"].max()),
    "end of contact": ("end of contact [µs]", 1e-6, end_of_contact),
}
MOMENTUM = "total.momentum_y at all times"


class Expected:
    """A row of expected.csv."""

    def __init__(self, row):
        self.value = float(row["value"])
        self.is_relative = row["relative_or_absolute"] == "relative"
        self.given = float(row["tolerance"])
        self.tolerance = self.given * (abs(self.value) if self.is_relative else 1)

    def holds(self, value):
        return abs(value - self.value) <= self.tolerance


def read_expected():
    with open(HERE / "expected.csv", newline="") as file:
        return {row["quantity"]: Expected(row) for row in csv.DictReader(file)}


def digits(unit):
    return 0 if unit == 1e-6 else 3


def in_table(value, unit):
    return "–" if np.isnan(value) else f"{value / unit:.{digits(unit)}f}".replace("-", "−")


def main_table(histories, expected):
    lines = ["| variant | " + " | ".join(heading for heading, _, _ in QUANTITIES.values()) + " |", "|---" * (len(QUANTITIES) + 1) + "|"]

    def allowed(quantity, unit):
        row = expected[quantity]
        return f"{in_table(row.value, unit)} ± " + (f"{100 * row.given:g} %" if row.is_relative else f"{row.given / unit:g}")

    lines.append("| **finite elements, with tolerance** | " + " | ".join(allowed(quantity, unit) for quantity, (_, unit, _) in QUANTITIES.items()) + " |")
    for name, history in histories.items():
        cells = []
        for quantity, (_, unit, of) in QUANTITIES.items():
            value = of(history)
            holds = expected[quantity].holds(value)
            if not holds:
                print(f"{name}: {quantity} is {value:.6g}, expected {expected[quantity].value:g} ± {expected[quantity].tolerance:.3g}")
            cells.append(in_table(value, unit) + ("" if holds else " ✗"))
        lines.append(f"| {VARIANTS[name]} | " + " | ".join(cells) + " |")
    largest = max(abs(drift(history) / history["total.momentum_y [kg m/s]"][0] - 1) for history in histories.values())
    if largest > expected[MOMENTUM].given:
        print(f"{MOMENTUM}: it changes by {largest:.1e} of itself")
    lines += ["", f"✗: outside the tolerance. Momentum: in all variants constant to {largest:.1e} of −50.24 kg m/s (allowed: {expected[MOMENTUM].given:g})."]
    return lines


def panel_table(histories):
    lines = ["| Δ_m [mm] | centre, minus analytic [µm] | cylinder, minus analytic [µm] | 3 Δ_m²/(8 R) [µm] |", "|---|---|---|---|"]
    quantities = [QUANTITIES[name][2] for name in ("centre.displacement_y at 200 us", "cylinder.displacement_y at 200 us")]
    for name in PANELS:
        size = 1e-3 * float(re.search(r"[0-9.]+", name)[0])
        bound = 3 * size**2 / (8 * RADIUS)
        apart = [of(histories[name]) - of(histories["analytic"]) for of in quantities]
        if max(np.abs(apart)) > bound:
            print(f"{name}: {apart} m from analytic is more than {bound:.3g} m")
        lines.append(f"| {1e3 * size:g} | " + " | ".join(f"{1e6 * a:+.2f}".replace("-", "−") for a in apart) + f" | {1e6 * bound:.2f} |")
    return lines


def detection_table(results):
    lines = ["| detector | particle-steps in the contact bounds | tested | pairs of particle and panel |", "|---|---|---|---|"]
    for name, called in DETECTION.items():
        effort = report_of(results / name)["impactors"]["cylinder"]["detection"]["plate"]
        counts = [effort[key] for key in ("points_in_bounds", "points_tested", "panels_tested")]
        lines.append(f"| {called} | " + " | ".join(f"{count:,}".replace(",", " ") for count in counts) + " |")
    return lines


def main():
    results = options(__doc__, nargs="?", default=Path("results/plate_impact")).parse_args().results
    histories = {name: history_of(results / name) for name in VARIANTS}
    page = HERE / "README.md"
    text = page.read_text()
    text = write_table(text, "variants", main_table(histories, read_expected()))
    text = write_table(text, "panels", panel_table(histories))
    text = write_table(text, "detection", detection_table(results))
    page.write_text(text)
    print(f"wrote the tables of {page}")


if __name__ == "__main__":
    run(main)
