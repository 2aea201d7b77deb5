#!/usr/bin/python3
"""Loads and fragments of ship runs: measure.py RESULTS ...

A line for each results folder. Loads are of contact on the part `bow`: the largest row of F_x within the first metres (SETTLED), the response
to the first impact; mean and largest mean over a second after these metres; F_z/F_x; the number of load peaks, and the time between them. The mean over
all the travel is that of the whole hull: its work over the length. Then the travel in the ice; the breadth of the waterline in the ice at the end of it, and
its mean over the travel; broken bonds; through-cracks (below); fragments of at least 1 % of the sheet's mass besides the remaining sheet;
work of the ship, and the energy balance error over it. Broken bonds are a share of those of all ice that was in a window that moves; cracks and
fragments are those in the window at the end.

Through-cracks: along lines in the direction of travel, one for each row of particles within the breadth of the ship, the cracked stretches of the sheet
are counted at the end. A position is cracked where the damage of every layer is above CRACKED. The number is the median over the lines.

A load peak begins where the mean of F_x over a second exceeds the overall mean, after it had been below half of that; the period is the mean time from
one to the next.
"""

import functools
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent / "../../scripts/results"))
from csv_reader import history  # noqa: E402
from interval_means import mean, window_means  # noqa: E402
from results_folder import options, records, refuse, report_of, run  # noqa: E402
from vtp_reader import read_vtp, series  # noqa: E402

SETTLED = 4.6  # [m] of travel after the first contact
CRACKED = 0.35  # [-] damage; adjacent to a plane crack it is 0.4 to 0.5


def times_of_loads(time, force):
    """[s] times of load peaks: the middle of the first second whose mean exceeds the overall mean, each time after one below half of it."""
    overall, times, is_loaded = mean(time, force), [], False
    for at, now in zip(*window_means(time, force, 1.0)):
        if not is_loaded and now > overall:
            times.append(at)
        is_loaded = now > overall or (is_loaded and now >= overall / 2)
    return np.array(times)


def through_cracks(reference, damage, breadth):
    """The cracked stretches that lines along the sheet cross, their median over the lines within the breadth [m] of the ship. Of all particles: `reference`
    positions [m], `damage`."""
    heights = np.unique(np.round(reference[:, 2], 3))
    spacing = heights[1] - heights[0]
    column = np.round((reference - reference.min(axis=0)) / spacing).astype(int)[:, :2]
    least = np.full(column.max(axis=0) + 1, 1.0)
    np.minimum.at(least, tuple(column.T), damage)
    across = reference[:, 1].min() + spacing * np.arange(least.shape[1])
    cracked = np.pad((least[:, np.abs(across) < breadth / 2] > CRACKED).astype(int), ((1, 0), (0, 0)))
    return int(np.median((np.diff(cracked, axis=0) == 1).sum(axis=0)))


def travel_in_ice(rows):
    """[m] of the ship since first contact of its bow, by row; negative before it."""
    position, contacts = rows["ship.position_x [m]"], np.flatnonzero(rows["ship.bow.force_x [N]"])
    if len(contacts) == 0:
        refuse(f"{rows.owner}: the bow is never in contact with the ice; continue the run with --resume.")
    return position[contacts[0]] - position


def curve_of_bow(hull):
    """(length [m], half-breadth [m] that far behind its beginning) of the curve of the bow's waterline: y = B/2 (1 - (1 - t)^p), t over p B/2 / tan α (docs/guide/shapes.md)."""
    half, fullness = hull["breadth"] / 2, hull["fullness"]
    length = fullness * half / np.tan(hull["waterline_angle"])
    return length, lambda behind: half * (1 - (1 - np.clip(np.asarray(behind) / length, 0, 1)) ** fullness)


def arc_of_stem(hull):
    """(distance [m] from the beginning of that curve to the stem, distance [m] from the stem to the end of its arc); 0, 0 of a sharp stem."""
    radius = hull.get("stem_radius") or 0
    if radius == 0:
        return 0.0, 0.0
    length, half_breadth = curve_of_bow(hull)
    places = np.linspace(0, length, 200_001)
    widths = half_breadth(places)
    slopes = np.gradient(widths, places)
    tangent = np.argmax(widths * np.hypot(1, slopes) >= radius)  # where the normal of the curve meets the centreline at the distance of the radius
    ahead = places[tangent] + widths[tangent] * slopes[tangent] - radius
    return ahead, places[tangent] - ahead


def bow_length(hull):
    """[m] from the stem to the full breadth, of a hull as in run.json."""
    return curve_of_bow(hull)[0] - arc_of_stem(hull)[0]


def begin_of_full_breadth(folder):
    """[s] from which the full breadth of the ship is in the ice; None if the run ends before."""
    rows, hull = history(folder), report_of(folder)["setup"]["impactors"]["ship"]["surface"]["hull"]
    with_full_breadth = rows["time [s]"][travel_in_ice(rows) > bow_length(hull)]
    return with_full_breadth[0] if with_full_breadth.size else None


def breadth_of_waterline(hull, behind):
    """[m] that far behind the stem [m]; 0 ahead of it."""
    behind, (ahead, arc), radius = np.asarray(behind, dtype=float), arc_of_stem(hull), hull.get("stem_radius") or 0
    on_arc = np.sqrt(np.clip(behind * (2 * radius - behind), 0, None))
    return 2 * np.where(behind <= 0, 0, np.where(behind < arc, on_arc, curve_of_bow(hull)[1](behind + ahead)))


def breadth_in_ice(hull, travel):
    """[m] of the waterline, that far behind the stem, and its mean in front of there."""
    places = np.linspace(0, travel, 20_001)
    return float(breadth_of_waterline(hull, travel)), float(np.trapz(breadth_of_waterline(hull, places), places) / travel)


@functools.cache  # tables and figures use the same runs
def measure(folder):
    rows, report = history(folder), report_of(folder)
    time, along, up = rows["time [s]"], rows["ship.bow.force_x [N]"], rows["ship.bow.force_z [N]"]
    way = travel_in_ice(rows)
    first, travel, late = time[way >= 0][0], way[-1], way > SETTLED
    work = -rows["ship.contact_work [J]"][-1]
    loads = times_of_loads(time[time >= first], along[time >= first])
    sheet = read_vtp(series(folder, "sheet")[-1][1])
    body = report["setup"]["bodies"]["sheet"]
    moved = abs(rows["sheet.window_travel [m]"][-1]) if "sheet.window_travel [m]" in rows else 0.0
    met = 1 + moved / body["shape"]["box"]["size"][0]  # ice of the whole track over that of the window
    hull = report["setup"]["impactors"]["ship"]["surface"]["hull"]
    breadth = hull["breadth"]
    fragments = records(folder, "fragments/sheet.csv")[-1]
    _, seconds = window_means(time[late], along[late], 1.0) if late.any() else ((), ())
    return {
        "travel": travel,
        "breadth": breadth_in_ice(hull, travel),
        "first peak": along[~late].max(),
        "mean of all": work / travel,
        "mean": mean(time[late], along[late]) if late.sum() > 1 else np.nan,
        "largest 1 s": max(seconds, default=np.nan),
        "loads": len(loads),
        "period": np.diff(loads).mean() if len(loads) > 1 else np.nan,
        "ratio": mean(time, up) / mean(time, along),
        "broken": rows["sheet.broken_bonds [-]"][-1] / (met * report["bodies"]["sheet"]["bonds"]),
        "cracks": through_cracks(sheet.points - sheet.point["displacement"], sheet.point["damage"], breadth),
        "large fragments": int(fragments["above_1_percent [-]"]) - 1,
        "where": " in the window" if moved else "",
        "work": work,
        "closing": np.abs(rows["total.energy_balance_error [J]"]).max() / work,
    }


def loads_of(m):
    """Their number, and the mean period if there is more than one."""
    return f"{m['loads']:d}" + (f", every {m['period']:.1f} s" if m["loads"] > 1 else "")


def show(folder):
    m = measure(folder)
    print(
        f"{Path(folder).name:24s} {m['travel']:5.1f} m  breadth {m['breadth'][0]:4.1f}, mean {m['breadth'][1]:4.1f} m  peak {m['first peak'] / 1e6:5.2f} MN  mean {m['mean of all'] / 1e3:5.0f} kN, late {m['mean'] / 1e3:5.0f} kN  1 s {m['largest 1 s'] / 1e3:5.0f} kN"
        f"  loads {loads_of(m)}"
        f"  F_z/F_x {m['ratio']:.4f}  broken {100 * m['broken']:4.1f} %  cracks {m['cracks']:d}  fragments {m['large fragments']:d}{m['where']}  work {m['work'] / 1e6:.2f} MJ  closing {m['closing']:.0e}"
    )


def main():
    for folder in options(__doc__, nargs="+").parse_args().results:
        show(folder)


if __name__ == "__main__":
    run(main)
