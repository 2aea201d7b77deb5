#!/usr/bin/python3
"""How strips of few layers crack as the load grows beyond the first broken bond: cracks.py BINARY OUTDIR

Runs ramps of 60 kN/m in 30 s of calibrated strips with several horizons, four at a time with one thread each, and prints the table of
docs/theory/floating_strip.md: the load at the first frame with a broken bond, that at the first with a crack through the strip, and over which length bonds
of a layer are broken in the frame before the latter. A frame is 0.2 kN/m. A finished run in OUTDIR is not made again.
"""

import argparse
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "../../scripts/results")]
from strip_crack import BROKEN, is_through  # noqa: E402
from variants import Variant  # noqa: E402
from vtp_reader import read_vtp, series  # noqa: E402

LOAD, END, FRAMES = 60e3, 30.0, 300  # [N/m] [s]
STRIPS = [(3, 3.015, "none"), (3, 3.015, "z"), (3, 2.5, "z"), (3, 2.015, "z"), (4, 3.015, "z"), (4, 2.015, "z")]


def deck_of(layers, horizon_ratio, calibration):
    deck = Variant(layers, calibration=calibration, length=106.0 if layers == 3 else 107.0).ramp(LOAD, END)
    deck["output"]["frames"] = FRAMES
    deck["bodies"]["ice"]["horizon_ratio"] = horizon_ratio
    return deck


def run(program, folder, deck):
    if not (folder / "out/run.json").exists():
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "deck.yaml").write_text(json.dumps(deck, indent=1) + "\n")
        command = [program, "run", folder / "deck.yaml", "--out", folder / "out", "--force", "--threads", "1", "--no-report"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def measured(folder, deck):
    """[N/m] load at the first broken bond, and as a crack is through; [m] length with broken bonds before that."""
    load = deck["bodies"]["ice"]["boundary_conditions"]["load"]["body_force"]
    first, before = None, 0.0
    for time, file in series(folder / "out", "ice"):
        frame = read_vtp(file)
        reference, damage = frame.points - frame.point["displacement"], frame.point["damage"]
        if damage.max() == 0:
            continue
        applied = LOAD * float(np.interp(time, load["times"], load["factors"]))
        first = applied if first is None else first
        if is_through(reference[:, 0], reference[:, 2], damage, deck["bodies"]["ice"]["spacing"]):
            return first, applied, before
        broken = reference[damage > BROKEN, 0]
        before = np.ptp(broken) if len(broken) else 0.0
    return first, float("nan"), before


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program", metavar="BINARY", type=Path)
    arguments.add_argument("out", metavar="OUTDIR", type=Path)
    given = arguments.parse_args()
    program, out = given.program.resolve(), given.out
    strips = {strip: (out / "{}_layers_{}_{}".format(*strip), deck_of(*strip)) for strip in STRIPS}
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda one: run(program, *one), strips.values()))
    print("| layers | horizon, spacings | | first bond | crack through all layers | bonds broken before, over |\n|---|---|---|---|---|---|")
    for (layers, horizon_ratio, calibration), one in strips.items():
        first, through, length = measured(*one)
        print(f"| {layers} | {horizon_ratio} | {'calibrated' if calibration == 'z' else ''} | {first / 1e3:.1f} kN/m | {f'{through / 1e3:.1f} kN/m' if through == through else 'none'} | {length:.0f} m |")


if __name__ == "__main__":
    main()
