#!/usr/bin/python3
"""Impulse, peak force and duration of the impact:

    cases/ice_sphere/measure.py results/ice_sphere [more folders]

impulse       of the plate, along its normal, over (mass of the particles) × (initial speed): 1 without rebound, 2 for full rebound
peak, at      the largest mean over a row of history.csv (0.1 or 0.05 ms), and the middle of that row, from first contact; "1 ms": the same of
              means over a millisecond, for ice that breaks
duration      from the first row with a force to the end of the last one, if the sphere stays intact
fragments     connected components of intact bonds at the end that have more than 1 % of the mass, and the share of the largest
dissipation   plastic, and by crushing in contact; like the largest energy balance error over the initial kinetic energy of the ice
p_c           of a plastic sphere, F = 2πR p_c d at the depth d: v √(2πR p_c m) at most, no speed after T = π/2 √(m/(2πR p_c)). It loses half of its
              momentum in 2/3 T, 90 % in 0.936 T: p_c is from the first of these times, the other time and the largest force (mean over a
              millisecond) are over those of the formulas with this p_c
over Hertz    peak and duration over those of Hertz contact of the same ice with a rigid plane: an elastic sphere of radius R, mass m and speed v
              has F = 5/4 m v²/d, t = 2.943 d/v with d = (15 m v²/(16 E* √R))^(2/5), E* = E/(1 - ν²) (H. Hertz; K. L. Johnson, Contact
              Mechanics, 1985, section 11.4). m is the mass of the particles.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/results"))
from csv_reader import history  # noqa: E402
from interval_means import window_means  # noqa: E402
from results_folder import options, refuse, report_of, run  # noqa: E402

YOUNG, POISSON, RADIUS = 1.8e9, 0.25, 0.5  # [Pa] [-] [m]
WINDOW = 1e-3  # [s]


def hertz(mass, speed):
    """Largest force [N], duration [s], largest approach [m]."""
    modulus = YOUNG / (1 - POISSON**2)
    approach = (15 * mass * speed**2 / (16 * modulus * np.sqrt(RADIUS))) ** 0.4
    return 1.25 * mass * speed**2 / approach, 2.943 * approach / speed, approach


def plate_force(folder):
    """Ends of the rows [s], their lengths [s], mean normal force on the plate in each [N], mass [kg] and speed [m/s] of the ice at t = 0, run.json, and
    the columns of history.csv."""
    column = history(folder)
    report = report_of(folder)
    velocity = np.array(report["setup"]["bodies"]["ice"]["velocity"])
    speed = np.linalg.norm(velocity)
    force = np.column_stack([column[f"plate.force_{axis} [N]"] for axis in "xyz"]) @ velocity / speed
    if not (force > 0).any():
        refuse(f"{column.owner}: the ice is never in contact with the plate.")
    times = column["time [s]"]
    return times, np.diff(times, prepend=0), force, report["bodies"]["ice"]["mass [kg]"], speed, report, column


def measure(folder):
    times, steps, force, mass, speed, report, column = plate_force(folder)
    in_contact = np.flatnonzero(force > 0)
    hertz_force, hertz_duration, _ = hertz(mass, speed)
    begin = times[in_contact[0]] - steps[in_contact[0]]
    duration = times[in_contact[-1]] - begin
    body = report["bodies"]["ice"]
    intact = body["intact_bonds"] == body["bonds"]
    middles, smooth = window_means(times, force, WINDOW, is_zero_before=True)
    smooth_at = middles[smooth.argmax()] - begin
    kinetic = 0.5 * mass * speed**2
    found = {
        "impulse [-]": (force * steps).sum() / (mass * speed),
        "peak [N]": force.max(),
        "at [s]": times[force.argmax()] - steps[force.argmax()] / 2 - begin,
        "peak, 1 ms [N]": smooth.max(),
        "at, 1 ms [s]": smooth_at,
        "peak over Hertz [-]": force.max() / hertz_force,
        "duration [s]": duration if intact else None,
        "duration over Hertz [-]": duration / hertz_duration if intact else None,
        "broken bonds [-]": 1 - body["intact_bonds"] / body["bonds"],
        "energy balance error [-]": np.abs(column["total.energy_balance_error [J]"]).max() / kinetic,
    }
    if "fragments" in body:
        found["fragments above 1 % [-]"] = body["fragments"]["above_1_percent"]
        found["largest fragment [-]"] = body["fragments"]["largest [kg]"] / mass
    if "plate.crushing_dissipation [J]" in column:
        found["crushing dissipation [-]"] = column["plate.crushing_dissipation [J]"][-1] / kinetic
    if "ice.plastic_dissipation [J]" in column:
        found["plastic dissipation [-]"] = column["ice.plastic_dissipation [J]"][-1] / kinetic
        half, late = (np.interp(share * mass * speed, np.cumsum(force * steps), times) - begin for share in (0.5, 0.9))
        rate = np.arccos(0.5) / half  # [1/s] √(2πR p_c/m)
        found["p_c [Pa]"] = rate**2 * mass / (2 * np.pi * RADIUS)
        found["peak, 1 ms, over the formula's [-]"] = smooth.max() / (speed * rate * mass)
        found["time to 90 % over the formula's [-]"] = late / (np.arccos(0.1) / rate)
    return found


def main():
    for folder in options(__doc__, nargs="+").parse_args().results:
        print(folder)
        for name, value in measure(folder).items():
            print(f"    {name:<37}{'–' if value is None else f'{value:.7g}'}")


if __name__ == "__main__":
    run(main)
