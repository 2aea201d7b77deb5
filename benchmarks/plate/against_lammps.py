#!/usr/bin/env python3
"""Times the plate with perimpact and with LAMMPS PERI alternately; writes results/plate_<machine>.csv and the tables of README.md.

    benchmarks/plate/against_lammps.py                        about five minutes on an idle machine
    benchmarks/plate/against_lammps.py --also build/avx2      also times a build for another instruction set
    benchmarks/plate/against_lammps.py --tables               no measurement: rewrites the tables of README.md

Each round runs every variant once, perimpact and LAMMPS successively on the same core. Ratios are taken within a round; results are
medians over the rounds, with minimum and maximum. Exit code 1: a claim is not met. 2: something is missing.
"""

import argparse
import os
import statistics
import sys
from pathlib import Path

import programs
import report
from programs import Variant

ROOT = Path(__file__).resolve().parents[2]
PEER = {0.25: "pmb", 0.3: "lps"}  # Poisson's ratio: style of LAMMPS PERI
NUMBERS = ["steps/s", "directed_bonds/s", "root_and_division/s", "share_of_core", "predict", "contact", "forces", "monitors", "contacts/step", "cpu_use"]


def variants(build, others, cores):
    """All variants of a round, in order; a style denotes a run of LAMMPS."""
    order = []
    for nu, style in PEER.items():
        order += [Variant(122, nu, "energy", 1, build), style]
        if len(cores) > 1:
            order.append(Variant(122, nu, "energy", 2, build))
    order += [Variant(122, nu, correction, 1, build) for nu in PEER for correction in ("volume", "none")]
    order += [Variant(178, nu, correction, 1, build) for nu in PEER for correction in ("energy", "volume")]
    order += [Variant(family, nu, "energy", 1, other) for other in others for family in (122, 178) for nu in PEER]
    return order


def measure(what, steps, cores):
    if isinstance(what, str):
        return programs.lammps(what, steps["lammps"], {cores[0]})
    return programs.perimpact(what, steps["perimpact"], set(cores[: what.threads]))


def base_of(what):
    """The baseline of a variant: one thread for two, LAMMPS for the family that both have."""
    if isinstance(what, str):
        return None
    if what.threads > 1:
        return Variant(what.family, what.nu, what.correction, 1, what.build)
    return PEER[what.nu] if what.family == 122 else None


def name_of(base):
    return "" if base is None else f"peri/{base}" if isinstance(base, str) else "1 thread"


def summary(machine, what, rounds):
    """One row of the CSV from all rounds."""
    own = [measured[what] for measured in rounds]
    row = {"machine": machine, "rounds": len(rounds), "steps": own[0]["steps"], "threads": 1, "compiler": own[0]["compiler"]}
    if isinstance(what, str):
        nu = next(nu for nu, style in PEER.items() if style == what)
        row |= {"program": f"LAMMPS peri/{what}", "family": 122, "nu": nu, "correction": "none"}
    else:
        row |= {"program": "perimpact", "family": what.family, "nu": what.nu, "correction": what.correction}
        row |= {"threads": what.threads, "isa": own[0]["isa"]}
    for column in NUMBERS:
        values = [float(one[column]) for one in own if column in one]
        if values:
            row[column] = f"{statistics.median(values):.4g}"
    speeds = [float(one["steps/s"]) for one in own]
    row |= {"steps/s_min": f"{min(speeds):.4g}", "steps/s_max": f"{max(speeds):.4g}"}
    base = base_of(what)
    if base is not None:
        ratios = [float(measured[what]["steps/s"]) / float(measured[base]["steps/s"]) for measured in rounds]
        row |= {"ratio": f"{statistics.median(ratios):.4g}", "ratio_min": f"{min(ratios):.4g}", "ratio_max": f"{max(ratios):.4g}"}
    row["against"] = name_of(base)
    return row


def check_same_problem(rounds):
    """Checks that LAMMPS has the same particles and, with the smaller family, the same bonds."""
    for measured in rounds:
        same = {(one["particles"], one["directed_bonds/step"]) for what, one in measured.items() if isinstance(what, str) or what.family == 122}
        if len(same) != 1:
            raise programs.CannotRun(f"The two programs do not compute the same plate (particles, directed bonds): {sorted(same)}")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", help="build folder (default: build/release)")
    parser.add_argument("--also", type=Path, action="append", default=[], help="a further build folder, for another instruction set")
    parser.add_argument("--rounds", type=int, default=3, help="number of rounds (default 3)")
    parser.add_argument("--steps", type=int, default=50, help="timed steps of perimpact, after as many warm-up steps (default 50)")
    parser.add_argument("--lammps-steps", type=int, default=12, help="timed steps of LAMMPS (default 12)")
    parser.add_argument("--tables", action="store_true", help="write the tables of README.md from the CSV files without measuring")
    return parser.parse_args()


def main():
    arguments = parse()
    if arguments.tables:
        report.update_readme()
        return 0
    cores = sorted(os.sched_getaffinity(0), reverse=True)[:2]  # not the first core, which handles interrupts
    steps = {"perimpact": arguments.steps, "lammps": arguments.lammps_steps}
    order = variants(arguments.build.resolve(), [build.resolve() for build in arguments.also], cores)
    machine = programs.machine()
    print(f"{machine}: {arguments.rounds} rounds on core {cores[0]}", flush=True)

    rounds = []
    for index in range(arguments.rounds):
        rounds.append({})
        for what in order:
            rounds[-1][what] = one = measure(what, steps, cores)
            label = f"peri/{what}" if isinstance(what, str) else f"{what.family} bonds, ν = {what.nu}, {what.correction}, {what.threads} threads, {one['isa']}"
            print(f"round {index + 1}  {label:<50}{float(one['steps/s']):8.2f} steps/s, {100 * float(one['cpu_use']):.0f} % of the core", flush=True)
    check_same_problem(rounds)

    rows = [summary(machine, what, rounds) for what in order]
    path = programs.results_file("plate")
    report.write(rows, path)
    report.update_readme()
    claims = report.claims(report.read(path))
    for what, wanted, shown, met in claims:
        print(f"{'met    ' if met else 'NOT MET'} {what}: {shown}, wanted {wanted}")
    print(f"Results: {path.relative_to(ROOT)} and benchmarks/README.md")
    return 0 if all(met for *_, met in claims) else 1


if __name__ == "__main__":
    programs.exit_with(main)
