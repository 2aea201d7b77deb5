"""The finite-element reference of the plate: converged, with a closed energy balance, and reproducible."""

import subprocess
import sys

from rows import AtMost, Row, Within, read_columns
from runner import ROOT
from topics.plate import CENTRE, COARSE, FEM, FINE, TIME, V, at, values

TITLE = "Finite elements"
LONG = True
RUNS = {"fem_4mm": ("--size", "4"), "fem_2mm": ("--size", "2"), "fem_1mm": ("--size", "1"), "fem_2mm_gap": ("--size", "2", "--gap", "0.5"),
        "fem_2mm_late": ("--size", "2", "--late")}  # fmt: skip
FIRST = 1.57 * 32**2 / 2  # [J]


def gathered():
    found = {name: read_columns(FEM / f"{name}.csv") for name in RUNS}
    plane = read_columns(ROOT / "cases/plate_impact/reference_fem.csv")
    numbers = {f"{name} {quantity}": value for name, history in found.items() for quantity, value in values(history).items()}
    fine, coarse = f"fem_{FINE}mm", f"fem_{COARSE}mm"
    return numbers | {
        "centre, halved": numbers[f"{fine} centre"] / numbers[f"{coarse} centre"] - 1,
        "cylinder, halved": numbers[f"{fine} cylinder"] / numbers[f"{coarse} cylinder"] - 1,
        "velocity, halved": numbers[f"{fine} v200"] - numbers[f"{coarse} v200"],
        "closing": max(abs(error) for error in found[fine]["energy balance error [J]"]) / FIRST,
        "loss": found[fine]["contact dissipation [J]"][-1] / FIRST,
        "centre, plane": numbers[f"{fine} centre"] / at(plane, CENTRE, 200e-6) - 1,
        "velocity, plane": numbers[f"{fine} v200"] - at(plane, V, 200e-6),
    }


def measure(runner):
    out = runner.folder("fem", "out")
    largest = 0.0
    for name, arguments in RUNS.items():
        if not (out / f"{name}.csv").exists():
            print(f"  fem/{name}", flush=True)
            done = subprocess.run(["/usr/bin/python3", FEM / "fem.py", out, *arguments], capture_output=True, text=True)
            if done.returncode:
                sys.exit(done.stderr.strip().splitlines()[-1])
        new, kept = read_columns(out / f"{name}.csv"), read_columns(FEM / f"{name}.csv")
        assert new[TIME] == kept[TIME], f"{name}: rows of different times"
        largest = max(largest, max(abs(a - b) for a, b in zip(new[CENTRE], kept[CENTRE])))
    return {"again": largest}


def text(n):
    lines = ["| elements | gap | centre [mm] | cylinder [mm] | v at 50 µs [m/s] | v at 200 µs [m/s] | largest force [MN] | end [µs] |", "|---|---|---|---|---|---|---|---|"]
    for name in RUNS:
        c = {quantity: n[f"{name} {quantity}"] for quantity in ("centre", "cylinder", "v50", "v200", "force", "end")}
        size, gap = name.split("_")[1].replace("mm", " mm") + ", delayed reaction" * name.endswith("late"), "0.5 mm" if name.endswith("gap") else "0"
        lines.append(f"| {size} | {gap} | {1e3 * c['centre']:.3f} | {1e3 * c['cylinder']:.3f} | {c['v50']:.2f} | {c['v200']:.2f} | {c['force'] / 1e6:.3f} | {1e6 * c['end']:.0f} |".replace("-", "−"))
    return f"""A quarter of the plate in dolfinx 0.5 (Debian's `python3-dolfinx`): {len(RUNS)} runs, minutes. The energy balance of cylinder and plate closes to {n["closing"]:.0e} of
the initial energy of the cylinder; contact, where nodes stop, dissipates {n["loss"]:.1e} of it, less with finer elements.

""" + "\n".join(lines)


def rows():
    own = "the mesh with elements twice as large"
    return [
        Row(f"centre, from {COARSE} mm to {FINE} mm", own, "centre, halved", "%", Within(0, 0.005), "half of the tolerance for perimpact; with first-order convergence the remaining error is as large again"),
        Row(f"cylinder, from {COARSE} mm to {FINE} mm", own, "cylinder, halved", "%", Within(0, 0.005), "as above"),
        Row(f"velocity at the end, from {COARSE} mm to {FINE} mm", own, "velocity, halved", "m/s", Within(0, 0.3), "converges last, since reflected waves determine the last µs of contact; with first-order convergence the remaining error is as large again, which is the tolerance for perimpact"),
        Row("energy balance (largest error of all rows)", "initial energy of the cylinder", "closing", "small", AtMost(1e-5), "central differences: second order in the step, 1e-6 at half the critical step"),
        Row("centre, against plane-stress elements of 1 mm", "[reference_fem.py](../cases/plate_impact/reference_fem.py), numpy", "centre, plane", "%", Within(0, 0.01), "a plate of 9 mm is nearly in plane stress; linear elasticity, although the edge is compressed by some per cent; different contact"),
        Row("velocity at the end, against the same", "[reference_fem.py](../cases/plate_impact/reference_fem.py), numpy", "velocity, plane", "m/s", Within(0, 0.2), "linear elasticity, different contact, finer elements"),
        Row("repeated runs equal the stored ones (largest difference of the centre)", "[validation](../validation/README.md)", "again", "nm", AtMost(1e-8), "seven digits are written, of 5 mm"),
    ]  # fmt: skip
