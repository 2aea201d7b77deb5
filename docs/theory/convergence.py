#!/usr/bin/python3
"""Measures how results of the whole program approach exact solutions, for convergence.md:

    docs/theory/convergence.py BINARY [OUTDIR]    runs the decks, writes convergence.csv, the figures and the tables of the page
    docs/theory/convergence.py                    recreates figures and tables from convergence.csv

Two runs at a time, each with one thread. Runs are kept in OUTDIR, and one whose deck is unchanged is not made again.
Decks, exact solutions and what is compared are those of tests/cases/convergence/problems.py.
"""

import csv
import json
import re
import resource
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from math import log
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tests/cases/convergence"))
from problems import HEIGHT, PROBLEMS, Body, Result, lattice_moduli  # noqa: E402

TABLE, PAGE = HERE / "convergence.csv", HERE / "convergence.md"
SIZE = {"hole": 1.0, "pulse": 0.025, "step": 0.025}  # what the layers divide: radius, height of the bar [m]

SPACE, PLANE = {"plane": "none"}, {"plane": "stress"}
NU_25 = {"poisson": 0.25}
CORRESPONDENCE, LPS = {"model": "correspondence"}, {"model": "linear-peridynamic-solid"}
BOND_BASED_PLANE = {"model": "bond-based", "poisson": 1 / 3, "plane": "stress"}


def series():
    """What is measured: (problem, series, bodies), each series with one thing that changes."""
    coarse, fine, plane = (4, 6, 8, 12), (4, 6, 8, 12, 16), (4, 8, 16, 32)
    around = (4, 6, 8, 12, 16, 24, 32)

    def add(problem, name, layers, **keys):
        every.append((problem, name, [Body(n, **keys) for n in layers]))

    every = []
    for problem in ("bar", "block", "pulse", "step", "cantilever", "three_points"):
        add(problem, "3-D, ν = 0.3", fine if problem == "bar" else coarse, **SPACE)
        add(problem, "plane stress, ν = 0.3", plane, **PLANE)
    for problem in ("bar", "pulse", "cantilever", "three_points"):
        add(problem, "3-D, ν = 0.25", coarse if problem in ("bar", "pulse") else (4, 6, 8), **NU_25)
    for problem in ("bar", "cantilever"):
        add(problem, "3-D, correspondence, ν = 0.3", (4, 6, 8), **CORRESPONDENCE)
        add(problem, "3-D, LPS, ν = 0.3", (4, 6, 8) if problem == "bar" else (4, 6), **LPS)
    for problem in ("bar", "cantilever", "pulse", "hole"):
        some = (4, 8, 16) if problem in ("cantilever", "hole") else plane  # the longest runs
        add(problem, "plane stress, correspondence, ν = 0.3", plane, **PLANE, **CORRESPONDENCE)
        add(problem, "plane stress, LPS, ν = 0.3", some, **PLANE, **LPS)
        add(problem, "plane stress, bond-based, ν = 1/3", some, **BOND_BASED_PLANE)
    for problem in ("cantilever", "hole"):
        add(problem, "plane stress, correspondence, ν = 0.3, stabilisation 0.1", (4, 8, 16), stabilisation=0.1, **PLANE, **CORRESPONDENCE)
    add("hole", "plane stress, ν = 0.3", around, **PLANE)
    add("hole", "plane stress, ν = 0.3, m = 4", (4, 8, 16, 24), horizon=4, **PLANE)
    add("cantilever", "plane stress, ν = 0.3, m = 2", (4, 8, 16), horizon=2, **PLANE)
    for problem in ("bar", "cantilever"):
        for correction in ("volume", "none"):
            add(problem, f"3-D, ν = 0.3, correction {correction}", (4, 6, 8) if problem == "bar" else (4, 6), correction=correction)
            add(problem, f"plane stress, ν = 0.3, correction {correction}", plane if problem == "bar" else (4, 8, 16), correction=correction, **PLANE)
    for correction in ("volume", "none"):
        add("hole", f"plane stress, ν = 0.3, correction {correction}", (4, 8, 16), correction=correction, **PLANE)
    add("bar", "plane stress, ν = 0.3, m = 5", plane, horizon=5, **PLANE)
    for problem in ("bar", "pulse", "cantilever", "hole"):  # δ fixed: a quarter of the height, or of the radius
        every.append((problem, "plane stress, ν = 0.3, δ = H/4", [Body(4 * m, horizon=m, **PLANE) for m in (2, 3, 4, 5)]))
        every.append((problem, "plane stress, ν = 0.3, H/Δ = 16", [Body(16, horizon=m, **PLANE) for m in (2, 3, 4, 5)]))
    every.append(("hole", "plane stress, correspondence, ν = 0.3, δ = H/4", [Body(4 * m, horizon=m, **PLANE, **CORRESPONDENCE) for m in (2, 3, 4, 5)]))
    every.append(("bar", "3-D, ν = 0.3, δ = H/3", [Body(3 * m, horizon=m) for m in (2, 3, 4)]))
    return every


# -- runs -------------------------------------------------------------------------------------------------------------


def cost(problem, body):
    """About what a run takes, to begin with the shortest: what is wrong shows early."""
    size = body.layers**2 * (1 if body.plane != "none" else body.layers * body.horizon)
    return size * body.horizon**2 * body.layers * {"hole": 20, "pulse": 4, "step": 4, "cantilever": 60, "three_points": 30}.get(problem, 4)


def measure(program, folder):
    def run(name, deck):
        where = folder / re.sub(r"[^\w.=-]+", "_", name)
        text = json.dumps(deck, indent=1) + "\n"  # JSON is YAML
        place = where / "deck.yaml"
        if not (where / "out/run.json").exists() or place.read_text() != text:
            where.mkdir(parents=True, exist_ok=True)
            place.write_text(text)
            subprocess.run([program, "run", place, "--out", where / "out", "--force", "--threads", "1"], check=True, stdout=subprocess.DEVNULL)
        return Result(where / "out")

    def one(job):
        problem, body = job
        result, errors = PROBLEMS[problem](body, run)
        print(f"{result.report['wall_time [s]']:6.1f} s  {problem} {body.name()}", flush=True)
        return job, (result.particles, errors)

    jobs = {(problem, body) for problem, _, bodies in series() for body in bodies}
    with ThreadPoolExecutor(2) as pool:
        results = dict(pool.map(one, sorted(jobs, key=lambda job: cost(*job))))
    print(f"{resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime:.0f} s of processor time in {len(jobs)} runs")
    return results


def order(body, error, before):
    """How the error falls with the spacing, between two rows; where the spacing is the same or the sign changes there is none."""
    if before is None or before[0].layers == body.layers or error * before[1] <= 0:
        return ""
    return f"{log(abs(before[1] / error)) / log(body.layers / before[0].layers):.2f}"


def write(results):
    with open(TABLE, "w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["problem", "series", "layers", "spacing [m]", "horizon ratio", "horizon [m]", "particles", "quantity", "error", "order"])
        for problem, name, bodies in series():
            for quantity in results[problem, bodies[0]][1]:
                before = None
                for body in bodies:
                    particles, errors = results[problem, body]
                    spacing, error = SIZE.get(problem, HEIGHT) / body.layers, errors[quantity]
                    shown = [f"{spacing:.6g}", f"{body.horizon:g}", f"{body.horizon * spacing:.6g}", particles, quantity, f"{error:.4e}", order(body, error, before)]
                    rows.writerow([problem, name, body.layers, *shown])
                    before = body, error


# -- tables and figures -----------------------------------------------------------------------------------------------


def read():
    """rows[problem, series][quantity]: list of rows"""
    rows = {}
    with open(TABLE, newline="") as file:
        for row in csv.DictReader(file):
            rows.setdefault((row["problem"], row["series"]), {}).setdefault(row["quantity"], []).append(row)
    return rows


NORMS = ("field", "love")


def signed(number, digits):
    text = f"{number:+.{digits}f}"
    return ("0" if float(text) == 0 else text.replace("-", "−")) + " %"


def percent(row):
    error = 100 * float(row["error"])
    digits = 1 if abs(error) >= 10 else 2 if abs(error) >= 0.1 else 3
    return f"{error:.{digits}f} %" if row["quantity"] in NORMS else signed(error, digits)


def table(rows, problem, name, quantities):
    """A row a run: error, and order from the row before."""
    of = rows[problem, name]
    cells = [f"{q} | order" for q in quantities]
    lines = [f"| layers | spacing [mm] | m | particles | {' | '.join(cells)} |", "|---" * (4 + 2 * len(quantities)) + "|"]
    for i, first in enumerate(of[quantities[0]]):
        values = [f"{percent(of[q][i])} | {of[q][i]['order'].replace('-', '−') or '–'}" for q in quantities]
        spacing = f"{1000 * float(first['spacing [m]']):.4g}"
        lines.append(f"| {first['layers']} | {spacing} | {first['horizon ratio']} | {int(first['particles']):,} | ".replace(",", " ") + " | ".join(values) + " |")
    return lines


def comparison(rows, problem, names, quantity):
    """A row a series: the error at each number of layers, and the order of the last."""
    layers = [row["layers"] for row in rows[problem, names[0]][quantity]]
    lines = [f"| {quantity} | " + " | ".join(f"{n} layers" for n in layers) + " | last order |", "|---" * (len(layers) + 2) + "|"]
    for name in names:
        of = {row["layers"]: row for row in rows[problem, name][quantity]}
        lines.append(f"| {name} | " + " | ".join(percent(of[n]) if n in of else "" for n in layers) + f" | {[*of.values()][-1]['order'].replace('-', '−') or '–'} |")
    return lines


def horizons(rows, name, columns):
    """A row a horizon ratio; columns are "problem quantity"."""
    columns = [column.split() for column in columns]
    lists = [rows[problem, name][quantity] for problem, quantity in columns]
    lines = ["| m | layers | " + " | ".join(f"{p}: {q}" for p, q in columns) + " |", "|---" * (2 + len(columns)) + "|"]
    for of in zip(*lists):
        lines.append(f"| {of[0]['horizon ratio']} | {of[0]['layers']} | " + " | ".join(percent(row) for row in of) + " |")
    return lines


def moduli():
    """What is left of ν and µ inside a lattice, less 1."""
    kinds = [(plane, poisson) for plane in ("none", "stress") for poisson in (0.25, 0.3)]
    heads = [f"{'3-D' if plane == 'none' else 'plane stress'}, ν = {poisson}: {what}" for plane, poisson in kinds for what in "νµ"]
    lines = ["| m | " + " | ".join(heads) + " |", "|---" * (1 + len(heads)) + "|"]
    for m in (2, 3, 3.015, 4, 5, 6):
        found = [lattice_moduli(m, poisson, plane) for plane, poisson in kinds]
        assert all(abs(of["E"] - 1) < 0.001 for of in found)  # as the page says
        lines.append(f"| {m:g} | " + " | ".join(signed(100 * (of[what] - 1), 1) for of in found for what in "νµ") + " |")
    return lines


def tables(rows):
    """Writes each table of the page between its two marks: <!-- KIND | … --> and <!-- end -->."""
    kinds = {
        "table": lambda problem, name, *quantities: table(rows, problem, name, quantities),
        "comparison": lambda problem, quantity, *names: comparison(rows, problem, names, quantity),
        "horizons": lambda name, *columns: horizons(rows, name, columns),
        "moduli": moduli,
    }

    def filled(found):
        kind, *words = (word.strip() for word in found[1].split("|"))
        return "\n".join([f"<!-- {found[1]} -->", *kinds[kind](*words), "<!-- end -->"])

    PAGE.write_text(re.sub(r"<!-- ([^>]*?) -->\n(?:[^<]*?\n)?<!-- end -->", filled, PAGE.read_text()))


FIGURES = {
    "convergence_bar": (
        "A bar in tension: what surface corrections leave of a first-order error",
        "strain",
        "one over the layers through the height",
        (1, 2),
        [
            ("bar", "3-D, ν = 0.3", "energy correction, 3-D"),
            ("bar", "plane stress, ν = 0.3", "energy correction, plane stress"),
            ("bar", "plane stress, ν = 0.3, correction volume", "volume correction, plane stress"),
            ("bar", "plane stress, ν = 0.3, correction none", "no correction, plane stress"),
            ("bar", "plane stress, LPS, ν = 0.3", "linear peridynamic solid, plane stress"),
        ],
    ),
    "convergence_contraction": (
        "Contraction of a bar in tension: it goes to that of the lattice, which m sets",
        "contraction",
        "one over the layers through the height",
        (1,),
        [
            ("bar", "3-D, ν = 0.3", "3-D"),
            ("bar", "plane stress, ν = 0.3", "plane stress"),
            ("bar", "plane stress, ν = 0.3, m = 5", "plane stress, m = 5"),
        ],
    ),
    "convergence_pulse": (
        "A pulse that has run through 0.7 of a bar: displacements",
        "love",
        "one over the layers through the height",
        (1, 2),
        [
            ("pulse", "3-D, ν = 0.3", "3-D"),
            ("pulse", "plane stress, ν = 0.3", "plane stress"),
            ("pulse", "plane stress, correspondence, ν = 0.3", "correspondence, plane stress"),
            ("pulse", "plane stress, LPS, ν = 0.3", "linear peridynamic solid, plane stress"),
        ],
    ),
    "convergence_cantilever": (
        "Stiffness EI of a cantilever: of second order with the energy correction",
        "stiffness",
        "one over the layers through the height",
        (1, 2),
        [
            ("cantilever", "3-D, ν = 0.3", "energy correction, 3-D"),
            ("cantilever", "plane stress, ν = 0.3", "energy correction, plane stress"),
            ("cantilever", "plane stress, ν = 0.3, m = 2", "the same, m = 2"),
            ("cantilever", "plane stress, ν = 0.3, correction none", "no correction, plane stress"),
            ("cantilever", "plane stress, correspondence, ν = 0.3", "correspondence, plane stress"),
        ],
    ),
    "convergence_hole": (
        "Displacements of a plate with a hole: m says where they stop",
        "field",
        "one over the spacings in the hole's radius",
        (1,),
        [
            ("hole", "plane stress, ν = 0.3", "ordinary-state, m = 3.015"),
            ("hole", "plane stress, ν = 0.3, m = 4", "ordinary-state, m = 4"),
            ("hole", "plane stress, correspondence, ν = 0.3", "correspondence, m = 3.015"),
        ],
    ),
}


def figures(rows):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": 13})
    for name, (title, quantity, along, slopes, curves) in FIGURES.items():
        figure, axes = plt.subplots(figsize=(10, 7.5))
        for (problem, which, label), marker in zip(curves, "osD^v"):
            of = rows[problem, which][quantity]
            axes.loglog([1 / int(row["layers"]) for row in of], [100 * abs(float(row["error"])) for row in of], marker=marker, lw=2, ms=8, label=label)
        layers = sorted({int(row["layers"]) for problem, which, _ in curves for row in rows[problem, which][quantity]})
        if quantity == "contraction":
            for m, color in ((3.015, "C1"), (5, "C2")):
                limit = 100 * abs(lattice_moduli(m, 0.3, "stress")["ν"] - 1)
                axes.axhline(limit, color=color, ls=":")
                axes.annotate(f"ν of the lattice, m = {m:g}", (1 / layers[-1], limit), ha="right", xytext=(0, -18), textcoords="offset points", fontsize=12, color=color)
        bottom, top = axes.get_ylim()
        for slope in slopes:  # from the upper left corner down
            end = 1.3 * top * (layers[0] / layers[-1]) ** slope
            axes.loglog([1 / layers[0], 1 / layers[-1]], [1.3 * top, end], color="0.6", ls="--", lw=1.2)
            axes.annotate(f"order {slope}", (1 / layers[-1], end), xytext=(0, 14), textcoords="offset points", color="0.4", ha="right", fontsize=12)
        axes.set_ylim(bottom, 1.5 * top)
        axes.invert_xaxis()
        axes.set_xticks([1 / n for n in layers], [f"1/{n}" for n in layers])
        levels = [digit * 10.0**power for power in range(-3, 4) for digit in (1, 2, 5)]
        axes.set_yticks(levels := [level for level in levels if bottom < level < 1.5 * top], [f"{level:g}" for level in levels])
        axes.minorticks_off()
        axes.set(title=title, xlabel=f"spacing: {along}", ylabel="size of the error [%]")
        axes.grid(alpha=0.3)
        figure.legend(*axes.get_legend_handles_labels(), loc="lower center", ncols=2, fontsize=12, frameon=False)
        figure.tight_layout(rect=(0, 0.035 * ((len(curves) + 1) // 2) + 0.01, 1, 1))
        figure.savefig(HERE / f"figures/{name}.png", dpi=100)
        plt.close(figure)


def main():
    if len(sys.argv) > 1:
        program = str(Path(sys.argv[1]).resolve())
        with tempfile.TemporaryDirectory(prefix="convergence-") as scratch:
            write(measure(program, Path(sys.argv[2] if len(sys.argv) > 2 else scratch)))
    rows = read()
    if PAGE.exists():
        tables(rows)
    figures(rows)


main()
