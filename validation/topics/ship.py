"""The icebreaker: the direction of the force on its bow, what friction adds, and the step that the paper prints."""

import math
import re

from rows import AtLeast, Between, Exactly, Row, Within, read_columns
from runner import ROOT

TITLE = "An icebreaker's bow"
LONG = False
DECK = "cases/ship_ice/deck.yaml"
STEM = math.radians(24)
SHEET = "bodies.sheet"
SHORT = (  # the first second of a sheet of three layers, 20 m long
    f"{SHEET}.shape.box.size=[20 m, 36 m, 2 m]", f"{SHEET}.position=[-10 m, 0, -0.7561 m]", f"{SHEET}.spacing=0.66666666666667 m",
    f"{SHEET}.particle_sets.far_end={{shape: {{box: {{size: [2.1 m, 36 m, 4 m]}}}}, position: [-8.95 m, 0, 0]}}",
    f"{SHEET}.particle_sets.port={{shape: {{box: {{size: [17.9 m, 2.1 m, 4 m]}}}}, position: [1.05 m, -16.95 m, 0]}}",
    f"{SHEET}.particle_sets.starboard={{shape: {{box: {{size: [17.9 m, 2.1 m, 4 m]}}}}, position: [1.05 m, 16.95 m, 0]}}",
    "impactors.ship.surface.hull.bow_edge_length=3 m", "time={end: 1 s, step: 0.23 ms}", "output={frames: 2, history_interval: 0.02 s}",
)  # fmt: skip


def up_over_back(folder):
    history = read_columns(folder / "history.csv")
    return sum(history["ship.bow.force_z [N]"]) / sum(history["ship.bow.force_x [N]"])


def measure(runner):
    smooth, rough = runner.run("ship", "smooth", DECK, *SHORT), runner.run("ship", "rough", DECK, *SHORT, "contact.impactors.friction=0.1")
    refused = runner.call("check", ROOT / "cases/ship_ice/paper.yaml", "--set", "time.step=3.76 ms")
    return {
        "ratio": up_over_back(smooth),
        "ratio, friction": up_over_back(rough),
        "refused": float(refused.returncode),
        "times": float(re.search(r"is (\S+) times the critical time step", refused.stderr)[1]),
    }


def text(n):
    return f"""All panels of this bow have the stem angle, so without friction the force has a known direction. It is evaluated in the first second of a short sheet of
three layers. The resistance in the full [case](../cases/ship_ice/README.md) is not validated; see its
[comparison with formulas](../cases/ship_ice/README.md#against-formulas) for ships in ice. The paper's step of 3.76 ms is {n["times"]:.2f} times the critical step."""


def rows():
    # friction entirely along a buttock rotates the force by atan(µ |N|/N_xz), |N|/N_xz = √(1 + (sin φ/tan α)²); coarse panels at the stem stand at 18°
    steepest = 0.1 * math.sqrt(1 + (math.sin(STEM) / math.tan(math.radians(18))) ** 2)
    lowest = (1 - steepest * math.tan(STEM)) / (math.tan(STEM) + steepest)
    return [
        Row("F_z/F_x on the bow without friction", "cot 24°", "ratio", "exact", Within(1 / math.tan(STEM), 1e-6), "geometry: rounding of sums"),
        Row("the same with a friction of 0.1", "between all friction down the buttocks and none", "ratio, friction", "", Between(lowest, 1 / math.tan(STEM)), "µ rotates the force by at most atan µ"),
        Row("the paper's time step is refused (exit code)", "stability of the lattice", "refused", "count", Exactly(2), "an unstable run is useless"),
        Row("its ratio to the critical step of the sheet", "above 4.66 of the infinite lattice, times √1.687 of the bending calibration", "times", "", AtLeast(4.66 * math.sqrt(1.687)), "the surface correction of three layers stiffens the highest mode"),
    ]  # fmt: skip
