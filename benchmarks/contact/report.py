"""Results of the contact benchmarks: CSV files, tables of benchmarks/README.md, the figure of the docs."""

import csv
import math
from pathlib import Path

BENCHMARKS = Path(__file__).resolve().parents[1]
README = BENCHMARKS / "README.md"
RESULTS = BENCHMARKS / "results"
BEGIN, END = "<!-- contact: written by contact/measure.py -->\n", "<!-- end of contact -->\n"
ORDERS = {"random": [], "of triangles": ["--in-order"]}  # of the points of crossing_cost
KINDS = ("cost", "queries", "share", "deforming", "crossing")
METHODS = ["all panels", "box then all panels", "box then bvh", "swept"]


def write(rows, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read(kind):
    """Rows of all machines."""
    rows = []
    for path in sorted(RESULTS.glob(f"contact_{kind}_*.csv")):
        with open(path, newline="", encoding="utf-8") as file:
            rows += list(csv.DictReader(file))
    return rows


def nanoseconds(row):
    return float(row["ns/particle/step"])


def is_counted(row):
    """Whether the row was timed on a sample of the particles in the box."""
    return row["method"] in ("all panels", "box then all panels")


def deforming_claims(machine):
    """The same of surfaces that deform, and of crossings, for one machine."""
    table = []
    times = {(row["what"], row["surface"]): float(row["value"]) for row in read("deforming") if row["machine"] == machine}
    steps = [float(row["rest_ms"]) * 1e6 / float(row["particles"]) for row in read("share") if row["machine"] == machine and row["search"] == "swept"]
    if times and steps:
        share = times["move", "bending"] / steps[0]
        table.append(("moving 2e5 panels, of a step of 1e6 particles", "≤ 5 %", f"{share:.1%}", share <= 0.05))
    for kind in ("points", "balls") if times else ():
        ratio = times["query", f"{kind} at vertices moved individually"] / times["query", f"rigid {kind}"]
        table.append((f"evaluation of {kind} near vertices that move, over that near a rigid surface", "≤ 3", f"{ratio:.2f}", ratio <= 3))
    for motion, of in (("moved", "rigid surface in translation"), ("turned", "rigid surface that rotates by 0.05 rad"), ("deforming", "vertices that move")):
        for kind, limit, radii in (("point", 3, ("0",)), ("ball", 8, ("0.5", "2"))):
            for length, paths in (("0.01", ("0.01",)), ("0.1 to 1", ("0.1", "1"))):
                for order in ORDERS:
                    found = [float(row["ns/crossing"]) / 1e3 for row in read("crossing")
                             if (row["machine"], row["motion"], row["order"]) == (machine, motion, order) and row["radius"] in radii and row["path"] in paths]  # fmt: skip
                    if found:
                        what = f"µs a crossing with its relocation: {kind}, {of}, paths of {length} panels, {'random order' if order == 'random' else 'order of triangles'}"
                        table.append((what, f"≤ {limit}", " to ".join(dict.fromkeys(f"{value:.1f}" for value in (min(found), max(found)))), max(found) <= limit))
    return table


def claims():
    """(claim, required, measured, met) for the slowest machine; for each machine where deforming surfaces are concerned."""
    table = []
    for scene, limit in (("paper", 2), ("debris", 10)):
        values = [nanoseconds(row) for row in read("cost") if row["method"] == "swept" and row["scene"] == scene and row["panels"] == "200000"]
        if values:
            table.append((f"ns a particle and step, 1e6 particles, 2e5 panels, {scene}", f"≤ {limit}", f"{max(values):.2f}", max(values) <= limit))
    for machine in dict.fromkeys(row["machine"] for kind in ("deforming", "crossing") for row in read(kind)):
        table += [(f"{what} ({machine})", *rest) for what, *rest in deforming_claims(machine)]
    return table


def table(heads, rows):
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def power(value):
    """The nearest power of ten: 1e5 for 89 986."""
    return f"1e{round(math.log10(float(value)))}"


def cost_table(rows):
    cells = {(row["method"], power(row["panels"]), power(row["particles"])): row for row in rows if row["scene"] == "paper" and row["panels"] != "200000"}
    particles = sorted({key[2] for key in cells}, key=float)
    lines = []
    for method in METHODS:
        for panels in sorted({key[1] for key in cells}, key=float):
            shown = []
            for count in particles:
                row = cells.get((method, panels, count))
                shown.append("" if row is None else f"{nanoseconds(row):.3g}" + ("*" if is_counted(row) else ""))
            lines.append([method, panels, *shown])
    return table(["method", "panels", *(f"{count} particles" for count in particles)], lines)


def sections():
    lines = []
    machines = dict.fromkeys(row["machine"] for kind in KINDS for row in read(kind))
    lines += table(["claim", "wanted", "measured", "met"], [[what, wanted, shown, "yes" if met else "**no**"] for what, wanted, shown, met in claims()])
    for machine in machines:
        own = {kind: [row for row in read(kind) if row["machine"] == machine] for kind in KINDS}
        lines += [f"### {machine}", ""]
        if own["cost"]:
            lines += ["Nanoseconds a particle of the body and step, one core. \\*: 10 000 particles timed, counted for all.", "", *cost_table(own["cost"])]
            heads = ["scene", "particles", "panels", "ns", "tested a step", "contacts a step"]
            big = [row for row in own["cost"] if row["panels"] == "200000"]
            lines += table(heads, [[row[c] for c in ("scene", "particles", "panels", "ns/particle/step", "tested/step", "contacts/step")] for row in big])
        if own["queries"]:
            heads = ["library", "query", "panels", "ns a query", "times ours", "differs"]
            lines += table(heads, [[row[c] for c in ("library", "query", "panels", "ns/query", "times_ours", "differs")] for row in own["queries"]])
        if own["share"]:
            heads = ["impactor", "search", "elements", "contacts", "contact [ms]", "rest of the step [ms]", "share"]
            rows = [[*(row[c] for c in ("impactor", "search", "impactor_elements", "contacts", "contact_ms", "rest_ms")), f"{float(row['share']):.2%}"] for row in own["share"]]
            lines += table(heads, rows)
        if own["deforming"]:
            lines += table(["surface that deforms", "panels", "value", "unit", "contacts"], [[f"{row['what']}, {row['surface']}", *(row[c] for c in ("panels", "value", "unit", "contacts"))] for row in own["deforming"]])
        if own["crossing"]:
            heads = ["crossing: order", "motion", "radius [panels]", "path [panels]", "ns", "triangles evaluated"]
            lines += table(heads, [[row[c] for c in ("order", "motion", "radius", "path", "ns/crossing", "triangles")] for row in own["crossing"]])
    return "\n".join(lines)


def update_readme():
    text = README.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    README.write_text(f"{before}{BEGIN}\n{sections()}\n{END}{after}", encoding="utf-8")


def draw(path):
    """Cost against particles (1e5 panels) and against panels (1e6 particles), log-log; the first machine."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = [row for row in read("cost") if row["scene"] == "paper" and row["panels"] != "200000"]
    if not rows:
        return
    rows = [row for row in rows if row["machine"] == rows[0]["machine"]]
    figure, axes = plt.subplots(1, 2, figsize=(9.5, 4), sharey=True, layout="constrained")
    colours = dict(zip(METHODS, ["tab:red", "tab:orange", "tab:blue", "tab:green"]))
    for axis, x, fixed, value in ((axes[0], "particles", "panels", "1e5"), (axes[1], "panels", "particles", "1e6")):
        for method in METHODS:
            own = sorted((row for row in rows if row["method"] == method and power(row[fixed]) == value), key=lambda row: float(row[x]))
            for row in own:
                fill = "white" if is_counted(row) else colours[method]
                axis.plot(float(row[x]), nanoseconds(row), "o", color=colours[method], markerfacecolor=fill, zorder=3)
            axis.plot([float(row[x]) for row in own], [nanoseconds(row) for row in own], color=colours[method], label=method)
        axis.set(xscale="log", yscale="log", xlabel=f"{x} ({value} {fixed})")
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("detection: ns per particle and step")
    axes[1].legend(loc="upper left", framealpha=0.9)
    figure.suptitle("Hollow: 10 000 particles timed, counted for all. One core.", fontsize=9, color="grey")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)
