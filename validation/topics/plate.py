"""The benchmark of the FCCDA paper: perimpact with a meshed impactor, the original method, and finite elements, over the whole time."""

from pathlib import Path

import drawing
from rows import AtMost, Row, Within, read_columns
from runner import ROOT, script_of

TITLE = "The plate benchmark"
LONG = False
DECK = "cases/plate_impact/deck.yaml"
FEM = ROOT / "validation/plate"
FINE, COARSE = 1, 2  # [mm] elements of the reference, and those that show how far it is converged
SAGITTA = 1e-3**2 / (8 * 0.025)  # [m] largest depth of a panel of 1 mm below the cylinder
ANALYTIC = ("contact.impactors.detector=analytic", "output.frames=1")
RUNS = {"panel_1mm": ("output.frames=1",), "analytic": ANALYTIC, "original": (*ANALYTIC, "contact.impactors.radius_ratio=0")}

TIME, CENTRE, Y, V, F = "time [s]", "centre.displacement_y [m]", "cylinder.position_y [m]", "cylinder.velocity_y [m/s]", "cylinder.force_y [N]"


def at(history, column, time):
    """The row nearest to the time."""
    row = min(range(len(history[TIME])), key=lambda i: abs(history[TIME][i] - time))
    return history[column][row]


def end_of_contact(history):
    return max(t for t, force in zip(history[TIME], history[F]) if force != 0)


def values(history):
    """Quantities compared at single times."""
    return {
        "centre": at(history, CENTRE, 200e-6),
        "cylinder": at(history, Y, 200e-6) - history[Y][0],
        "v50": at(history, V, 50e-6),
        "v200": at(history, V, 200e-6),
        "force": max(history[F]),
        "end": end_of_contact(history),
    }


def apart(one, other, column):
    """Largest difference over all rows, which have the same times."""
    assert all(abs(a - b) < 1e-9 for a, b in zip(one[TIME], other[TIME])), "rows of different times"
    return max(abs(a - b) for a, b in zip(one[column], other[column]))


def line_apart(folder, name, reference):
    """Largest difference along a central line at 200 µs [m], at the positions of the run."""
    import numpy as np

    (path,) = (Path(folder) / "lines").glob(f"along_{name}_t*.csv")
    ours = read_columns(path)
    wanted = np.interp(ours[f"position_{name} [m]"], reference[f"position_{name} [m]"], reference["displacement_y [m]"])
    if name == "x":  # of the finite elements half of the plate
        wanted = np.interp(np.abs(ours["position_x [m]"]), reference["position_x [m]"], reference["displacement_y [m]"])
    return float(np.abs(wanted - ours["displacement_y [m]"]).max())


def reference():
    """The stored finite-element results; the topic fem repeats them."""
    numbers = {}
    for name in (f"fem_{FINE}mm", f"fem_{COARSE}mm", "fem_2mm", "fem_2mm_gap", "fem_2mm_late"):
        numbers |= {f"{name} {quantity}": value for quantity, value in values(read_columns(FEM / f"{name}.csv")).items()}
    lost = {name: read_columns(FEM / f"{name}.csv")["contact dissipation [J]"][-1] for name in ("fem_2mm", "fem_2mm_late")}
    return numbers | {"lost": lost["fem_2mm"], "late gain": lost["fem_2mm"] - lost["fem_2mm_late"]}


gathered = reference


def measure(runner):
    folders = {name: runner.run("plate", name, DECK, *settings) for name, settings in RUNS.items()}
    histories = {name: read_columns(folder / "history.csv") for name, folder in folders.items()}
    fem, gap = read_columns(FEM / f"fem_{FINE}mm.csv"), read_columns(FEM / "fem_2mm_gap.csv")
    meshed, original = histories["panel_1mm"], histories["original"]
    numbers = values(meshed)
    momentum = meshed["total.momentum_y [kg m/s]"]
    numbers |= {
        "centre, all times": apart(meshed, fem, CENTRE) / abs(fem[CENTRE][-1]),
        "velocity, all times": apart(meshed, fem, V),
        "line x": line_apart(folders["panel_1mm"], "x", read_columns(FEM / f"fem_{FINE}mm_line_x.csv")) / abs(fem[CENTRE][-1]),
        "line y": line_apart(folders["panel_1mm"], "y", read_columns(FEM / f"fem_{FINE}mm_line_y.csv")) / abs(fem[CENTRE][-1]),
        "momentum": max(abs(p / momentum[0] - 1) for p in momentum),
        "contact dissipation": meshed["total.contact_dissipation [J]"][-1],
        "from analytic": max(apart(meshed, histories["analytic"], column) for column in (CENTRE, Y)),
        "original centre": at(original, CENTRE, 200e-6),
        "original cylinder": at(original, Y, 200e-6) - original[Y][0],
        "original velocity, all times": apart(original, gap, V),
        "delay": next(t for t, force in zip(original[TIME], original[F]) if force != 0),
    }
    drawing.plate(histories, fem, gap, runner.folder("plate", "figures") / "plate.png")
    return numbers


def text(n):
    return f"""Section 5 of the paper: a rigid cylinder hits the edge of an elastic plate at 32 m/s. The paper compares with Abaqus, by curves without
numbers. The finite-element reference is therefore computed here with dolfinx (3-D, finite strain, elements of {FINE} mm, contact by Lagrange multipliers:
[validation/plate/fem.py](../validation/plate/fem.py); its convergence is shown [below](#finite-elements)).

![Centre of the plate, velocity of the cylinder, force, and displacement of the cylinder, against time: all curves](../validation/figures/plate.png)

Figures 13 to 17 of the paper, redrawn: [plate_impact](../cases/plate_impact/README.md#figures). There are three curves of perimpact: the deck (panels of 1 mm, contact radius half a spacing, where the material ends); the original
method of peridynamics with the same contact radius (`analytic`: no panels, the cylinder's axis is known); and the original method as published, where contact begins when the centre of
a particle enters. Sources of the differences:

- **Contact radius.** Without it the cylinder must first travel half a spacing, 0.5 mm or 15.6 µs at 32 m/s, which delays everything. At 200 µs the displacement of the centre
  is {1e3 * n["original centre"]:.2f} mm instead of {1e3 * n["centre"]:.2f} mm. Finite elements with a gap of 0.5 mm give {1e3 * n["fem_2mm_gap centre"]:.2f} mm: the gap alone explains the difference.
- **Panels.** With panels of 1 mm the difference from the method without panels is {1e6 * n["from analytic"]:.1f} µm at most over all times; they lie up to 5 µm below the cylinder.
- **Response.** Impactor and particles in contact have one velocity at the end of a step ([response](theory/contact_response.md#one-velocity)). Contact dissipates {n["contact dissipation"]:.2f} J of 803.84 J, the
  kinetic energy of approach of the particles in contact. Finite elements of 2 mm, whose edge nodes have the mass of a layer of particles, lose {n["lost"]:.2f} J. In the paper the reaction acts on the impactor
  one step later, which adds energy, of first order in the step. Finite elements with that delay gain {n["late gain"]:.2f} J at twice the
  step, and end with {n["fem_2mm_late v200"]:.2f} m/s instead of {n["fem_2mm v200"]:.2f} m/s, the centre {1e3 * (n["fem_2mm_late centre"] - n["fem_2mm centre"]):+.3f} mm further.
- **Mesh.** The final velocity depends on it most, in finite elements too: {n[f"fem_{COARSE}mm v200"]:.2f} m/s with {COARSE} mm, {n[f"fem_{FINE}mm v200"]:.2f} m/s with {FINE} mm."""


def rows():
    n = reference()
    fem, gap = f"finite elements, dolfinx, {FINE} mm", "finite elements, dolfinx, 2 mm, gap of 0.5 mm"
    plane = "a modulus 10 % too small would be detected, since it changes both by 1 to 2 %"
    return [
        Row("displacement of the plate's centre at 200 µs", fem, "centre", "mm", Within(n[f'fem_{FINE}mm centre'], 0.01, True), "half a microsecond of delay; " + plane),
        Row("displacement of the cylinder at 200 µs", fem, "cylinder", "mm", Within(n[f'fem_{FINE}mm cylinder'], 0.015, True), "panels of 1 mm lie 5 µm below the cylinder, 0.2 %; " + plane),
        Row("velocity of the cylinder at 50 µs", fem, "v50", "m/s", Within(n[f'fem_{FINE}mm v50'], 0.4), "0.9 µs of delay at the largest force"),
        Row("velocity of the cylinder at 200 µs", fem, "v200", "m/s", Within(n[f'fem_{FINE}mm v200'], 0.2), "reflected waves determine the last µs of contact; finite elements of 4 and 2 mm differ by as much"),
        Row("largest force, mean over 1 µs", fem, "force", "MN", Within(n[f'fem_{FINE}mm force'], 0.03, True), "single impulses within a microsecond"),
        Row("end of contact", fem, "end", "µs", Within(n[f'fem_{FINE}mm end'], 2e-6), "the force decays gradually: a row of 1 µs on either side"),
        Row("centre over all times, relative to its final value", fem, "centre, all times", "%", AtMost(0.01), "as at 200 µs"),
        Row("velocity over all times", fem, "velocity, all times", "m/s", AtMost(0.4), "0.9 µs of delay at the largest force"),
        Row("central line along x at 200 µs", fem, "line x", "%", AtMost(0.01), "as for the centre"),
        Row("central line along y at 200 µs", fem, "line y", "%", AtMost(0.01), "as for the centre"),
        Row("momentum, at all times", "1.57 kg · 32 m/s", "momentum", "small", AtMost(1e-10), "rounding of 180 000 particles over 2000 steps"),
        Row("contact dissipation", "finite elements, dolfinx, 2 mm: half an element at the edge has the mass of a layer of particles", "contact dissipation", "J", Within(n["lost"], 0.25, True),
            "particles, like nodes, come into contact a few at a time: the number at approach velocity depends on the mesh"),
        Row("FCCDA against the original method, largest difference of any displacement", "`analytic`", "from analytic", "µm", AtMost(3 * SAGITTA), "three times the depth Δ_m²/(8R) of a panel below the cylinder"),
        Row("original method as published: centre", gap, "original centre", "mm", Within(n["fem_2mm_gap centre"], 0.02, True), "as above; a delay of a row is 1 % here"),
        Row("original method as published: cylinder", gap, "original cylinder", "mm", Within(n["fem_2mm_gap cylinder"], 0.02, True), "as above"),
        Row("its velocity over all times", gap, "original velocity, all times", "m/s", AtMost(0.4), "as above"),
        Row("time of its first force", "0.5 mm / 32 m/s = 15.6 µs", "delay", "µs", Within(16e-6, 1.01e-6), "a row of history"),
    ]  # fmt: skip
