"""The paper's study of panel sizes: accuracy and cost, and its detector, literal and corrected."""

import drawing
from rows import AtMost, Exactly, Row, Within, read_columns, shown
from runner import report
from topics.plate import ANALYTIC, CENTRE, DECK, F, RUNS, TIME, Y, apart, at

TITLE = "Panel sizes"
LONG = True
RADIUS = 0.025  # [m]
SIZES = ("2", "1.5", "1", "0.5", "0.1")  # [mm], the paper's
PANEL = "impactors.cylinder.surface.cylinder.edge_length"
# the paper's own detector; the first 30 µs are enough to see what it finds
PUBLISHED = ("contact.impactors.detector=published", "contact.impactors.radius_ratio=0", "output.frames=0", "output.lines={}", "time.end=30 us",
             f"{PANEL}=2 mm", "impactors.cylinder.surface.cylinder.panel_shape=quads")  # fmt: skip


def bound(size):
    """Three times the depth of a panel below the cylinder [m]; size in mm."""
    return 3 * (1e-3 * float(size)) ** 2 / (8 * RADIUS)


def with_spread(numbers):
    last = [numbers[f"{size} mm centre"] for size in SIZES]
    return numbers | {"spread": (max(last) - min(last)) / abs(last[-1])}


def measure(runner):
    folders = {f"{size} mm": runner.run("panels", f"panel_{size}mm", DECK, f"{PANEL}={size} mm", "output.frames=1") for size in SIZES if size != "1"}
    folders["1 mm"] = runner.run("plate", "panel_1mm", DECK, *RUNS["panel_1mm"])
    analytic = runner.run("plate", "analytic", DECK, *ANALYTIC)
    published = {"repaired": runner.run("panels", "published_repaired", DECK, *PUBLISHED), "letter": runner.run("panels", "published_letter", DECK, *PUBLISHED, "contact.impactors.variant=literal")}
    exact = read_columns(analytic / "history.csv")
    numbers = {}
    for name, folder in folders.items():
        history, run = read_columns(folder / "history.csv"), report(folder)
        timers = run["timers [s]"]
        numbers |= {
            f"{name} centre": at(history, CENTRE, 200e-6),
            f"{name} off": max(apart(history, exact, column) for column in (CENTRE, Y)),
            f"{name} panels": run["impactors"]["cylinder"]["surface"]["triangles"],
            f"{name} panels asked": run["impactors"]["cylinder"]["detection"]["plate"]["panels_tested"],
            f"{name} share": timers["contact"] / sum(timers.values()),
        }
    numbers["share"] = max(numbers[f"{size} mm share"] for size in SIZES)
    for name, folder in published.items():
        numbers |= {
            f"{name} pairs": report(folder)["impactors"]["cylinder"]["detection"]["plate"]["panels_tested"],
            f"{name} force": max(read_columns(folder / "history.csv")["cylinder.force_y [N]"]),
        }
    drawing.panels({size: numbers[f"{size} mm off"] for size in SIZES}, bound, {size: numbers[f"{size} mm share"] for size in SIZES},
                   runner.folder("panels", "figures") / "panels.png")  # fmt: skip
    original = read_columns(runner.run("plate", "original", DECK, *RUNS["original"]) / "history.csv")
    same_time = max(force for time, force in zip(original[TIME], original[F]) if time < 30.5e-6)
    return with_spread(numbers) | {"repaired over original": numbers["repaired force"] / same_time - 1}


def text(n):
    lines = ["| Δ_m | triangles | difference from the original method [µm] | allowed, 3 Δ_m²/(8R) [µm] | particle–panel pairs tested | contact's share of the run |", "|---|---|---|---|---|---|"]
    for size in SIZES:
        pairs, count = (shown(n[f"{size} mm {what}"], "count") for what in ("panels asked", "panels"))
        lines.append(f"| {size} mm | {count} | {1e6 * n[f'{size} mm off']:.2f} | {1e6 * bound(size):.2f} | {pairs} | {100 * n[f'{size} mm share']:.2f} % |")
    return f"""Section 5.2 of the paper: the same plate, panels of five sizes. A panel lies up to Δ_m²/(8R) below the cylinder, which delays contact
accordingly; nothing else depends on the size. The cost hardly does: `swept` uses a tree of panels, and tests few particles. The paper's method tests every panel against
every particle in its bounding box: {shown(n["repaired pairs"], "count")} pairs in the first 30 µs, with quads of 2 mm. Difference: the largest of the plate's centre and of the cylinder over all times.

""" + "\n".join(lines) + """

![Difference from the original method, and share of contact in the run, against panel size](../validation/figures/panels.png)"""


def rows():
    by_size = [
        Row(f"panels of {size} mm against the original method, over all times", "`analytic`", f"{size} mm off", "µm", AtMost(bound(size)), "three times the depth of a panel below the cylinder")
        for size in SIZES
    ]
    return [
        *by_size,
        Row("scatter of the five sizes: the centre at 200 µs", "the paper: no effect on convergence", "spread", "%", AtMost(0.01), "three depths of 2 mm panels, 60 µm, would be 1.2 %"),
        Row("contact's share of the run, largest of five", "the paper: much less computation", "share", "%", AtMost(0.05), "400 times as many panels may cost a few times as much; a search of all panels takes most of the run"),
        Row("corrected variant of the paper's detector against the original method: largest force in the first 30 µs", "`analytic`, `radius_ratio: 0`", "repaired over original", "%", Within(0, 0.1),
            "contact with panels of 2 mm starts up to 0.6 µs later, of the 14 µs since contact began"),
        Row("literal variant: force on the cylinder", "[variants](theory/fccda_variants.md)", "letter force", "MN", Exactly(0), "eqs. 14 and 15 reject every panel of a cylinder along z"),
    ]  # fmt: skip
