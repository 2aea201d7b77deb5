#!/usr/bin/python3
"""The speed that the driven ship has in ice of several thicknesses, its h-v curve: speeds.py [RESULTS ...]

RESULTS: folders of runs of free.yaml, free_0.7m.yaml and free_1.4m.yaml. They are measured over the sample of their deck, or what has been run of it, and their
rows in speeds.csv are replaced, and figures/speeds.png is drawn: speeds of the runs, and those at which the net thrust equals the resistance of a formula. Then the
table of README.md is printed.
"""

from dataclasses import replace

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from compare import cell, write_rows  # noqa: E402
from decks import FREE, HERE, free_ship  # noqa: E402  which makes ../ship_ice importable
from measure import history, mean, options, records, refuse, report_of, run  # noqa: E402  which makes scripts/results importable
from resistance import held_speed, lindqvist, net_thrust, riska  # noqa: E402
from long_run import load_statistics  # noqa: E402

SPEEDS = "speeds.csv"
FORMULAS = (("Lindqvist", lindqvist), ("Riska", riska))


def runs():
    """Rows of speeds.csv by the thickness [m] of the ice."""
    return {float(row["thickness [m]"]): row for row in records(HERE, SPEEDS)}


def ships():
    """The ships of the decks by the thickness [m] of their ice."""
    return {thickness: free_ship(name) for name, (thickness, _) in FREE.items()}


def measure(folder):
    """The row of speeds.csv of a run."""
    title = report_of(folder)["setup"]["title"]
    ship = next((ship for thickness, ship in ships().items() if f", free, test 302, {thickness:g} m of ice" in title), None)
    if ship is None:
        refuse(f"{folder}: its title, {title}, is not that of {', '.join(FREE)}.")
    columns = history(folder)
    begin, end, last = ship.sample_begins, ship.ends, columns["time [s]"][-1]
    if not last > (begin + end) / 2:
        refuse(f"{folder} ends at {last:.1f} s, before the middle of its sample, which is from {begin:.1f} to {end:.1f} s. Continue it with --resume.")
    force = load_statistics(folder, "ship.force_x", begin, end)
    time, speed = columns["time [s]"], -columns["ship.velocity_x [m/s]"]
    sample = time > begin
    return {
        "thickness [m]": f"{ship.thickness:g}", "from [s]": f"{begin:.2f}", "to [s]": f"{min(end, last):.2f}",
        "mean speed [m/s]": f"{mean(time[sample], speed[sample]):.3f}", "change of the speed [m/s]": f"{speed[-1] - speed[sample][0]:.3f}",
        "mean F_x [N]": f"{float(force['mean']):.4g}", "standard error [N]": f"{float(force['standard_error']):.3g}",
        "standard error is a lower bound": force["standard_error_is_bound"],
        "energy balance error over the energy exchanged": f"{report_of(folder)['energy_balance']['relative']:.2g}",
    }  # fmt: skip


def measured(folders):
    """speeds.csv with the rows of these runs in place of those of the same thicknesses."""
    rows = runs()
    for row in map(measure, folders):
        rows[float(row["thickness [m]"])] = row
    write_rows(SPEEDS, rows)


def has_settled(row):
    """Whether the mean force is the net thrust, within twice its standard error."""
    ship = replace(ships()[float(row["thickness [m]"])], speed=float(row["mean speed [m/s]"]))
    return abs(float(row["mean F_x [N]"]) - net_thrust(ship)) < 2 * float(row["standard error [N]"])


def draw(file):
    figure, axis = plt.subplots(figsize=(7, 4.2))
    thicknesses = np.linspace(0.3, 1.7, 57)
    ship = next(iter(ships().values()))
    for (name, formula), style in zip(FORMULAS, ("-", "--")):
        held = [held_speed(replace(ship, thickness=thickness), formula) for thickness in thicknesses]
        axis.plot(thicknesses, held, "k" + style, linewidth=1, label=f"net thrust equals {name}'s formula")
    for is_settled, face, text in ((True, "#b3312c", "runs"), (False, "none", "runs in which the ship still slows down or gains speed")):
        held = [(thickness, float(row["mean speed [m/s]"])) for thickness, row in sorted(runs().items()) if has_settled(row) == is_settled]
        if held:
            axis.plot(*np.array(held).T, "o", color="#b3312c", markerfacecolor=face, label=text)
    axis.set_xlabel("thickness of the ice [m]"), axis.set_ylabel("speed [m/s]")
    axis.set_xlim(0.3, 1.7), axis.set_ylim(0, None)
    axis.legend(fontsize=9, frameon=False)
    figure.tight_layout()
    figure.savefig(file, dpi=95)


def main():
    if folders := options(__doc__, nargs="*").parse_args().results:
        measured(folders)
        draw(HERE / "figures/speeds.png")
    print("| H [m] | speed [m/s] | change in the sample [m/s] | mean F_x [kN] | net thrust at this speed [kN] | speed by Lindqvist [m/s] | by Riska [m/s] |")
    print("|---|---|---|---|---|---|---|")
    for thickness, row in sorted(runs().items()):
        ship = ships()[thickness]
        speed = float(row["mean speed [m/s]"])
        formulas = " | ".join(f"{held_speed(ship, formula):.1f}" for _, formula in FORMULAS)
        print(f"| {thickness:g} | {speed:.2f} | {float(row['change of the speed [m/s]']):+.2f} | {cell(row)} | {net_thrust(replace(ship, speed=speed)) / 1e3:.0f} | {formulas} |")


if __name__ == "__main__":
    run(main)
