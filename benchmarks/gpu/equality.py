#!/usr/bin/env python3
"""Every shipped deck on a device, and by the scalar kernel of the processor: state and all result files, byte for byte.

    benchmarks/gpu/equality.py [DECK ...]            on a GPU; writes results/gpu_equality_<device>.csv
    benchmarks/gpu/equality.py --device emulated     the same without one; five minutes on two cores with --updates 4e6

Of each deck the first steps are run, with changes that let impactors be in contact and bonds break within them. history.csv has a row every five steps, with exact
sums over all particles; state_hash, of the end, is that of all positions, velocities and bonds. Exit code 1: something differs. 2: a run fails.
"""

import argparse
import concurrent.futures
import os
import queue
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks/plate"))
import programs  # noqa: E402

CASES = ROOT / "cases"
STEPS = 600
CORES = 2  # of a run

# all but as_printed.yaml, which contains what its paper prints, and which the program refuses
DECKS = [str(path.relative_to(CASES)) for path in sorted(CASES.glob("*/*.yaml")) if path.name != "as_printed.yaml"]


def pressed(sets, time, speed):
    """Particle sets of a specimen that approach each other; negative speeds: they part."""
    return {f"bodies.ice.boundary_conditions.{name}.prescribed.z": f"{{times: [0, {time}], velocities: [0, {sign * speed:g}]}}" for name, sign in sets.items()}


BOTH_ENDS = {"top": -1, "bottom": 1}
# as fast as needed, and of weaker material; by the beginning of a deck's name, the later ones in addition
CHANGES = {
    "crack_branching/": {"bodies.glass.boundary_conditions.pull_up.pressure.value": "-1 GPa"},
    "floating_strip/": {"bodies.ice.boundary_conditions.load.body_force.force_density": "[0, 0, -200 MN/m3]"},
    "ice_paddle/": {"impactors.paddle.motion.rz": "{times: [0, 1 ms], velocities: [-400 rad/s, -300 rad/s]}", "impactors.paddle.surface.rotate": "[0, 0, -26 deg]"},
    "ice_specimens/bending.yaml": pressed({"load_left": -1, "load_right": -1}, "2 ms", 1),
    "ice_specimens/brazilian.yaml": pressed(BOTH_ENDS, "1 ms", 0.3),
    "ice_specimens/compression.yaml": pressed(BOTH_ENDS, "1 ms", 0.4),
    "ice_specimens/crushed.yaml": pressed(BOTH_ENDS, "1 ms", 0.4),
    "ice_specimens/tension.yaml": pressed(BOTH_ENDS, "1 ms", -0.2),
    "ice_specimens/punch.yaml": {"bodies.block.boundary_conditions.punch.prescribed.z": "{times: [0, 0.5 ms], velocities: [0, -2]}"},
    **{f"ice_specimens/{deck}.yaml": {"impactors.indenter.velocity": "[2 m/s, 0, 0]"} for deck in ("edge_cylinder", "edge_sphere")},
    "kalthoff_winkler/": {"bodies.plate.material.critical_stretch": 0.001},
    "plate_impact/": {"bodies.plate.material.critical_stretch": 0.001},
    "ship_ice/": {"bodies.sheet.material.flexural_strength": "50 kPa", "impactors.ship.position": "[0.05 m, 0, 0]", "impactors.ship.velocity": "[-20 m/s, 0, 0]"},
    "ship_ice/paper.yaml": {"contact.impactors": "{friction: 0}"},  # rigid: bonds break at once
    "ship_ice/window.yaml": {"bodies.sheet.moving_window": "{follow: ship, start_after: 0 m}"},
    "submarine_surfacing/": {"impactors.submarine.velocity": "[0, 0, 20 m/s]"},
    "uikku_ice/": {"bodies.sheet.material.flexural_strength": "20 kPa", "bodies.sheet.moving_window": "{follow: ship, start_after: 0 m}", "impactors.ship.position": "[0.05 m, 0, 0]"},
    "uikku_ice/free": {"impactors.ship.velocity": "[-300 m/s, 0, 0]"},
    **{f"uikku_ice/{deck}": {"impactors.ship.motion.x": "{times: [0, 1], velocities: [-300 m/s, -300 m/s]}"} for deck in ("deck.yaml", "test_103.yaml", "test_104.yaml", "test_205.yaml", "test_403.yaml")},
}  # fmt: skip


def changes_of(program, deck, updates, cores):
    """With the length of the run."""
    changes = {}
    for beginning, more in CHANGES.items():
        if deck.startswith(beginning):
            changes |= more
    report = programs.run([program, "check", CASES / deck, *programs.changes(changes)], cores)
    step, steps = re.search(r"^\s*step\s+(\S+) s, (\d+) steps", report, re.MULTILINE).groups()
    particles = sum(int(number) for number in re.findall(r"^\s*particles\s+(\d+)", report, re.MULTILINE))
    steps = min(int(steps), STEPS, max(int(updates / particles), 10))
    return changes | {"time.step": step, "time.end": f"{steps * float(step):.9g}", "output.frames": 2, "output.history_interval": f"{5 * float(step):.9g}"}


def run(program, deck, changes, device, out, cores):
    """The report of the run, and its other files by name."""
    programs.run([program, "run", CASES / deck, "--out", out, "--device", device, "--no-report", *programs.changes(changes)], cores, {"OMP_WAIT_POLICY": "passive"})
    return programs.results_of(out)


def compare(program, deck, device, updates, cores):
    """A row of the table, and the files that differ."""
    changes = changes_of(program, deck, updates, cores)
    with tempfile.TemporaryDirectory() as folder:
        scalar, wanted = run(program, deck, changes, "cpu-scalar", Path(folder) / "scalar", cores)
        own, files = run(program, deck, changes, device, Path(folder) / "device", cores)
    unequal = [file for file in wanted.keys() | files.keys() if wanted.get(file) != files.get(file)]
    equal = not unequal and own["state_hash"] == scalar["state_hash"]
    events = {name: "yes" if programs.has_values(wanted["history.csv"], column) else "no"
              for name, column in (("contact", ".contacts [-]"), ("bonds break", ".broken_bonds [-]"), ("yields", ".plastic_dissipation [J]"), ("window moves", ".window_travel [m]"))}  # fmt: skip
    return {"machine": programs.machine(), "deck": deck, "device": own.get("device", device), "steps": own["steps"], **events, "files": len(files), "to cpu-scalar": "equal" if equal else "differs"}, unequal


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("decks", nargs="*", choices=[[], *DECKS], metavar="DECK", help="all by default")
    parser.add_argument("--device", default="cuda", help="device that is compared (default cuda)")
    parser.add_argument("--updates", type=float, default=1e7, help="particle-steps of each run, at most (default 1e7)")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    arguments = parser.parse_args()
    program = arguments.program.resolve()

    idle = queue.SimpleQueue()  # groups of cores
    all_cores = sorted(os.sched_getaffinity(0))
    for first in range(0, max(len(all_cores) - CORES + 1, 1), CORES):
        idle.put(set(all_cores[first : first + CORES]))

    failures = []

    def rows_of(deck):
        cores = idle.get()
        try:
            row, unequal = compare(program, deck, arguments.device, arguments.updates, cores)
        except programs.CannotRun as error:
            failures.append(f"{deck}: {error}")
            return []
        finally:
            idle.put(cores)
        print(*list(row.values())[1:], *unequal[:5], flush=True)
        return [row]

    with concurrent.futures.ThreadPoolExecutor(idle.qsize()) as pool:
        rows = sum(pool.map(rows_of, arguments.decks or DECKS), [])
    if rows:
        programs.write_results(f"gpu equality {rows[0]['device']}", rows)
    if failures:
        raise programs.CannotRun("\n".join(failures))
    return 1 if any(row["to cpu-scalar"] != "equal" for row in rows) else 0


if __name__ == "__main__":
    programs.exit_with(main)
