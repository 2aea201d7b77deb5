#!/usr/bin/env python3
"""The speed of a GPU: steps per second by number of particles, and the ship's whole run. Whether its results are right: equality.py.

    benchmarks/gpu/measure.py                    some minutes on a machine with a GPU: writes results/gpu_<device>_<machine>.csv
    benchmarks/gpu/measure.py --whole-run        the ship of cases/ship_ice/paper.yaml as well, from beginning to end, on the GPU alone

The plate of cases/plate_impact, ordinary state-based with a dilatation term (ν = 0.3), 122 bonds, its surface corrected and its bonds breakable, with contact, is
repeated in larger sizes, and once with a number of particles in each direction that is a power of two, where addresses might conflict. Speeds are medians over the
rounds, from the timers of run.json, without set-up. `of the peak`: 49 instructions in double precision for each directed bond in the two passes, over what the GPU can
issue, --peak. Exit code 1: a speed that is wanted is not reached. 2: something is missing.
"""

import argparse
import json
import os
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks/plate"))
import programs  # noqa: E402

CASES = ROOT / "cases"
SPACING = 1e-3  # [m] of the plate
BONDS = 122
INSTRUCTIONS = 49  # in double precision for a directed bond, counted in the machine code of both passes
SIZES = {"180 000": (200, 100, 9), "10⁶": (400, 278, 9), "2²⁰": (512, 256, 8), "10⁷": (1250, 889, 9), "5·10⁷": (2800, 1984, 9)}  # particles in each direction
# words of a name: double-precision instructions per second, a fused multiply-add being one (data sheets of NVIDIA: half of the peak FLOP/s without tensor cores)
PEAKS = {"A100": 4.85e12, "H100 PCIe": 12.8e12, "H100": 16.75e12, "H200": 16.75e12}
WANTED = {"10⁷": ("particle-steps/s", 5e8), "180 000": ("steps/s", 2000)}


def run(program, deck, device, changes):
    """What run.json reports."""
    with tempfile.TemporaryDirectory() as folder:
        programs.run([program, "run", CASES / deck, "--out", f"{folder}/r", "--device", device, "--no-report", *programs.changes(changes)], os.sched_getaffinity(0))
        return json.loads(Path(f"{folder}/r/run.json").read_text())


def changes_of(size, steps):
    x, y, z = (number * SPACING for number in size)
    return {
        "bodies.plate.shape.box.size": f"[{x}, {y}, {z}]", "bodies.plate.position": f"[0, {0.05 - y / 2}, 0]",  # the edge stays below the cylinder
        "bodies.plate.family": "madenci-oterkus", "bodies.plate.surface_correction": "energy", "bodies.plate.material.poissons_ratio": 0.3,
        "bodies.plate.material.critical_stretch": 0.5, "time.step": "0.1 us", "time.end": f"{0.1 * steps:g} us",
        "output.frames": 0, "output.history_interval": f"{0.1 * steps:g} us", "output.checkpoint_interval": 0, "output.probes": "{}", "output.lines": "{}",
    }  # fmt: skip


def row_of(name, device, reports, peak):
    particles, steps = reports[0]["bodies"]["plate"]["particles"], reports[0]["steps"]
    speeds = sorted(steps / sum(report["timers [s]"].values()) for report in reports)
    speed = statistics.median(speeds)
    share = speed * particles * BONDS * INSTRUCTIONS / peak if peak else None
    return {"machine": programs.machine(), "device": device, "plate": name, "particles": particles, "steps": steps, "rounds": len(reports),
            "steps/s": f"{speed:.4g}", "steps/s_min": f"{speeds[0]:.4g}", "steps/s_max": f"{speeds[-1]:.4g}", "particle-steps/s": f"{speed * particles:.4g}",
            "of the peak": f"{share:.3f}" if share else "", "contact": f"{reports[0]['timers [s]'].get('contact', 0) / sum(reports[0]['timers [s]'].values()):.3f}"}  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    parser.add_argument("--device", default="cuda", help="device that is measured (default cuda)")
    parser.add_argument("--rounds", type=int, default=3, help="number of rounds (default 3)")
    parser.add_argument("--updates", type=float, default=2e10, help="particle-steps of each run, which determine its number of steps (default 2e10)")
    parser.add_argument("--sizes", nargs="*", choices=SIZES, default=list(SIZES), metavar="SIZE", help=f"of {', '.join(SIZES)}")
    parser.add_argument("--peak", type=float, help="double-precision instructions per second of the GPU; known of: " + ", ".join(PEAKS))
    parser.add_argument("--whole-run", action="store_true", help="the ship of paper.yaml from beginning to end")
    arguments = parser.parse_args()
    program = arguments.program.resolve()

    rows, missed = [], []
    for name in arguments.sizes:
        x, y, z = SIZES[name]
        steps = min(max(round(arguments.updates / (x * y * z)), 10), 2000)  # the cylinder stays in contact for 2000
        reports = [run(program, "plate_impact/deck.yaml", arguments.device, changes_of(SIZES[name], steps)) for _ in range(arguments.rounds)]
        device = reports[0].get("device", arguments.device)
        peak = arguments.peak or next((value for key, value in PEAKS.items() if key in device), None)
        rows.append(row_of(name, device, reports, peak))
        print(f"{name:<20}{rows[-1]['steps/s']:>8} steps/s  {rows[-1]['particle-steps/s']} particle-steps/s", flush=True)
        quantity, wanted = WANTED.get(name, ("steps/s", 0))
        if float(rows[-1][quantity]) < wanted:
            missed.append(f"{name}: {rows[-1][quantity]} {quantity}, wanted {wanted:g}")
    if arguments.whole_run:
        report = run(program, "ship_ice/paper.yaml", arguments.device, {"output.frames": 0})
        print(f"ship, whole run: {report['steps']} steps in {sum(report['timers [s]'].values()) / 60:.1f} min", flush=True)
    if rows:
        programs.write_results(f"gpu {rows[0]['device']}", rows)
    for sentence in missed:
        print(f"NOT MET: {sentence}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    programs.exit_with(main)
