#!/usr/bin/env python3
"""Times the stages from a surface file to queries, and reading against assimp and meshio, on one core.

    benchmarks/surface/measure.py             some minutes; nothing else may run meanwhile
    benchmarks/surface/measure.py --tables    no measurement: rewrites the tables

Writes results/surface_<machine>.csv and the tables of README.md. Exit code 1: a claim is not met. 2: something is missing.
"""

import argparse
import csv
import io
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import report

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/plate"))
from programs import machine, results_file  # noqa: E402

EXAMPLES = Path("/usr/share/doc/openfoam-examples/examples")
REAL = ["buildings.obj", "motorBike.obj", "DTC-scaled.stl", "propellerTip.obj", "bullet.stl", "wigley.stl"]
OF_ASSIMP = ["stl", "ascii.stl", "obj", "ply", "off"]
OF_MESHIO = {"stl": "stl", "ascii.stl": "stl", "obj": "obj", "ply": "ply", "off": "off", "vtk": "vtk", "msh": "gmsh", "inp": "abaqus"}


def missing(what):
    print(f"error: {what}", file=sys.stderr)
    sys.exit(2)


def stages_of(*command):
    """The CSV output of a program, run on one core."""
    core = max(os.sched_getaffinity(0))  # not the first core, which handles interrupts
    done = subprocess.run(
        [*map(str, command)], capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"}, preexec_fn=lambda: os.sched_setaffinity(0, {core})
    )  # fmt: skip
    if done.returncode:
        missing(f"`{' '.join(map(str, command))}` ended with code {done.returncode}: {done.stderr[-500:]}")
    return list(csv.DictReader(io.StringIO(done.stdout)))


def runs(build, files):
    """(program, file, format, command) of all timed runs."""
    stages, assimp = build / "surface_stages", build / "assimp_read"
    for program in (stages, assimp):
        if not program.exists():
            missing(f"{program} is not there; README.md says how to build it.")
    for name in REAL:
        found = next(EXAMPLES.rglob(f"{name}.gz"), None) or missing("openfoam-examples is not installed.")
        yield "perimpact", name, name.rsplit(".", 1)[-1], [stages, found, "--rounds", 1]
    for kind, file in files.items():
        yield "perimpact", "sphere", kind, [stages, file, "--rounds", 1, *([] if kind == "stl" else ["--only-read"])]
        if kind in OF_ASSIMP:
            yield "assimp", "sphere", kind, [assimp, file, "--rounds", 1]
            yield "assimp", "sphere", kind, [assimp, file, "--rounds", 1, "--join"]
        if kind in OF_MESHIO:
            yield "meshio", "sphere", kind, ["/usr/bin/python3", "-B", Path(__file__).parent / "meshio_read.py", file, OF_MESHIO[kind]]


def measure(build, rounds):
    """Rows of medians; in each round all programs alternate."""
    try:
        import million
    except ImportError as error:
        missing(f"{error}: Debian's python3-meshio and python3-numpy.")
    times = {}
    with tempfile.TemporaryDirectory(prefix="perimpact-") as folder:
        files = million.write(Path(folder))
        for round in range(rounds):
            for program, file, kind, command in runs(build, files):
                for row in stages_of(*command):
                    times.setdefault((program, file, kind, row["stage"]), []).append((float(row["seconds"]), float(row["memory_mib"])))
            print(f"round {round + 1} of {rounds} done", flush=True)
        sizes = {kind: file.stat().st_size for kind, file in files.items()}
    return [
        {
            "machine": machine(), "program": program, "file": file, "format": kind, "file_mib": f"{sizes[kind] / 2**20:.3g}" if file == "sphere" else "",
            "stage": stage, "seconds": f"{statistics.median(s for s, _ in values):.4g}", "least": f"{min(values)[0]:.4g}", "most": f"{max(values)[0]:.4g}",
            "memory_mib": f"{statistics.median(m for _, m in values):.4g}", "rounds": rounds,
        }
        for (program, file, kind, stage), values in times.items()
    ]  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", help="build folder (default: build/release)")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--tables", action="store_true", help="write the tables from the CSV files without measuring")
    arguments = parser.parse_args()
    if not arguments.tables:
        report.write(measure(arguments.build.resolve(), arguments.rounds), results_file("surface"))
    report.update_readme()
    claims = report.claims()
    for what, wanted, shown, met in claims:
        print(f"{'met    ' if met else 'NOT MET'} {what}: {shown}, wanted {wanted}")
    return 0 if all(met for *_, met in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
