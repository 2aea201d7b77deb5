"""The results as CSV, the claims they must meet, and the tables of benchmarks/README.md."""

import csv
from pathlib import Path

BENCHMARKS = Path(__file__).resolve().parents[1]
README = BENCHMARKS / "README.md"
RESULTS = BENCHMARKS / "results"
BEGIN, END = "<!-- results: written by plate/against_lammps.py -->\n", "<!-- end of results -->\n"

COLUMNS = """machine program compiler family nu correction threads isa steps rounds steps/s steps/s_min steps/s_max directed_bonds/s root_and_division/s
share_of_core predict contact forces monitors contacts/step cpu_use against ratio ratio_min ratio_max""".split()


def write(rows, path):
    path.parent.mkdir(exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def claims(rows):
    """(claim, required, measured, met); where rows of several builds match, the first counts."""

    def the(column, **wanted):
        for row in rows:
            if row["program"] == "perimpact" and all(row[key] == value for key, value in wanted.items()) and row[column] != "":
                return float(row[column])
        return None

    def claim(what, value, limit, unit, below=False):
        if value is not None:
            sign, met = ("<", value < limit) if below else ("≥", value >= limit)
            shown, wanted = (f"{100 * value:.3g} %", f"{100 * limit:.3g} %") if unit == "%" else (f"{value:.2f}", f"{limit:g}")
            table.append((what, f"{sign} {wanted}", shown, met))

    table = []
    issue = {"family": "122", "correction": "energy", "threads": "1"}
    claim("steps per second against `peri/pmb`, ν = 0.25", the("ratio", nu="0.25", **issue), 9, "")
    claim("steps per second against `peri/lps`, ν = 0.3", the("ratio", nu="0.3", **issue), 11, "")
    claim("directed bonds per root-and-division of the core, ν = 0.25", the("share_of_core", nu="0.25", **issue), 0.4, "%")
    shares = [float(row["contact"]) for row in rows if row["contact"] and row["threads"] == "1"]
    claim("share of contact in the step of one thread, most of all runs", max(shares, default=None), 0.03, "%", below=True)
    for nu in ("0.25", "0.3"):
        claim(f"two threads against one, ν = {nu}", the("ratio", nu=nu, **{**issue, "threads": "2"}), 1.7, "")
    return table


def number(text, form):
    return format(float(text), form) if text else ""


def spread(row, column):
    """median (least–largest)"""
    median, least, largest = (number(row[column + end], ".3g") for end in ("", "_min", "_max"))
    return f"{median} ({least}–{largest})" if median else ""


def section(path):
    """The results of one machine in Markdown."""
    rows = read(path)
    made = ", ".join(dict.fromkeys(f"{row['program'].split()[0]}: {row['compiler']}" for row in rows))
    lines = [f"#### {rows[0]['machine']}", "", f"`results/{path.name}`; {rows[0]['rounds']} rounds; {made}.", ""]
    lines += ["| claim | wanted | measured | met |", "|---|---|---|---|"]
    lines += [f"| {what} | {wanted} | {shown} | {'yes' if met else '**no**'} |" for what, wanted, shown, met in claims(rows)]
    heads = "program, bonds, ν, correction, isa, threads, steps/s, bonds/s [10⁹], of the core, predict, contact, forces, monitors, against, ratio".split(", ")
    lines += ["", "| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for row in rows:
        cells = [row[column] for column in ("program", "family", "nu", "correction", "isa", "threads")]
        cells += [spread(row, "steps/s"), f"{float(row['directed_bonds/s']) / 1e9:.3f}", number(row["share_of_core"], ".0%")]
        cells += [number(row[column], ".1%") for column in ("predict", "contact", "forces", "monitors")]
        cells += [row["against"], spread(row, "ratio")]
        lines.append("| " + " | ".join(cells) + " |")
    use = min(float(row["cpu_use"]) for row in rows)
    lines += ["", f"Of the cores given to it, the most disturbed run had {use:.0%} of the time" + (": not an idle machine." if use < 0.95 else ".")]
    return "\n".join(lines) + "\n"


def update_readme():
    text = README.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    sections = "\n".join(section(path) for path in sorted(RESULTS.glob("plate_*.csv")))
    README.write_text(f"{before}{BEGIN}\n{sections}\n{END}{after}", encoding="utf-8")
