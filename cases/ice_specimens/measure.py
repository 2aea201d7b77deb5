#!/usr/bin/python3
"""Strengths and energy balance of the specimens of this case:

    cases/ice_specimens/measure.py results/ice_specimens      prints the rows of expected.csv, and more

The folder contains the results of any of the decks, each in a folder of its name; missing ones are skipped.

compressive strength   largest mean force on both platens over the first cross-section
crushed                the same strength; mean of that stress from 0.5 % of strain on, over the compressive strength
tensile strength       largest mean pull of both platens over the first cross-section
splitting              2 P/(π D t) of the last row before the first bond breaks
flexural strength      largest load of both lines before the first bond breaks, as the stress at the surface of a beam: 3 F a/(b h²), a from support to load
punch                  mean pressure under the punch over the compressive strength, at the end
indentation            contact force over the area of the sphere's cap below the first surface, mean over the rows in which that is 0.3 to 0.8 m²
edge                   force over the area of the indenter below the first edge, over the compressive strength; mean over the second half of the run
ball                   largest force; over v √(2πR p m) with the mean pressure p over the contact area until the ball stops; time until it stops over that of theory; impulse over m v
drop                   largest force over the area of the cap below the first surface; mean pressure over 15 cm² at the lowest point, between two times
energy error           largest total.energy_balance_error over the external work
"""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent / "../../scripts/results"))
from results_folder import Named, options, records, refuse, report_of, run  # noqa: E402
from vtp_reader import picture_at  # noqa: E402

TENSION = 0.576e6  # [Pa] E s_c
SIDE = 0.1  # [m] of the prism
CRUSHED = 0.005  # [-] strain beyond which the prism is crushed
DISC = 0.32, 0.08  # [m] diameter, thickness
ARM, WIDTH, HEIGHT = 0.6, 0.2, 0.2  # [m] of the beam
PUNCH = 0.16  # [m] width
RADIUS, SPEED, GAP = 0.6, 2.0, 0.001  # [m] [m/s] [m] of the sphere
AREAS = 0.3, 0.8  # [m²]
DROP_RADIUS, DROP_CENTRE = 0.2, (0.0017, 0.0009)  # [m]
DROP_AREA, DROP_TIMES = 15e-4, (0.0015, 0.003)  # [m²] [s]: the contact area is 50 cm² at first, and the force still rises at the end
BALL = 1.0, 900.0, 20.0  # [m] [kg/m³] [m/s]


def width_of_sphere(depth, diameter=0.24, thickness=0.06):
    """[m] mean width, over the thickness, of the section of a sphere at mid-height with the first edge of the sheet."""
    radius = math.sqrt(diameter * depth - depth**2)
    angle = math.asin(min(1.0, thickness / 2 / radius))  # of the faces of the sheet, seen from the centre of that section
    return 2 * radius**2 * (angle + math.sin(angle) * math.cos(angle)) / thickness


# of the indenters of a sheet's edge: thickness of the sheet [m], speed [m/s], width [m] at a depth [m]
EDGES = {
    "edge_narrow": (0.06, 0.16, lambda depth: 0.12),
    "edge_wide": (0.04, 0.16, lambda depth: 0.32),
    "edge_wedge": (0.06, 0.5, lambda depth: 2 * depth * math.sqrt(3)),
    "edge_cylinder": (0.06, 0.2, lambda depth: 2 * math.sqrt(0.24 * depth - depth**2)),
    "edge_sphere": (0.06, 0.2, width_of_sphere),
}


def history(folder):
    """Rows of history.csv by their headings without units."""
    return numbers(folder, "history.csv")


def numbers(folder, table):
    return [Named({key.split(" [")[0]: float(value) for key, value in row.items()}, row.owner) for row in records(folder, table)]


def strength(folder, body="ice"):
    """[Pa] uniaxial compressive strength that the deck gives."""
    return report_of(folder)["setup"]["bodies"][body]["material"]["plasticity"]["compressive_strength"]


def broken_in(folder, curve):
    """The rows (…, stress, broken bonds) of a specimen, which must have broken."""
    if curve[-1][-1] == 0:
        refuse(f"{folder} ended before a bond broke; its largest stress is no strength. Repeat it with a longer time.end (docs/guide/calibration.md).")
    return curve


def energy_error(rows, *works):
    work = max(abs(sum(row[name] for name in works)) for row in rows)
    return max(abs(row["total.energy_balance_error"]) for row in rows) / work


def ramped(time, ramp, speed):
    """Distance [m] at this time of an end whose speed rises linearly to `speed` at `ramp`."""
    return speed * (time - ramp / 2 if time > ramp else time * time / (2 * ramp))


def compression(folder):
    """(strain [-] of the whole prism, mean stress [Pa]) of each row."""
    ends = 0.19  # [m] between the layers that are moved
    return [(2 * ramped(row["time"], 2.4e-3, 0.035) / ends, platens(row) / SIDE**2) for row in history(folder)]


def platens(row):
    """[N] mean force of top and bottom towards each other."""
    return 0.5 * (row["ice.bottom.force_z"] - row["ice.top.force_z"])


def tension(folder):
    """(strain [-] of the whole prism, mean stress [Pa], broken bonds) of each row."""
    return [(2 * ramped(row["time"], 2.4e-3, 0.01) / 0.19, -platens(row) / SIDE**2, row["ice.broken_bonds"]) for row in history(folder)]


def splitting(folder):
    """(shortening of the diameter [m], 2 P/(π D t) [Pa], broken bonds) of each row."""
    diameter, thickness = DISC
    return [(2 * ramped(row["time"], 3.2e-3, 0.02), 2 * platens(row) / (math.pi * diameter * thickness), row["ice.broken_bonds"]) for row in history(folder)]


def bending(folder):
    """(time [s], stress [Pa] at the surface of a beam under these loads, broken bonds) of each row."""
    scale = 3 * ARM / (WIDTH * HEIGHT**2)
    return [(row["time"], -scale * (row["ice.load_left.force_z"] + row["ice.load_right.force_z"]), row["ice.broken_bonds"]) for row in history(folder)]


def punch(folder):
    """(depth over width [-], mean pressure over the compressive strength [-]) of each row."""
    depth = report_of(folder)["setup"]["bodies"]["block"]["shape"]["box"]["size"][1]
    yields_at = PUNCH * depth * strength(folder, "block")  # [N]
    return [(ramped(row["time"], 4e-3, 0.15) / PUNCH, -row["block.punch.force_z"] / yields_at) for row in history(folder)]


def cap(radius, depth):
    """[m²] of a sphere's section at the first surface."""
    return math.pi * (2 * radius * depth - depth**2)


def indentation(folder):
    """(area [m²] of the cap, mean pressure [Pa]) of each row in which the sphere is deeper than 2 cm."""
    depths = [(SPEED * row["time"] - GAP, row["sphere.force_z"]) for row in history(folder)]
    return [(cap(RADIUS, depth), force / cap(RADIUS, depth)) for depth, force in depths if depth > 0.02]


def edge(folder):
    """(depth [m], contact area [m²] below the first edge, mean pressure [Pa]) of each row with contact."""
    thickness, speed, width = EDGES[Path(folder).name]
    found = []
    for row in history(folder)[1:]:
        depth = speed * row["time"]
        area = width(depth) * thickness
        found.append((depth, area, -row["indenter.force_x"] / area))
    return found


def late(values):
    """Mean over the second half."""
    half = values[len(values) // 2 :]
    return sum(half) / len(half)


def ball(folder):
    """(time [s], force of the plate [N]) of each row."""
    return [(row["time"], -row["plate.force_z"]) for row in history(folder)]


def stopping_time(folder):
    """[s] at which the ball's momentum vanishes; the end of the run if it does not."""
    rows = history(folder)
    return next((row["time"] for row in rows if row["total.momentum_z"] >= 0), rows[-1]["time"])


def crushing_pressure(folder):
    """[Pa] impulse until the ball's centre of mass stops over the integral of the contact area."""
    stop = stopping_time(folder)
    loading = [row for row in numbers(folder, "pressure_area/plate.csv") if row["time"] <= stop]
    return sum(row["normal_force"] for row in loading) / sum(row["contact_area"] for row in loading)


def plastic_sphere(pressure):
    """(largest force [N], time until it stops [s]) of a plastic sphere under a crushing pressure [Pa]: v √(k m), π/2 √(m/k), k = 2πR p."""
    diameter, density, speed = BALL
    stiffness, mass = math.pi * diameter * pressure, density * math.pi / 6 * diameter**3
    return speed * math.sqrt(stiffness * mass), 0.5 * math.pi * math.sqrt(mass / stiffness)


def drop(folder):
    """(time [s], depth [m], force [N]) of each row."""
    rows = history(folder)
    return [(row["time"], rows[0]["sphere.position_z"] - row["sphere.position_z"], row["sphere.force_z"]) for row in rows]


def centre_pressure(folder, first, last):
    """[Pa] mean pressure on the panels within a disc of DROP_AREA at the lowest point of the sphere, between the frames nearest to two times [s]."""
    impulses, times = [], []
    for time in (first, last):
        at, sphere = picture_at(folder, "sphere", time)
        corners = sphere.points[np.array(sphere.panels)]
        middles = corners.mean(axis=1)
        areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        is_inside = (np.hypot(*(middles[:, :2] - DROP_CENTRE).T) < math.sqrt(DROP_AREA / math.pi)) & (middles[:, 2] < sphere.points[:, 2].mean())
        impulses.append(sphere.cell["contact_impulse"][is_inside, 2].sum()), times.append(at)
    return (impulses[1] - impulses[0]) / (areas[is_inside].sum() * (times[1] - times[0]))


def nested(folder, name):
    """(area [m²], mean pressure [Pa]) over nested areas of panels, at the largest force."""
    return [tuple(row.values()) for row in numbers(folder, f"pressure_area/{name}_at_peak.csv")]


def iso_global(thickness, width, coefficient=2.8e6):
    """[Pa] design pressure of ISO 19906 over the width of a structure; the coefficient 2.8 MPa is for the Arctic, 1.8 MPa for the Baltic."""
    exponent = min(-0.3, 0.2 * thickness - 0.5)
    return coefficient * thickness**exponent * (width / thickness) ** -0.16


def local_design(area):
    """[Pa] 7.4 A^-0.7 MPa, the curve for local design."""
    return 7.4e6 * area**-0.7


def of_prisms(folder):
    found = {}
    if (folder / "compression").is_dir():
        found["compressive strength [MPa]"] = max(stress for _, stress in compression(folder / "compression")) / 1e6
        found["compression energy error [-]"] = energy_error(history(folder / "compression"), "ice.top.work", "ice.bottom.work")
    if (folder / "crushed").is_dir():
        curve = compression(folder / "crushed")
        found["crushed strength [MPa]"] = max(stress for _, stress in curve) / 1e6
        after = [stress for strain, stress in curve if strain > CRUSHED]
        if after:  # a run of its first part has none
            found["crushed residual strength [-]"] = sum(after) / len(after) / strength(folder / "crushed")
        found["crushed energy error [-]"] = energy_error(history(folder / "crushed"), "ice.top.work", "ice.bottom.work")
    if (folder / "tension").is_dir():
        found["tensile strength [MPa]"] = max(stress for _, stress, _ in broken_in(folder / "tension", tension(folder / "tension"))) / 1e6
        found["tension energy error [-]"] = energy_error(history(folder / "tension"), "ice.top.work", "ice.bottom.work")
    if (folder / "brazilian").is_dir():
        found["splitting strength [MPa]"] = max(stress for _, stress, broken in broken_in(folder / "brazilian", splitting(folder / "brazilian")) if broken == 0) / 1e6
        found["splitting energy error [-]"] = energy_error(history(folder / "brazilian"), "ice.top.work", "ice.bottom.work")
    if (folder / "bending").is_dir():
        found["flexural strength [MPa]"] = max(stress for _, stress, broken in broken_in(folder / "bending", bending(folder / "bending")) if broken == 0) / 1e6
        found["bending energy error [-]"] = energy_error(history(folder / "bending"), "ice.load_left.work", "ice.load_right.work")
    return found


def of_indenters(folder):
    found = {}
    if (folder / "punch").is_dir():
        found["punch [-]"] = punch(folder / "punch")[-1][1]
        found["punch energy error [-]"] = energy_error(history(folder / "punch"), "block.punch.work")
    if (folder / "indentation").is_dir():
        curve = [(area, pressure) for area, pressure in indentation(folder / "indentation") if AREAS[0] < area < AREAS[1]]
        found["indentation pressure [MPa]"] = sum(pressure for _, pressure in curve) / len(curve) / 1e6
        found["indentation over 7.4 A^-0.7 [-]"] = max(pressure / local_design(area) for area, pressure in curve)
        found["indentation energy error [-]"] = energy_error(history(folder / "indentation"), "sphere.contact_work")
    for name, (thickness, _, width) in EDGES.items():
        if not (folder / name).is_dir():
            continue
        curve = edge(folder / name)
        found[f"{name} [-]"] = late([pressure for *_, pressure in curve]) / strength(folder / name)
        found[f"{name} over ISO [-]"] = late([pressure / iso_global(thickness, width(depth)) for depth, _, pressure in curve])
        found[f"{name} energy error [-]"] = energy_error(history(folder / name), "indenter.contact_work")
    return found


def of_impacts(folder):
    found = {}
    if (folder / "ball").is_dir():
        curve, rows = ball(folder / "ball"), history(folder / "ball")
        diameter, density, speed = BALL
        momentum = density * math.pi / 6 * diameter**3 * speed
        found["ball force [MN]"] = max(force for _, force in curve) / 1e6
        pressure = crushing_pressure(folder / "ball")
        force, time = plastic_sphere(pressure)
        found["ball crushing pressure [MPa]"] = pressure / 1e6
        found["ball force over plastic sphere [-]"] = found["ball force [MN]"] * 1e6 / force
        found["ball time over plastic sphere [-]"] = stopping_time(folder / "ball") / time
        found["ball impulse [-]"] = sum(force for _, force in curve) * (curve[1][0] - curve[0][0]) / momentum
        found["ball energy error [-]"] = max(abs(row["total.energy_balance_error"]) for row in rows) / (0.5 * momentum * speed)
    if (folder / "drop").is_dir():
        curve = drop(folder / "drop")
        _, depth, force = max(curve, key=lambda row: row[2])
        found["drop force [MN]"] = force / 1e6
        found["drop mean pressure [MPa]"] = force / cap(DROP_RADIUS, depth) / 1e6
        found["drop centre pressure [MPa]"] = centre_pressure(folder / "drop", *DROP_TIMES) / 1e6
        found["drop energy error [-]"] = energy_error(history(folder / "drop"), "sphere.contact_work")
    return found


def output_setting(deck):
    """What measure() needs of the output of a deck: frames where a pressure is taken from them, none elsewhere."""
    return f"output.frames={40 if deck == 'drop' else 0}"


def measure(folder):
    folder = Path(folder)
    return of_prisms(folder) | of_indenters(folder) | of_impacts(folder) or refuse(f"{folder} has no folder of results with the name of a deck of this case.")


def main():
    for path in options(__doc__, nargs="+").parse_args().results:
        for name, value in measure(path).items():
            print(f"{name:40}{value:.6g}")


if __name__ == "__main__":
    run(main)
