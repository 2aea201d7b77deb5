#!/usr/bin/python3
"""Whether ice breaks alike in any direction of its lattice: direction.py PROGRAM OUTDIR

With the ice of test 302, at three angles between an axis of the lattice and the direction of load or course: a floating strip under a line load on its edge, which beam theory breaks
at one place; and the bow in the edge of a sheet of 24 × 36 m at 1.5 m/s, its first 1.4 s. Prints the two tables of README.md. Finished runs in OUTDIR are not made again: a minute in all.
"""

import argparse
import json
import subprocess
import sys
from math import cos, radians, sin
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "../ship_ice"), str(HERE / "../../scripts/results")]
from csv_reader import history  # noqa: E402
from decks import ship_in, tests  # noqa: E402
from strip_crack import BROKEN, is_through  # noqa: E402
from vtp_reader import read_vtp, series  # noqa: E402

ANGLES = (0.0, 22.5, 45.0)  # [deg]
SHIP = ship_in(tests()[302])
SHEET = 70, 105  # spacings along the course and across
STRIP = 92, 9  # spacings: three characteristic lengths
SPEED, LOAD, RAMP, END = 1.5, 40e3, 4.0, 3.2  # [m/s] [N/m] at [s], half as fast before 0.95 s; [s]


def body(cells, degrees):
    """A sheet of so many spacings along the course and across, whose near edge goes through the origin."""
    turn, draft, long = radians(degrees), SHIP.thickness * SHIP.ice / SHIP.water, cells[0] * SHIP.spacing
    return {
        "shape": {"box": {"size": [long, cells[1] * SHIP.spacing, SHIP.thickness]}}, "position": [-long / 2 * cos(turn), -long / 2 * sin(turn), SHIP.thickness / 2 - draft],
        "rotate": [0, 0, turn], "spacing": SHIP.spacing, "horizon_ratio": 2.015, "bending_calibration": "z",
        "material": {
            "model": "bond-based", "youngs_modulus": SHIP.young, "density": SHIP.ice, "layers": SHIP.layers, "flexural_strength": (1 - SHIP.poisson**2) * SHIP.strength,
            "plasticity": {"compressive_strength": SHIP.compressive_strength, "failure_strain": 0.003, "failure_pressure": 0.2, "failure_width": 3, "friction_angle": radians(30)},
        },
    }  # fmt: skip


def strip(degrees):
    ice, edge = body(STRIP, degrees), 0.8
    ice["particle_sets"] = {"edge": {"shape": {"box": {"size": [edge, 10, 10]}}, "position": [(STRIP[0] * SHIP.spacing - edge) / 2, 0, 0]}}
    load = {"particle_set": "edge", "force_density": [0, 0, -LOAD / (edge * SHIP.thickness)], "times": [0, 0.95, RAMP], "factors": [0, 0.125, 1]}
    ice["boundary_conditions"] = {"sea": {"floating": {"damping": 1}}, "load": {"body_force": load}}
    output = {"frames": 64, "frame_fields": ["displacement", "damage"], "history_interval": 0.02, "checkpoint_interval": 0}
    return {"title": f"A floating strip at {degrees:g} degrees", "time": {"end": END, "step": 0.16e-3}, "bodies": {"ice": ice}, "output": output}


def sheet(degrees):
    ice, turn = body(SHEET, degrees), radians(degrees)
    ice["mass_scaling"] = round(SHIP.mass_scaling, 2)
    ice["boundary_conditions"] = {"sea": {"floating": {"dry_top": round(SHIP.dry_top, 2)}}}
    course = np.array([cos(turn), sin(turn), 0])
    ship = {
        "surface": {"file": "../hull.obj", "rotate": [0, 0, turn]}, "position": list(0.25 * course), "mass": SHIP.displacement, "velocity": list(-SPEED * course), "contact_bounds": {"auto": {}},
    }  # fmt: skip
    contact = {
        "impactors": {"friction": SHIP.friction, "crushing_pressure": SHIP.compressive_strength}, "fragments": {"law": "repulsive", "stiffness_factor": 2, "friction": SHIP.ice_friction},
    }  # fmt: skip
    output = {"frames": 14, "frame_fields": ["displacement", "damage"], "history_interval": 0.02, "checkpoint_interval": 0}
    return {"title": f"The bow at {degrees:g} degrees", "time": {"end": 1.4, "step": 0.9 * SHIP.step}, "bodies": {"ice": ice}, "impactors": {"ship": ship}, "contact": contact, "output": output}


def hull(program, file):
    sizes = {"length": SHIP.length, "breadth": SHIP.beam, "draft": SHIP.draft, "freeboard": SHIP.freeboard, "fullness": SHIP.fullness, "edge-length": SHIP.edge_length, "bow-edge-length": SHIP.bow_edge_length}
    angles = {"stem-angle": f"{SHIP.stem:g} deg", "waterline-angle": f"{SHIP.waterline:g} deg"}
    words = [word for name, value in {**sizes, **angles}.items() for word in (f"--{name}", str(value))]
    subprocess.run([program, "shape", "hull", *words, "--out", file], check=True, stdout=subprocess.DEVNULL)


def run(program, folder, deck):
    if not (folder / "out/run.json").exists():
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "deck.yaml").write_text(json.dumps(deck, indent=1) + "\n", encoding="utf-8")
        subprocess.run([program, "run", folder / "deck.yaml", "--out", folder / "out", "--force", "--no-report"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return folder / "out"


def loads_of(folder, degrees):
    """[N/m] load at the first frame with a broken bond, and with a crack through the strip (NaN: none); [m] along which bonds of the top layer are broken 0.1 s after the first."""
    along = np.array([cos(radians(degrees)), sin(radians(degrees))])
    first = through = spread = float("nan")
    since = None
    for time, file in series(folder, "ice"):
        frame = read_vtp(file)
        damage, reference = frame.point["damage"], frame.points - frame.point["displacement"]
        if damage.max() == 0:
            continue
        load, place, height = LOAD * np.interp(time, [0, 0.95, RAMP], [0, 0.125, 1]), reference[:, :2] @ along, np.round(reference[:, 2], 2)
        if since is None:
            since, first = time, load
        if time < since + 0.11:
            spread = np.ptp(place[(damage > BROKEN) & (height == height.max())])
        if is_through(place, height, damage, SHIP.spacing):
            return first, load, spread
    return first, through, spread


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program", metavar="PROGRAM", type=Path)
    arguments.add_argument("out", metavar="OUTDIR", type=Path)
    given = arguments.parse_args()
    program, out = given.program.resolve(), given.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    hull(program, out / "hull.obj")
    print("| direction | first bond [kN/m] | crack through the strip [kN/m] | bonds of the top layer broken within 0.1 s, over [m] |\n|---|---|---|---|")
    for degrees in ANGLES:
        first, through, spread = loads_of(run(program, out / f"strip_{degrees:g}", strip(degrees)), degrees)
        print(f"| {degrees:g}° | {first / 1e3:.1f} | {f'{through / 1e3:.1f}' if through == through else f'none up to {LOAD * END / RAMP / 1e3:.0f}'} | {spread:.1f} |")
    print("\n| course | largest F_z [kN] | work of the ship [kJ] | fracture energy [kJ] | bonds broken | energy balance error [J] |\n|---|---|---|---|---|---|")
    for degrees in ANGLES:
        rows = history(run(program, out / f"sheet_{degrees:g}", sheet(degrees)))
        at_end = [rows[name][-1] for name in ("ship.contact_work [J]", "ice.fracture_energy [J]", "ice.broken_bonds [-]")]
        error = np.abs(rows["total.energy_balance_error [J]"]).max()
        print(f"| {degrees:g}° | {rows['ship.force_z [N]'].max() / 1e3:.0f} | {-at_end[0] / 1e3:.0f} | {at_end[1] / 1e3:.0f} | {at_end[2]:.0f} | {error:.0f} |")


if __name__ == "__main__":
    main()
