#!/usr/bin/python3
"""Results of a run of this case: forces, fragments, particles inside a blade, momentum, cost of contact.

    cases/propeller_ice/measure.py results/propeller_ice [more folders]      prints a block for each

thrust, torque   of the whole propeller, along and about +x. The peak is the mean over the millisecond in which its magnitude is largest, the mean that
                 over the time in which the thrust's impulse grows from 5 % to 95 %. Spindle torque: about a blade's own radial axis.
fragments           connected components of intact bonds at the end, as in run.json and fragments/ice_end.csv
inside           particles inside, over all frames, by winding number: along a ray in +x from each particle, the panels through which the ray
                 leaves, less those through which it enters, give the number of overlapping parts that contain it. The nearest is the
                 smallest distance of any particle from any triangle. Independent of the program: only the positions of particles and
                 panels are read from the frames.
drift            largest change of the total linear momentum over the initial momentum of the ice (for a free propeller)
energy           largest energy balance error, plastic dissipation, and that of crushing in contact, all over the initial kinetic energy of the ice
"""

import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from csv_reader import history  # noqa: E402
from interval_means import impulses, window_means  # noqa: E402
from results_folder import options, records, refuse, report_of, run  # noqa: E402
from vtp_reader import pictures  # noqa: E402

WINDOW = 1e-3  # [s] of the peaks
BLADES = 1, 2, 3, 4


# ---- forces


def forces(column):
    times = column["time [s]"]
    thrust = impulses(times, column["propeller.shaft.force_x [N]"])
    if thrust[-1] == 0:
        refuse(f"{column.owner}: the ice is never in contact with the propeller.")
    duration = np.diff(np.interp([0.05, 0.95], thrust / thrust[-1], times))[0]
    found = {"thrust: impulse [N s]": thrust[-1], "thrust: duration [s]": duration}
    named = {"thrust": "shaft.force_x [N]", "torque": "shaft.torque [N m]"}
    named |= {f"spindle torque {blade}": f"blade_{blade}.torque [N m]" for blade in BLADES}
    for name, what in named.items():
        _, means = window_means(times, column[f"propeller.{what}"], WINDOW, is_zero_before=True)
        found[f"{name}: peak {what[what.index('['):]}"] = means[np.argmax(np.abs(means))]
        if name in ("thrust", "torque"):
            found[f"{name}: mean {what[what.index('['):]}"] = 0.9 * impulses(times, column[f"propeller.{what}"])[-1] / duration
    return found


# ---- fragments


def fragments(folder, report):
    body = report["bodies"]["ice"]
    mass, fragments = body["mass [kg]"], body["fragments"]
    shares = [float(row["mass [kg]"]) / mass for row in records(folder, "fragments/ice_end.csv")]
    return {
        "fragments above 1 % of the mass [-]": fragments["above_1_percent"],
        "largest fragment [-]": fragments["largest [kg]"] / mass,
        "second [-]": fragments["second_largest [kg]"] / mass,
        "in fragments below 1 % [-]": 1 - sum(share for share in shares if share > 0.01),
        "broken bonds [-]": 1 - body["intact_bonds"] / body["bonds"],
    }


# ---- particles inside


def rotated_back(points, origin, here):
    """`points` moved as the rigid motion that takes the vertices `here` to `origin` (Kabsch, Acta Cryst. A 32 (1976) 922)."""
    a, b = here.mean(axis=0), origin.mean(axis=0)
    u, _, v = np.linalg.svd((here - a).T @ (origin - b))
    turn = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ v))]) @ v
    return (points - a) @ turn + b


def distances(points, corner, e1, e2):
    """From points (n, 3) to one triangle [m]."""
    p = points - corner
    d11, d12, d22 = e1 @ e1, e1 @ e2, e2 @ e2
    p1, p2 = p @ e1, p @ e2
    area = d11 * d22 - d12 * d12
    if area > 0:
        s, t = (d22 * p1 - d12 * p2) / area, (d11 * p2 - d12 * p1) / area
    else:
        s = t = np.full(len(p), -1.0)
    on_face = (s >= 0) & (t >= 0) & (s + t <= 1)
    nearest = [np.where(on_face[:, None], s[:, None] * e1 + t[:, None] * e2, np.inf)]
    for start, edge in ((0 * e1, e1), (0 * e1, e2), (e1, e2 - e1)):
        along = np.clip((p - start) @ edge / max(edge @ edge, 1e-300), 0, 1)
        nearest.append(start + along[:, None] * edge)
    return np.min([np.linalg.norm(p - at, axis=1) for at in nearest], axis=0)


def windings(folder, reach=0.03):
    """The winding number of the panels around each particle near them in each frame, and the smallest distance to a triangle below `reach` [m]."""
    origin, near = None, []
    for (_, ice), (_, screw) in zip(pictures(folder, "ice"), pictures(folder, "propeller")):
        vertices = screw.points.astype(float)
        if origin is None:
            origin, panels = vertices, np.array(screw.panels)
            low, high = origin.min(axis=0) - reach, origin.max(axis=0) + reach
        here = rotated_back(ice.points.astype(float), origin, vertices)
        near.append(here[((here > low) & (here < high)).all(axis=1)])
    points = np.concatenate(near)
    points = points[np.argsort(points[:, 1])]
    winding, smallest = np.zeros(len(points), int), np.inf
    for corners in origin[panels]:
        below, above = corners.min(axis=0) - reach, corners.max(axis=0) + reach
        first, last = np.searchsorted(points[:, 1], [below[1], above[1]])
        some = np.arange(first, last)[(points[first:last, 2] > below[2]) & (points[first:last, 2] < above[2])]
        e1, e2 = corners[1] - corners[0], corners[2] - corners[0]
        projected = e1[1] * e2[2] - e1[2] * e2[1]  # twice the area seen along x; above 0 where the outward normal points to +x
        if projected != 0:
            p = points[some] - corners[0]
            s = (p[:, 1] * e2[2] - p[:, 2] * e2[1]) / projected
            t = (e1[1] * p[:, 2] - e1[2] * p[:, 1]) / projected
            ahead = (s >= 0) & (t >= 0) & (s + t < 1) & (s * e1[0] + t * e2[0] > p[:, 0])
            winding[some[ahead]] += int(np.sign(projected))
        close = some[(points[some, 0] > below[0]) & (points[some, 0] < above[0])]
        if len(close):
            smallest = min(smallest, distances(points[close], corners[0], e1, e2).min())
    return winding, smallest


def inside(folder):
    winding, smallest = windings(folder)
    return {"positions near the propeller [-]": len(winding), "inside [-]": int((winding != 0).sum()), "nearest [m]": smallest}


# ---- the rest


def energy(column):
    kinetic = column["ice.kinetic_energy [J]"][0]
    found = {"energy balance error [-]": np.abs(column["total.energy_balance_error [J]"]).max() / kinetic}
    if "ice.plastic_dissipation [J]" in column:
        found["plastic dissipation [-]"] = column["ice.plastic_dissipation [J]"][-1] / kinetic
    if "propeller.crushing_dissipation [J]" in column:
        found["crushing dissipation [-]"] = column["propeller.crushing_dissipation [J]"][-1] / kinetic
    return found


def momentum(column):
    total = np.column_stack([column[f"total.momentum_{axis} [kg m/s]"] for axis in "xyz"])
    return np.linalg.norm(total - total[0], axis=1).max()


def cost(report):
    detection = report["impactors"]["propeller"]["detection"]["ice"]
    return {
        "contact bounds": report["impactors"]["propeller"]["contact_bounds"]["kind"],
        "points in the bounds [-]": detection["points_in_bounds"],
        "points tested [-]": detection["points_tested"],
        "panels tested [-]": detection["panels_tested"],
        "contact [s]": report["timers [s]"]["contact"],
        "state": report["state_hash"],
    }


def measure(folder):
    report, column = report_of(folder), history(folder)
    found = forces(column) | fragments(folder, report) | energy(column) | inside(folder)
    if len(report["setup"]["impactors"]["propeller"]["free_dofs"]) == 6:
        ice = report["bodies"]["ice"]["mass [kg]"] * np.linalg.norm(report["setup"]["bodies"]["ice"]["velocity"])
        found["drift [-]"] = momentum(column) / ice
    return found | cost(report)


def show(title, values):
    print(title)
    for name, value in values.items():
        print(f"    {name:<36}{value if isinstance(value, (str, int)) else f'{value:.5g}'}", flush=True)


def main():
    for folder in options(__doc__, nargs="+").parse_args().results:
        show(folder, measure(folder))


if __name__ == "__main__":
    run(main)
