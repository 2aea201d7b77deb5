#!/usr/bin/python3
"""Where the work of the box that is driven through a floating sheet goes: python3 figure.py RESULTS_OF_SHEET PICTURE.png

What the box puts in is minus contact_work, since it keeps its velocity; what it went to is stacked."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts/results"))
from csv_reader import history  # noqa: E402

folder, picture = sys.argv[1:]
columns = history(folder)


def kilojoules(name):
    return columns[f"{name} [J]"] / 1000


time = 1000 * columns["time [s]"]
parts = {
    "elastic energy": ("#8fb8de", kilojoules("ice.elastic_energy")),
    "kinetic energy of the ice": ("#2f6ea5", kilojoules("ice.kinetic_energy")),
    "broken bonds": ("#c8553d", kilojoules("ice.fracture_energy")),
    "contact": ("#e0a458", kilojoules("total.contact_dissipation")),
    "drag and added mass": ("#6a994e", -kilojoules("ice.sea.drag_work")),
    "weight and buoyancy": ("#b8c4bb", -kilojoules("ice.sea.weight_buoyancy_work")),
}
plt.rcParams.update({"font.size": 14})
figure, axes = plt.subplots(figsize=(10, 6), dpi=100)
axes.stackplot(time, [values for _, values in parts.values()], colors=[colour for colour, _ in parts.values()], labels=list(parts))
axes.plot(time, -kilojoules("box.contact_work"), color="black", linewidth=2, linestyle="--", label="work of the box")
axes.set(xlabel="time [ms]", ylabel="energy [kJ]", title="A box at 3 m/s through a floating sheet: where its work goes", xlim=(18, time[-1]), ylim=(0, None))
below = 0
for name, (colour, values) in parts.items():  # beside its band, unless that is too thin
    middle = max(below + values[-1] / 2, 0.3)
    axes.text(time[-1] + 1, middle, name, va="center")
    below += values[-1]
axes.annotate("work of the box", (36, 25.7), (36, 27.2), ha="center")
axes.spines[["top", "right"]].set_visible(False)
figure.tight_layout()
figure.savefig(picture)
