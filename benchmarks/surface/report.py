"""Results of the surface benchmark: CSV files and tables of benchmarks/README.md."""

import csv
from pathlib import Path

BENCHMARKS = Path(__file__).resolve().parents[1]
README = BENCHMARKS / "README.md"
RESULTS = BENCHMARKS / "results"
BEGIN, END = "<!-- surface: written by surface/measure.py -->\n", "<!-- end of surface -->\n"
READY = ["read", "fit", "bvh", "check"]  # stages from a file to a checked surface ready for queries
INSIDE_FIT = ["weld", "triangulate", "connect", "wind"]


def write(rows, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read():
    """Rows of all machines."""
    rows = []
    for path in sorted(RESULTS.glob("surface_*.csv")):
        with open(path, newline="", encoding="utf-8") as file:
            rows += list(csv.DictReader(file))
    return rows


def cells_of(rows):
    return {(row["program"], row["file"], row["format"], row["stage"]): row for row in rows}


def seconds(row):
    return float(row["seconds"])


def ready(cells, file, kind):
    return sum(seconds(cells["perimpact", file, kind, stage]) for stage in READY)


def claims():
    """(claim, required, measured, met) for the slowest machine."""
    rows = read()
    machines = [cells_of(row for row in rows if row["machine"] == machine) for machine in dict.fromkeys(row["machine"] for row in rows)]
    if not machines:
        return []
    whole = max(ready(cells, "sphere", "stl") for cells in machines)
    ours = [sum(seconds(cells["perimpact", "sphere", "stl", stage]) for stage in ("read", "weld")) for cells in machines]
    share = max(own / seconds(cells["assimp", "sphere", "stl", "read and join"]) for own, cells in zip(ours, machines))
    return [
        ("seconds from a binary STL of a million triangles to a checked surface that answers queries", "≤ 4", f"{whole:.2f}", whole <= 4),
        ("read and weld of that file, as a share of assimp's read and join", "≤ 1", f"{share:.2f}", share <= 1),
    ]


def table(heads, rows):
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def shown(row):
    return "" if row is None else f"{seconds(row):.2g}" if seconds(row) < 1 else f"{seconds(row):.3g}"


def stage_table(cells):
    lines = []
    for file, kind in dict.fromkeys((file, kind) for _, file, kind, stage in cells if stage == "fit"):
        row = lambda stage, file=file, kind=kind: cells["perimpact", file, kind, stage]
        name = "the million" if file == "sphere" else f"`{file}`"
        lines.append([name, *(shown(row(stage)) for stage in READY), f"{ready(cells, file, kind):.2f}", f"{float(row('check')['memory_mib']):.0f}", *(shown(row(stage)) for stage in INSIDE_FIT)])
    return table(["surface", *READY, "together", "memory [MiB]", *(f"of fit: {stage}" for stage in INSIDE_FIT)], lines)


def format_table(cells):
    columns = [("perimpact", "read"), ("assimp", "read"), ("assimp", "read and join"), ("meshio", "read")]
    lines = []
    for kind in dict.fromkeys(kind for _, file, kind, _ in cells if file == "sphere"):
        rows = [cells.get((program, "sphere", kind, stage)) for program, stage in columns]
        memory = [f"{float(row['memory_mib']):.0f}" if row else "" for row in rows]
        lines.append([f"`.{kind}`", rows[0]["file_mib"], *(shown(row) for row in rows), *memory])
    heads = ["format", "file [MiB]", "perimpact", "assimp", "assimp, joined", "meshio", *(f"{name} [MiB]" for name in ("ours", "assimp", "joined", "meshio"))]
    return table(heads, lines)


def sections():
    rows = read()
    lines = table(["claim", "wanted", "measured", "met"], [[what, wanted, value, "yes" if met else "**no**"] for what, wanted, value, met in claims()])
    for machine in dict.fromkeys(row["machine"] for row in rows):
        cells = cells_of(row for row in rows if row["machine"] == machine)
        lines += [f"### {machine}", "", "Seconds of processor time, stage by stage:", "", *stage_table(cells)]
        lines += ["Seconds to read the million triangles, by format:", "", *format_table(cells)]
    return "\n".join(lines)


def update_readme():
    text = README.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    README.write_text(f"{before}{BEGIN}\n{sections()}\n{END}{after}", encoding="utf-8")
