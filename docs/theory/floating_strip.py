#!/usr/bin/python3
"""Measures how a floating strip of few layers bends and breaks, for floating_strip.md:

    docs/theory/floating_strip.py BINARY [OUTDIR]   runs the decks, writes the two CSV files, figures and the tables of the page
    docs/theory/floating_strip.py                   recreates figures and tables from the CSV files

One run at a time, with one thread. Runs are kept in OUTDIR, and one whose deck is unchanged is not made again. Decks, theory and
measures are those of cases/floating_strip.
"""

import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "cases/floating_strip"))
from measure import Run, bent, broken, compared  # noqa: E402
from theory import Strip  # noqa: E402
from variants import Variant  # noqa: E402

TABLE, CURVES, PAGE = HERE / "floating_strip.csv", HERE / "floating_strip_curves.csv", HERE / "floating_strip.md"
HALF = 107.0  # 4/λ [m]: what costs most is half as long, and compared with a theory of that length

LIFTED = [Variant(n) for n in (3, 4, 6, 8)] + [Variant(12, length=HALF)] + [Variant(n, calibration="z") for n in (3, 4, 6)]
LIFTED += [Variant(n, plate=False) for n in (4, 6)] + [Variant(n, correction="volume") for n in (3, 4, 6)] + [Variant(4, across=8)]
PRESSED = [Variant(3, length=106.0), Variant(4, length=HALF), Variant(4, calibration="z", length=HALF), Variant(6)]
DRAWN = [Variant(3), Variant(4), Variant(6), Variant(4, calibration="z")]


def series(variant):
    kind = ("plate" if variant.plate else "beam") + (f", {variant.across} across" if variant.across != 4 else "")
    return f"{kind}, volume" if variant.correction == "volume" else f"{kind}, calibrated" if variant.calibration != "none" else kind


def decks():
    for variant in LIFTED:
        yield f"lift {variant.name()}", variant, variant.relaxed([-10e3], breaks=False)
    for variant in PRESSED:
        # of six layers the step is 1.5 times the safe estimate, and half the exact limit
        yield f"ramp {variant.name()}", variant, variant.ramp(40e3, 30.0, step=0.24e-3 if variant.layers == 6 else None)


def measure(program, folder):
    rows, curves = [], {}
    for name, variant, deck in decks():
        where = folder / name.replace(" ", "_")
        text, place = json.dumps(deck, indent=1) + "\n", where / "deck.yaml"
        done = where / "out/run.json"
        if not (done.exists() and '"finished"' in done.read_text() and place.read_text() == text):
            where.mkdir(parents=True, exist_ok=True)
            place.write_text(text)
            subprocess.run([program, "run", place, "--out", where / "out", "--force", "--threads", "1"], check=True, stdout=subprocess.DEVNULL)
        run = Run(where / "out")
        keys = {"test": name.split()[0], "series": series(variant), "layers": variant.layers, "length [m]": variant.length}
        if name.startswith("lift"):
            rows += [keys | {"quantity": quantity, "value": value} for quantity, value in compared(run).items()]
            if variant in DRAWN:
                state = bent(run)
                curves[f"{variant.layers} layers" + ", calibrated" * (variant.calibration != "none")] = run.x, state["w"] / run.strip.edge_deflection(state["load"])
        else:
            found, theory = broken(run), run.theory()
            found["first bond over theory"] = found["first bond [N/m]"] / theory.breaking_load(run.at, flooded=True)
            found["first bond over Hetenyi"] = found["first bond [N/m]"] / run.strip.breaking_load
            rows += [keys | {"quantity": quantity, "value": value} for quantity, value in found.items()]
        print(name, flush=True)
    with open(TABLE, "w", newline="") as file:
        table = csv.DictWriter(file, rows[0])
        table.writeheader()
        table.writerows(row | {"value": f"{row['value']:.5g}"} for row in rows)
    places = np.arange(1, 140, 1.5)
    with open(CURVES, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["x [m]", *curves])
        table.writerows([f"{x:g}", *(f"{np.interp(x, *curve):.5f}" for curve in curves.values())] for x in places)


def read():
    """rows[test, series][layers][quantity]"""
    rows = {}
    with open(TABLE, newline="") as file:
        for row in csv.DictReader(file):
            rows.setdefault((row["test"], row["series"]), {}).setdefault(int(row["layers"]), {})[row["quantity"]] = float(row["value"])
    return rows


def percent(ratio):
    return f"{100 * (ratio - 1):+.1f} %".replace("-0.0", "0.0").replace("-", "−")


def bending(rows, name):
    lines = ["| layers | D of the strip/D | edge deflection | largest moment | at [m] | critical stretch first reached at |", "|---|---|---|---|---|---|"]
    for layers, of in sorted(rows["lift", name].items()):
        numbers = [percent(of["edge deflection"]), percent(of["largest moment"]), f"{of['its distance [m]']:.1f}", percent(of["first bond"])]
        lines.append(f"| {layers} | {of['bending stiffness']:.3f} | " + " | ".join(numbers) + " |")
    return lines


def breaking(rows):
    lines = ["| layers | | first bond breaks at | against theory with water on the ice | against 38.7 kN/m | first crack at |", "|---|---|---|---|---|---|"]
    for (test, name), by_layers in rows.items():
        for layers, of in sorted(by_layers.items()):
            if test == "ramp":
                load, distance = of["first bond [N/m]"] / 1e3, of["distance [m]"]
                against = f"{percent(of['first bond over theory'])} | {percent(of['first bond over Hetenyi'])}"
                lines.append(f"| {layers} | {'calibrated' if 'calibrated' in name else ''} | {load:.1f} kN/m | {against} | {distance:.1f} m |")
    return lines[:2] + sorted(lines[2:])


def tables(rows):
    """Writes each table of the page between its two marks: <!-- bending | SERIES --> or <!-- breaking -->, and <!-- end -->."""

    def filled(found):
        words = [word.strip() for word in found[1].split("|")]
        return "\n".join([f"<!-- {found[1]} -->", *(breaking(rows) if words[0] == "breaking" else bending(rows, words[1])), "<!-- end -->"])

    PAGE.write_text(re.sub(r"<!-- ((?:bending|breaking)[^>]*?) -->\n(?:[^<]*?\n)?<!-- end -->", filled, PAGE.read_text()))


def figures(rows):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": 13})
    with open(CURVES, newline="") as file:
        names, *values = csv.reader(file)
    x, *curves = np.array(values, float).T
    strip = Strip()

    figure, axes = plt.subplots(figsize=(10, 5.2), layout="constrained")
    axes.axhline(0, color="0.6", lw=1)
    axes.plot(x, np.exp(-strip.rate * x) * np.cos(strip.rate * x), "k", lw=5, alpha=0.25, label="theory, $e^{-λx}\\cos λx$")
    for name, curve, style in zip(names[1:], curves, ("C3-", "C1-", "C0-", "C2--")):
        axes.plot(x, curve, style, lw=1.8, label=name)
    axes.axvline(strip.breaking_distance, color="0.5", ls=":", lw=1.5)
    axes.annotate("largest moment", (strip.breaking_distance, 1.06), xytext=(6, 0), textcoords="offset points", color="0.35", fontsize=12)
    axes.invert_yaxis()
    axes.set(title="A floating strip under a load on its edge", xlabel="from the edge [m]", ylabel="deflection over 2Pλ/k, down", xlim=(0, 120))
    axes.legend(frameon=False, loc="lower right")
    figure.savefig(HERE / "figures/floating_strip_curve.png", dpi=100)

    figure, axes = plt.subplots(figsize=(10, 5.6), layout="constrained")
    axes.axhspan(0.9, 1.1, color="0.5", alpha=0.12, lw=0)
    axes.axhline(1, color="0.4", lw=1)
    for name, style, label in (("plate", "C0o-", "energy correction"), ("plate, calibrated", "C2s--", "energy correction, bending_calibration"), ("plate, volume", "C1^-", "volume correction")):
        of = sorted(rows.get(("lift", name), {}).items())
        axes.plot([layers for layers, _ in of], [row["first bond"] for _, row in of], style, lw=2, ms=8, label=label)
    pressed = [(layers, row["first bond over theory"]) for (test, name), of in rows.items() for layers, row in of.items() if test == "ramp" and name == "plate"]
    axes.plot(*zip(*sorted(pressed)), "kx", ms=11, mew=2.5, label="pressed down until it broke, over theory with water on the ice")
    axes.annotate("within 10 %", (12, 1.085), ha="right", va="top", color="0.4", fontsize=12)
    axes.set(title="The load that breaks a floating strip, over theory", xlabel="layers of particles", ylabel="breaking load/theory", xticks=(3, 4, 6, 8, 12))
    axes.legend(frameon=False, loc="lower right")
    axes.grid(alpha=0.3)
    figure.savefig(HERE / "figures/floating_strip_layers.png", dpi=100)


def main():
    if len(sys.argv) > 1:
        with tempfile.TemporaryDirectory(prefix="floating-strip-") as scratch:
            measure(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2] if len(sys.argv) > 2 else scratch))
    rows = read()
    tables(rows)
    figures(rows)


main()
