#!/usr/bin/env python3
"""Memory and set-up time of bodies of about a million particles, beside what `perimpact check` reports; writes results/large_<machine>.csv.

    benchmarks/memory/large.py                            about five minutes and 2 GB; nothing else may run meanwhile
    benchmarks/memory/large.py --before PROGRAM           alternates with another build
    benchmarks/memory/large.py --only cloud               bodies whose name contains this

Each run takes one step, without frames. The peak is the largest resident set of the process; the stages are those of run.json. Both programs must end in
the same state.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmarks/plate"), str(ROOT / "benchmarks/memory")]
import memory  # noqa: E402
from programs import machine, write_results  # noqa: E402

STAGES = ("solids and points", "bonds", "surface correction", "time step", "initial forces")
MATERIAL = memory.MATERIAL | {
    "breaking state": memory.MATERIAL["state"] + ", critical_stretch: 0.01",
    "ice": "model: bond-based, youngs_modulus: 1.8 GPa, density: 900, critical_stretch: 3.2e-4, plasticity: {compressive_strength: 2.3 MPa, "
    "failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}",
}
HUNDRED = (lambda f, s: memory.box(s, 100, 100, 100))
BODIES = [
    ("lattice, bond-based", HUNDRED, "elastic", ""),
    ("lattice, state-based", HUNDRED, "state", ""),
    ("lattice, state-based, contact of fragments", HUNDRED, "breaking state", memory.FRAGMENTS),
    ("lattice, correspondence", HUNDRED, "correspondence", ""),
    ("lattice, plastic ice", HUNDRED, "ice", ""),
    ("cloud, state-based, 27 000", (lambda f, s: memory.points(f, s, 30)), "state", ""),
    ("cloud, state-based, 100 000", (lambda f, s: memory.points(f, s, 46)), "state", ""),
]


def measured(program, folder, threads):
    """Reported peak and particles, resident peak [byte], and the report of a run of one step."""
    def settings(frames):
        return ["--threads", str(threads), "--set", "time.end=1e-9 s", "--set", f"output.frames={frames}"]

    check = subprocess.run([program, "check", "deck.yaml", "--json", *settings(0)], cwd=folder, check=True, capture_output=True, text=True)
    said = json.loads(check.stdout)["memory"]
    command = [program, "run", "deck.yaml", "--no-report", "--force", *settings(0)]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL) as process:
        _, status, usage = memory.os.wait4(process.pid, 0)
        process.returncode = memory.os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{program} ended with {process.returncode}")
    return said, 1024 * usage.ru_maxrss, json.loads((folder / "r/run.json").read_text())


def row(name, build, said, peak, report, threads):
    particles, stages = report["bodies"]["b"]["particles"], report["set_up [s]"]
    cells = {"machine": machine(), "body": name, "program": build, "particles": particles, "threads": threads}
    cells |= {"during steps [byte/particle]": f"{said['steps [byte]'] / particles:.0f}", "reported peak [byte/particle]": f"{said['peak [byte]'] / particles:.0f}"}
    cells |= {"resident peak [byte/particle]": f"{peak / particles:.0f}", "resident/reported [-]": f"{peak / said['peak [byte]']:.2f}"}
    cells |= {stage + " [s]": f"{stages.get(stage, 0):.2f}" for stage in STAGES}
    return cells | {"set-up [s]": f"{sum(stages.values()):.2f}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=lambda path: Path(path).resolve(), default=ROOT / "build/release/perimpact")
    parser.add_argument("--before", type=lambda path: Path(path).resolve())
    parser.add_argument("--only", default="", help="bodies whose name contains this")
    parser.add_argument("--size", type=float, default=1, help="share of the particles")
    parser.add_argument("--threads", type=int, default=2)
    given = parser.parse_args()
    rows = []
    memory.MATERIAL = MATERIAL
    for name, body, material, rest in BODIES:
        if given.only not in name:
            continue
        hashes = set()
        with tempfile.TemporaryDirectory() as folder:
            memory.write_deck(Path(folder), given.size, body, material, None, rest)
            for build, program in (("before", given.before), ("perimpact", given.program)):
                if program is None:
                    continue
                said, peak, report = measured(program, Path(folder), given.threads)
                hashes.add(report["state_hash"])
                rows.append(row(name, build, said, peak, report, given.threads))
                print(rows[-1], file=sys.stderr, flush=True)
        if len(hashes) != 1:
            sys.exit(f"{name}: the programs end in different states, so their memory is not comparable.")
    write_results("large", rows)


if __name__ == "__main__":
    main()
