#!/usr/bin/env python3
"""Size of output frames and time to write them, whole and thinned, in both formats; writes results/frames_<machine>.csv and prints it as a table.

    benchmarks/frames/thinned.py                  about five minutes; nothing else may run meanwhile

The plate and the icebreaker of cases/, shortened. The time is the processor time of the run less that of a run without frames, per frame of all bodies and
impactors, whose surfaces are not thinned. The size is that of the files of the bodies. All runs of a deck must end in the same state.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/plate"))
from programs import machine, write_results  # noqa: E402

DECKS = {
    "plate": ("cases/plate_impact/deck.yaml", ["time.end=2 us", "output.frames=10"]),
    "icebreaker": ("cases/ship_ice/deck.yaml", ["time.end=0.22 s", "output.frames=10"]),
}
BOX = {"plate": "{lower: [-1, -0.02, -1], upper: [1, 1, 1]}", "icebreaker": "{lower: [-8, -10, -10], upper: [0, 10, 10]}"}
FEW = "frame_fields=[damage]"
SELECTIONS = {
    "all particles, all fields": [],
    "damage only": [FEW],
    "surface": ["frame_particles={surface: true}"],
    "every fourth": ["frame_particles={stride: 4}"],
    "box": ["frame_particles={boxes: {near: BOX}}"],
    "damage above 0.1": ["frame_particles={damage_above: 0.1}"],
    "surface and damage above 0.1, damage only": ["frame_particles={surface: true, damage_above: 0.1}", FEW],
}


def run(program, deck, settings):
    with tempfile.TemporaryDirectory() as folder:
        words = [word for setting in settings for word in ("--set", setting)]
        command = [program, "run", ROOT / deck, "--out", folder, "--force", "--no-report", "--quiet", "--threads", "1", *words]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{program} ended with {process.returncode}")
        report = json.loads((Path(folder) / "run.json").read_text())
        bodies = [file for name in report["bodies"] for file in Path(folder).glob(f"frames/{name}*") if file.suffix != ".pvd"]
        return report, sum(file.stat().st_size for file in bodies), usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=lambda path: Path(path).resolve(), default=ROOT / "build/release/perimpact")
    parser.add_argument("--only", default="", help="decks whose name contains this")
    given = parser.parse_args()
    rows = []
    for name, (deck, settings) in DECKS.items():
        if given.only not in name:
            continue
        report, _, without = run(given.program, deck, [*settings, "output.frames=0"])
        hashes = {report["state_hash"]}
        for selection, keys in SELECTIONS.items():
            row = {"machine": machine(), "run": name, "particles": sum(body["particles"] for body in report["bodies"].values()), "written": selection}
            for form in ("vtp", "vtkhdf"):
                frames = 1 + int(settings[-1].split("=")[1])
                report, size, used = run(given.program, deck, [*settings, f"output.frame_format={form}", *(f"output.{key.replace('BOX', BOX[name])}" for key in keys)])
                hashes.add(report["state_hash"])
                row |= {f"{form} [kB/frame]": f"{size / frames / 1000:.1f}", f"{form} [ms/frame]": f"{1000 * (used - without) / frames:.1f}"}
            rows.append(row)
            print(row, file=sys.stderr, flush=True)
        if len(hashes) != 1:
            sys.exit(f"{name}: the runs end in different states.")
    write_results("frames", rows)


if __name__ == "__main__":
    main()
