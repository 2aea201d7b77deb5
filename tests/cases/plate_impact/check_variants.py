"""Runs of the plate that differ in one thing, compared with each other.

    check_variants.py CLAIM EXPECTED FOLDER [FOLDER ...]     # results of runs in folders named as below
"""

import csv
import re
import sys
from pathlib import Path

from history import History

RADIUS = 0.025  # [m] of the cylinder
QUANTITIES = ("centre", "cylinder")


def displacement(history, name):
    """Of the plate's centre, or of the cylinder, at the end [m]."""
    end = history.time[-1]
    return history.at("centre.displacement_y", end) if name == "centre" else history.moved("cylinder.position_y", end)


def runs_in(folders):
    return {Path(folder).name: History(folder) for folder in folders}


def panel_of(name):
    """panel_0.5mm → 0.0005 [m]"""
    return float(re.fullmatch(r"panel_([0-9.]+)mm", name)[1]) * 1e-3


def expect(is_true, text):
    print(f"{'    ' if is_true else 'BAD '}{text}")
    return is_true


def meshed_is_analytic(runs, _):
    """Vertices lie on the circle, so that the mesh lies up to its sagitta Δ²/(8R) within it: the cylinder comes that much later, and what
    follows in the plate is moved by a small multiple of it."""
    analytic = runs.pop("analytic")
    ok = []
    for run, history in runs.items():
        bound = 3 * panel_of(run) ** 2 / (8 * RADIUS)
        for name in QUANTITIES:
            away = abs(displacement(history, name) - displacement(analytic, name))
            ok.append(expect(away <= bound, f"{run}: {name} is {away:.3g} m from the analytic one, at most {bound:.3g} m is allowed"))
    return ok


def panels_do_not_matter(runs, _):
    """The seed paper's claim of section 5: 2 mm to 0.1 mm give the same within 1 %."""
    ok = []
    for name in QUANTITIES:
        values = {run: displacement(history, name) for run, history in runs.items()}
        spread = (max(values.values()) - min(values.values())) / min(map(abs, values.values()))
        ok.append(expect(len(runs) > 1 and spread < 0.01, f"{name}: {values} m differ by {100 * spread:.3g} %"))
    return ok


def region_adds_no_spike(runs, _):
    """The region is exactly as wide as the cylinder. Particles that came in through its side, already beyond the surface, once gave 24 MN."""
    force = {run: history.largest_mean("cylinder.force_y", history.interval()) for run, history in runs.items()}
    without = force.pop("no_region")
    (region,) = force.values()
    # Not to the bit: the deck's region is thinner than the cylinder, and bulging particles at z = ±5 mm may leave it.
    return [expect(without > 1e5 and abs(region - without) <= 1e-3 * without, f"largest force {region:.6g} N with the region, {without:.6g} N without")]


def published_is_off(runs, expected):
    """The discretisation of the seed paper is too soft: no surface correction, no lattice normalisation, whole volumes at the horizon's edge.
    Measured: -9.2 % and 7.7 %. A run within the 3 % is not of that discretisation, one beyond 10 % has something else wrong."""
    with open(expected, newline="") as file:
        rows = {row["quantity"]: float(row["value"]) for row in csv.DictReader(file)}
    ok = []
    for name in QUANTITIES:
        wanted = rows[f"{name}.displacement_y at 200 us"]
        off = displacement(runs["published"], name) / wanted - 1
        ok.append(expect(0.03 <= abs(off) <= 0.10, f"{name}: {100 * off:.2f} % from the reference"))
    return ok


CLAIMS = {function.__name__: function for function in (meshed_is_analytic, panels_do_not_matter, region_adds_no_spike, published_is_off)}

claim, expected, *folders = sys.argv[1:]
sys.exit(0 if all(CLAIMS[claim](runs_in(folders), expected)) else 1)
