"""The icebreaker: direction of the force on its bow, friction, the load at which a split sheet breaks, a long run, and the step that the paper prints."""

import math
import re

from rows import AtLeast, AtMost, Between, Exactly, Row, Within, read_columns, read_numbers
from runner import ROOT, script_of

TITLE = "An icebreaker's bow"
LONG = False
DECK = "cases/ship_ice/deck.yaml"
STEM = math.radians(24)
WINDOW, PAPER, PAPER_LAYERS_4 = (ROOT / f"cases/ship_ice/{name}.csv" for name in ("window", "paper", "paper_layers_4"))  # of runs of up to three hours (cases/ship_ice/long_run.py)
ENTRY = "time.end=2.1 s", "output={frames: 0, history_interval: 0.05 s}"
CUT = "bodies.sheet.cracks={track: {polygon: [[-31, 0, -2], [31, 0, -2], [31, 0, 2], [-31, 0, 2]]}}", *ENTRY
SHEET = "bodies.sheet"
# of four layers none is in the middle; one is fixed, so that the edge can rotate
FIXED = {"far_end": ("2 m, 81 m", "-29 m, 0"), "port": ("58 m, 2 m", "1 m, -39 m"), "starboard": ("58 m, 2 m", "1 m, 39 m")}
FOUR_LAYERS = (
    *ENTRY, f"{SHEET}.spacing=0.5 m", "time.step=0.176 ms",
    *(f"{SHEET}.particle_sets.{name}={{shape: {{box: {{size: [{size}, 0.4 m]}}}}, position: [{place}, 0.25 m]}}" for name, (size, place) in FIXED.items()),
)  # fmt: skip
SHORT = (  # the first 1.5 s of a sheet 20 m long, between fixed edges
    f"{SHEET}.shape.box.size=[20 m, 36 m, 2 m]", f"{SHEET}.position=[-10 m, 0, -0.7561 m]",
    f"{SHEET}.particle_sets={{far_end: {{shape: {{box: {{size: [1.4 m, 36 m, 4 m]}}}}, position: [-9.3 m, 0, 0]}}, "
    "port: {shape: {box: {size: [18.6 m, 1.4 m, 4 m]}}, position: [0.7 m, -17.3 m, 0]}, starboard: {shape: {box: {size: [18.6 m, 1.4 m, 4 m]}}, position: [0.7 m, 17.3 m, 0]}}",
    f"{SHEET}.boundary_conditions={{sea: {{floating: {{level: 0}}}}, ahead: {{fixed: {{particle_set: far_end}}}}, left: {{fixed: {{particle_set: port}}}}, "
    "right: {fixed: {particle_set: starboard}}}",
    "impactors.ship.surface.hull.bow_edge_length=3 m", "impactors.ship.position=[0.25 m, 0, 0]", "time={end: 1.5 s, step: 0.23 ms}", "output={frames: 2, history_interval: 0.02 s}",
)  # fmt: skip


def up_over_back(folder):
    history = read_columns(folder / "history.csv")
    return sum(history["ship.bow.force_z [N]"]) / sum(history["ship.bow.force_x [N]"])


def resistance():
    """[N] Lindqvist's crushing, bending and potential energy of submerged ice, without friction, at rest."""
    formulas = script_of("cases/ship_ice/resistance.py")
    return formulas.lindqvist(formulas.ShipInIce(thickness=2, strength=768e3, friction=0, speed=0))["total"]


def elastic_plate():
    """[N] vertical force of the stem at which an elastic plate on water has a radial crack, and at which one that is split has a circumferential crack."""
    script = script_of("cases/ship_ice/plate_on_water.py")
    ice = script.ShipInIce(strength=768e3)
    return tuple(script.breaking(script.Plate(ice, is_split), ice.waterline, 2.3e6, side)[0] for is_split, side in ((False, 0), (True, 1)))


def first_break(folder):
    """[N] vertical force on the bow in the first row of the history with a broken bond."""
    history = read_columns(folder / "history.csv")
    return next(force for force, broken in zip(history["ship.bow.force_z [N]"], history["sheet.broken_bonds [-]"]) if broken > 0)


def corner_load():
    """[N] static load that breaks two corners of a plate on water, side by side: H. M. Westergaard, Public Roads 7 (1926) 25. The crushed ice carries it at 2.3 MPa."""
    plate = script_of("cases/ship_ice/resistance.py").ShipInIce(thickness=2, strength=720e3)
    load = 2e6
    for _ in range(20):
        radius = math.sqrt(load / 2 / 2.3e6 / math.pi)  # of a circular area in each corner
        load = 2 * plate.strength * plate.thickness**2 / 3 / (1 - (math.sqrt(2) * radius / plate.characteristic_length) ** 0.6)
    return load


def four_over_three_layers():
    """Mean resistance in the paper's sheet at full breadth, of four layers over that of three, and its standard error."""
    (three, error_three), (four, error_four) = (
        (table["full breadth, mean F_x [N]"], table["full breadth, standard error [N]"]) for table in map(read_numbers, (PAPER, PAPER_LAYERS_4))
    )
    ratio = four / three
    return ratio, ratio * math.hypot(error_three / three, error_four / four)


def gathered():
    window = read_numbers(WINDOW)
    return {
        "window, travel": window["travel [m]"],
        "window, mean": window["full breadth, mean F_x [N]"],
        "window, standard error": window["full breadth, standard error [N]"],
        "window, standard error is a lower bound": window["full breadth, standard error is a lower bound"],
        "window, mean from first contact": window["whole, mean F_x [N]"],
        "window, period": window["full breadth, dominant period [s]"],
        "window, median floe": window["floes, median side by mass [m]"],
        "window, energy": window["energy balance error [J]"] / window["contact work [J]"],
        "paper, four layers": four_over_three_layers()[0],
    }


def measure(runner):
    smooth, rough = runner.run("ship", "smooth", DECK, *SHORT), runner.run("ship", "rough", DECK, *SHORT, "contact.impactors.friction=0.1")
    folders = {name: runner.run("ship", name, DECK, *settings) for name, settings in (("cut", CUT), ("entry", ENTRY), ("entry_layers_4", FOUR_LAYERS))}
    loads = {name: max(read_columns(folder / "history.csv")["ship.bow.force_z [N]"]) for name, folder in folders.items()}
    radial, split = elastic_plate()
    refused = runner.call("check", ROOT / "cases/ship_ice/paper.yaml", "--set", "time.step=3.76 ms")
    return {
        "ratio": up_over_back(smooth),
        "ratio, friction": up_over_back(rough),
        "split": loads["cut"],
        "entry, four layers": loads["entry_layers_4"] / loads["entry"],
        "radial crack": first_break(folders["entry"]),
        "radial crack, four layers": first_break(folders["entry_layers_4"]),
        "elastic plate, radial crack": radial,
        "elastic plate, split": split,
        "refused": float(refused.returncode),
        "times": float(re.search(r"is (\S+) times the critical time step", refused.stderr)[1]),
    }


def text(n):
    wanted = resistance()
    over = n["window, mean"] / wanted - 1
    error = ("at least " if n["window, standard error is a lower bound"] else "") + f"{n['window, standard error'] / 1e6:.2f} MN"
    mean = f"""The mean resistance over the part of {n["window, travel"]:.0f} m in which the full breadth of the ship is in the ice is {n["window, mean"] / 1e6:.2f} MN with a standard error of
{error}, {100 * over:+.0f} % from Lindqvist's {wanted / 1e6:.2f} MN for crushing, bending and submersion without friction, at rest""".replace("-", "−")
    judged = f"{mean}." if abs(over) <= 0.25 else f"**{mean}; the target of 25 % is not met.**"
    return f"""All panels of this bow have the stem angle, so without friction the force has a known direction. It is evaluated in the first 1.5 s of a short sheet of
three layers. {judged} The [case](../cases/ship_ice/README.md#against-formulas) compares it with formulas. The paper's step of 3.76 ms is {n["times"]:.2f} times the critical step."""


def rows():
    # friction entirely along a buttock rotates the force by atan(µ |N|/N_xz), |N|/N_xz = √(1 + (sin φ/tan α)²); coarse panels at the stem stand at 18°
    steepest = 0.1 * math.sqrt(1 + (math.sin(STEM) / math.tan(math.radians(18))) ** 2)
    lowest = (1 - steepest * math.tan(STEM)) / (math.tan(STEM) + steepest)
    return [
        Row("F_z/F_x on the bow without friction", "cot 24°", "ratio", "exact", Within(1 / math.tan(STEM), 1e-6), "geometry: rounding of sums"),
        Row("the same with a friction of 0.1", "between all friction down the buttocks and none", "ratio, friction", "", Between(lowest, 1 / math.tan(STEM)), "µ rotates the force by at most atan µ"),
        Row("vertical force on the bow that breaks a sheet cut along the track", "two corners of a plate on water: Westergaard 1926", "split", "MN", Within(corner_load(), 0.15, True), "a semi-empirical static formula; spacing of a third of the thickness"),
        Row("largest vertical force while the whole sheet breaks: four layers over three", "independent of the resolution", "entry, four layers", "", Within(1, 0.05), "strength of a strip of three and of four layers"),
        Row("mean resistance in the paper's sheet, 58 m at full breadth: four layers over three", "independent of the resolution", "paper, four layers", "", Within(1, 2 * four_over_three_layers()[1]), "twice the standard error of the ratio, by block averages; both errors are lower bounds"),
        Row("energy balance error of the run in the window over the work of the ship", "energy is conserved", "window, energy", "%", AtMost(0.01), "second order of the step, with friction in rubble"),
        Row("the paper's time step is refused (exit code)", "stability of the lattice", "refused", "count", Exactly(2), "an unstable run is useless"),
        Row("its ratio to the critical step of the sheet", "above 7.2 of the infinite lattice, times √1.32 of the bending calibration", "times", "", AtLeast(7.2 * math.sqrt(1.32)), "the surface correction of three layers stiffens the highest mode"),
    ]  # fmt: skip
