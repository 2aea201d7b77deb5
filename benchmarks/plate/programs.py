"""One timed run of the plate by one program; its output as a dict of numbers."""

import csv
import json
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
DECK = FOLDER.parents[1] / "cases" / "plate_impact" / "deck.yaml"
INPUT = FOLDER / "lammps_plate.in"


class CannotRun(Exception):
    """A missing or failed program, with a remedy."""


def changes(values):
    """The options --set that change these values of a deck."""
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


@dataclass(frozen=True)
class Variant:
    """A variant of the plate for perimpact."""

    family: int  # bonds of an interior particle: 122 or 178
    nu: float
    correction: str
    threads: int = 1
    build: Path = Path()

    @property
    def overrides(self):
        rule = {122: "madenci-oterkus", 178: "hu-ha-bobaru"}[self.family]
        plate = {
            "family": rule,
            "surface_correction": self.correction,
            "material.poissons_ratio": self.nu,
            "material.critical_stretch": 0.5,  # enabled, never reached
        }
        return changes({f"bodies.plate.{key}": value for key, value in plate.items()})


def exit_with(main):
    """Ends the script with the code of main(), or with 2 and a sentence where it cannot run."""
    try:
        sys.exit(main())
    except CannotRun as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(2)


def run(command, cores, environment=None):
    """Standard output of a command, restricted to the given cores."""
    before = os.sched_getaffinity(0)  # of this thread, which the command inherits
    os.sched_setaffinity(0, cores)
    try:
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(command, cwd=folder, env={**os.environ, **(environment or {})}, capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise CannotRun(f"{command[0]} is not installed.") from error
    finally:
        os.sched_setaffinity(0, before)
    if done.returncode:
        raise CannotRun(f"`{' '.join(map(str, command))}` ended with code {done.returncode}:\n{done.stdout[-1000:]}{done.stderr[-1000:]}")
    return done.stdout


def perimpact(variant, steps, cores):
    program = variant.build / "step_benchmark"
    if not program.exists():
        raise CannotRun(f"{program} does not exist; README.md describes how to build it.")
    command = [program, DECK, *variant.overrides, "--threads", str(variant.threads), "--warm-up", str(steps), "--steps", str(steps)]
    (row,) = csv.DictReader(run(command, cores).splitlines())
    if float(row["contacts/step"]) == 0 or float(row["broken_bonds"]) != 0:
        raise CannotRun(f"The run of the plate is invalid (contacts {row['contacts/step']}, broken bonds {row['broken_bonds']}): {variant}")
    return row


# Open MPI refuses root, also for one process
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def mpirun(ranks):
    """The words before a command that run it as so many processes on the cores that it is given; those that wait release their core."""
    return ["mpirun", "--bind-to", "none", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-n", str(ranks)]


def lammps(style, steps, cores, ranks=0):
    """LAMMPS PERI: style pmb or lps; ranks: under mpirun. Raises CannotRun where it is not installed."""
    environment = {"OMP_NUM_THREADS": "1", **AS_ROOT}
    words = ["lmp", "-in", INPUT, "-log", "none", "-var", "style", style, "-var", "steps", str(steps)]
    try:
        log = run((mpirun(ranks) if ranks else []) + words, cores, environment)
    except CannotRun as error:
        raise CannotRun(f"{error} LAMMPS with PERI is the Debian package lammps.") if "not installed" in str(error) else error

    def last(pattern):
        return re.findall(pattern, log)[-1]

    seconds, done_steps, particles = last(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms")
    bonds, speed = last(r"total # of bonds = (\d+)"), int(done_steps) / float(seconds)
    return {
        "particles": particles,
        "steps": done_steps,
        "steps/s": str(speed),
        "directed_bonds/step": bonds,
        "directed_bonds/s": str(int(bonds) * speed),
        "cpu_use": str(float(last(r"([\d.]+)% CPU use")) / 100),
        "compiler": "version " + re.search(r"LAMMPS \((.*)\)", log)[1],
    }


def machine():
    """The processor model, without the host name."""
    text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    field = {key: re.search(rf"^{key}\s*: (.*)$", text, re.MULTILINE) for key in ("model name", "cpu family", "model")}
    if not all(field.values()):
        return os.uname().machine
    return f"{field['model name'][1]} (family {field['cpu family'][1]}, model {field['model'][1]})"


def results_file(kind):
    """The file for results of this kind on this machine."""
    return FOLDER.parent / "results" / (re.sub("[^a-z0-9]+", "_", f"{kind} {machine()}".lower()).strip("_") + ".csv")


def results_of(folder):
    """What a run of perimpact left: the report, and its other files by name, without the checkpoint, which contains times."""
    files = {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
    report = json.loads(files.pop("run.json"))
    files.pop("checkpoint.h5", None)
    return report, files


def has_values(history, column):
    """Whether a column of history.csv (bytes) with this end has other values than 0."""
    rows = csv.DictReader(history.decode().splitlines())
    return any(float(row[name]) != 0 for row in rows for name in row if name.endswith(column))


def write_results(kind, rows):
    """Writes the rows (dictionaries with the same keys, the first of them the machine) to results_file, and prints them as a table without the machine."""
    with open(results_file(kind), "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    for line in ([*rows[0]], ["---"] * len(rows[0]), *(list(row.values()) for row in rows)):
        print("| " + " | ".join(str(cell) for cell in line[1:]) + " |")
