#!/usr/bin/python3
"""Writes the tables of README.md from the results of variants.sh.

    /usr/bin/python3 table.py [RESULTS]          default: results/propeller_ice
"""

from pathlib import Path

from measure import cost, energy, forces, fragments, history, impulses, options, report_of, run  # which makes scripts/results importable
from page_table import write_table

HERE = Path(__file__).parent

STRETCHES = {"0.032": "0.032, the paper's", "0.01": "0.01", "0.003": "**0.003, the deck's**", "0.001": "0.001"}
CRUSHED = {
    "deck": "deck: tension only, 0.003",
    "stretch_3.2e-4": "tension only, 3.2e-4",
    "stretch_3.2e-4_fine": "the same, 40 across",
    "crushed": "**crushable**, rigid contact",
    "crushed_half_step": "half of the time step",
    "crushed_fine": "40 across, to 19.3 ms",
    "crushed_in_contact": "**crushable, and crushed in contact**",
    "crushed_in_contact_half_step": "half of the time step",
    "crushed_in_contact_fine": "40 across, to 19.3 ms",
}
DISSIPATIONS = "plastic dissipation [-]", "crushing dissipation [-]"
SENSITIVITY = {
    "deck": "**deck**",
    "panels_coarse": "panels twice as large (0.3 m, 0.1 m at edges)",
    "panels_fine": "panels half as large (75 mm, 25 mm at edges)",
    "turned_30": "sphere 30° further round the shaft",
    "turned_60": "60° further",
    "no_fragments": "no fragment contact (`law: none`)",
    "free": "propeller free, 14.76 t of steel (roots within the hub counted twice)",
}
BOUNDS = {
    "bounds_none": "none",
    "bounds_box": "box",
    "bounds_cylinder": "cylinder (`sector_angle: 180 deg`)",
    "deck": "**cylinder with sectors, fitted**",
    "bounds_box_union": "union of 21 boxes, fitted; so is `auto`",
}


def minus(text):
    return text.replace("-", "−")


def share(value):
    return "–" if value == 0 else f"{100 * value:.1g} %" if 0 < value < 0.005 else f"{100 * value:.0f} %"


def mega(value):
    return minus(f"{value / 1e6:.2f}")


def kilo(value):
    return minus(f"{value / 1e3:.1f}")


def numbers(results, name):
    column = history(results / name)
    return forces(column) | fragments(results / name, report_of(results / name)) | energy(column)


def head(*titles):
    return ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]


def fragmentation(results):
    lines = head("critical stretch", "in compression", "fragments above 1 %", "largest", "second", "in smaller ones", "bonds broken", "peak thrust [MN]", "mean",
                 "peak torque [MN m]", "mean", "thrust's impulse [kN s]")  # fmt: skip
    for value, title in STRETCHES.items():
        stem = "deck" if value == "0.003" else f"stretch_{value}"
        for name, limit in ((stem, "never"), (f"stretch_{value}_limit", f"at {3 * float(value):g}"), (f"stretch_{value}_symmetric", f"at {value}")):
            n = numbers(results, name)
            limit = "**never**" if name == "deck" else limit
            lines.append("| " + " | ".join([
                title if limit.strip("*") == "never" else "", limit, str(n["fragments above 1 % of the mass [-]"]), share(n["largest fragment [-]"]),
                share(n["second [-]"]) if n["second [-]"] > 0.01 else "–", share(n["in fragments below 1 % [-]"]) if n["in fragments below 1 % [-]"] > 1e-9 else "0 %",
                share(n["broken bonds [-]"]), mega(n["thrust: peak [N]"]), mega(n["thrust: mean [N]"]), mega(n["torque: peak [N m]"]), mega(n["torque: mean [N m]"]),
                kilo(n["thrust: impulse [N s]"]),
            ]) + " |")  # fmt: skip
    return lines


def crushed(results):
    lines = head("ice", "fragments above 1 %", "largest", "bonds broken", "peak thrust [MN]", "peak torque [MN m]", "thrust's impulse [kN s]", "plastic dissipation",
                 "dissipated by crushing in contact", "energy balance error")  # fmt: skip
    for name, title in CRUSHED.items():
        n = numbers(results, name)
        lines.append("| " + " | ".join([
            title, str(n["fragments above 1 % of the mass [-]"]), share(n["largest fragment [-]"]), share(n["broken bonds [-]"]), mega(n["thrust: peak [N]"]),
            mega(n["torque: peak [N m]"]), kilo(n["thrust: impulse [N s]"]), *(f"{n[key]:.2f}" if key in n else "" for key in DISSIPATIONS),
            f"{n['energy balance error [-]']:.1e}".replace("e-0", "e-"),
        ]) + " |")  # fmt: skip
    return lines


def coarse_by_then(results):
    """The runs of 20 across at the end of those of 40 across."""
    lines = head("20 across", "at [ms]", "bonds broken", "thrust's impulse [kN s]", "plastic dissipation", "dissipated by crushing in contact")
    for name in ("crushed", "crushed_in_contact"):
        column = history(results / name)
        times = column["time [s]"]
        until = times <= history(results / f"{name}_fine")["time [s]"][-1]
        column = {key: values[until] for key, values in column.items()}
        impulse = impulses(column["time [s]"], column["propeller.shaft.force_x [N]"])[-1]
        found, broken = energy(column), column["ice.broken_bonds [-]"][-1] / report_of(results / name)["bodies"]["ice"]["bonds"]
        lines.append("| " + " | ".join([CRUSHED[name].replace("*", ""), f"{1e3 * column['time [s]'][-1]:.2f}", share(broken), kilo(impulse),
                                        *(f"{found[key]:.2f}" if key in found else "" for key in DISSIPATIONS)]) + " |")  # fmt: skip
    return lines


def sensitivity(results):
    lines = head("", "fragments above 1 %", "largest", "bonds broken", "peak thrust [MN]", "peak torque [MN m]", "largest spindle torque [MN m]", "thrust's impulse [kN s]")
    for name, title in SENSITIVITY.items():
        n = numbers(results, name)
        spindle = max((n[f"spindle torque {blade}: peak [N m]"] for blade in range(1, 5)), key=abs)
        lines.append("| " + " | ".join([
            title, str(n["fragments above 1 % of the mass [-]"]), share(n["largest fragment [-]"]), share(n["broken bonds [-]"]), mega(n["thrust: peak [N]"]),
            mega(n["torque: peak [N m]"]), mega(spindle), kilo(n["thrust: impulse [N s]"]),
        ]) + " |")  # fmt: skip
    return lines


def bounds(results):
    lines = head("contact bounds", "volume/bounding box", "particle-steps in the bounds", "tested", "pairs of particle and panel")
    states = set()
    for name, title in BOUNDS.items():
        report = report_of(results / name)
        volume = report["impactors"]["propeller"]["contact_bounds"].get("share_of_bounding_box")
        counts = [f"{cost(report)[key]:,}".replace(",", " ") for key in ("points in the bounds [-]", "points tested [-]", "panels tested [-]")]
        lines.append(f"| {title} | {'–' if volume is None else share(volume)} | " + " | ".join(counts) + " |")
        states.add(cost(report)["state"])
    if len(states | {report_of(results / "bounds_auto")["state_hash"]}) > 1:
        print("The runs with different contact bounds end in different states.")
    return lines


def main():
    results = options(__doc__, nargs="?", default=Path("results/propeller_ice")).parse_args().results
    page = HERE / "README.md"
    text = page.read_text(encoding="utf-8")
    for name, table in (("fragmentation", fragmentation), ("crushed", crushed), ("by then", coarse_by_then), ("sensitivity", sensitivity), ("bounds", bounds)):
        text = write_table(text, name, table(results))
    page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    run(main)
