"""Surfaces that deform, and structures of finite elements or modes behind them."""

import sys

from rows import AtLeast, AtMost, Exactly, Row, Within, read_records
from runner import ROOT, script_of

TITLE = "Deformable structures"
LONG = True
CROSSINGS = ROOT / "benchmarks/results/deforming_crossings_intel_r_xeon_r_processor_family_6_model_167.csv"
RATIOS = {"equal": 1.0, "half": 0.5}


def gathered():
    rows = read_records(CROSSINGS)

    def total(column):
        return float(sum(int(row[column]) for row in rows))

    return {"crossings": total("crossings"), "missed": total("missed"), "invented": total("invented")}


def measure(runner):
    sys.path.insert(0, str(runner.program.parent / "python"))
    numbers = {}
    bar = script_of("cases/hull_panel/bar.py")
    for name, ratio in RATIOS.items():
        print(f"  structures/bars, {name}", flush=True)
        found = bar.run(ratio)
        reflected, transmitted, peak = bar.coefficients(found)
        numbers |= {f"{name}: reflected": reflected, f"{name}: transmitted": ratio * transmitted, f"{name}: peak": peak, f"{name}: momentum": found["momentum"],
                    f"{name}: energy": found["energy"]}  # fmt: skip
    print("  structures/moving load", flush=True)
    verify, panel = script_of("cases/hull_panel/verify.py"), script_of("cases/hull_panel/panel.py")
    model = panel.Model(8)
    found = verify.move_load(model)
    deflection, stress = verify.superpose_moving_load(model, model.modes(verify.SHOWN), found["times"])
    numbers |= {"modes: deflection": verify.deviation(found["deflection"], deflection), "modes: stress": verify.deviation(found["stress"], stress),
                "load: momentum": found["impulse"], "load: energy": found["energy"]}  # fmt: skip
    impacts = script_of("cases/hull_panel/impacts.py")
    folder = runner.folder("structures", "impacts")
    folder.mkdir(parents=True, exist_ok=True)
    smooth = script_of("cases/hull_panel/figures.py").smooth
    force = {}
    for kind in ("rigid", "modal", "finite"):
        print(f"  structures/sphere, {kind}", flush=True)
        found = impacts.run("sphere", kind, model, folder)
        force[kind] = smooth(found)[1].max()
        numbers |= {f"{kind}: energy": abs(found["balance_error"]).max() / found["energy"][0], f"{kind}: momentum": found["residual"].max() / found["start"]}
    return numbers | {"modes: force": force["modal"] / force["finite"] - 1, "rigid: force": force["rigid"] / force["finite"] - 1}


def text(n):
    return f"""Contact with surfaces whose vertices move ([theory](theory/deforming_contact.md)), and ice that hits a stiffened panel, which is rigid, elastic by its modes, or
of finite elements that advance together with the ice ([hull_panel](../cases/hull_panel/README.md)). A rigid panel overestimates the force of a sphere of ice by
{100 * n["rigid: force"]:.0f} %. That a ball exchanges impulse and energy with a membrane that vibrates as the equations of motion have it is a unit test
(0.04 and 0.002 %, 1 % allowed)."""


def rows():
    count = "a count: none may be missed or invented"
    theory = "one-dimensional waves"
    case = "[hull_panel](../cases/hull_panel/README.md)"
    end = "the end of a peridynamic bar is softer over one horizon"
    return [
        Row("crossings of stretching, bending, folding and spinning surfaces", "[benchmark](../benchmarks/contact/deforming_crossings.cpp)", "crossings", "count", AtLeast(1_000_000), "rarer misses are not resolved"),
        Row("missed", "arithmetic of 113 binary digits over all triangles", "missed", "count", Exactly(0), count),
        Row("invented, on paths that cross nothing", "the same", "invented", "count", Exactly(0), count),
        Row("impulse reflected from elements to particles, equal impedances", theory, "equal: reflected", "%", Within(0, 0.02), end),
        Row("largest reflected stress", theory, "equal: peak", "%", AtMost(0.02), end),
        Row("impulse reflected, half the impedance", theory + ": (Z₂ − Z₁)/(Z₂ + Z₁)", "half: reflected", "%", Within(-1 / 3, 0.02), end),
        Row("impulse transmitted, half the impedance", theory + ": 2 Z₂/(Z₂ + Z₁)", "half: transmitted", "%", Within(2 / 3, 0.02), end),
        Row("momentum of both bars, over the impulse of the load", "momentum", "equal: momentum", "small", AtMost(1e-10), "rounding of sums over nodes and particles"),
        Row("energy of both bars, over the work of the load", "energy", "equal: energy", "small", AtMost(1e-3), "velocities of both codes are half a step apart in the record"),
        Row("240 modes under a moving load: deflection", case + ", finite elements", "modes: deflection", "%", AtMost(0.03), "modes left out bend the plating of a bay locally"),
        Row("modes hit by a sphere of ice: force", case + ", finite elements", "modes: force", "%", Within(0, 0.03), "as above"),
        Row("ice and finite elements: momentum, over m v", "momentum, with the reactions of the supports", "finite: momentum", "small", AtMost(1e-10), "rounding"),
        Row("ice and finite elements: energy, over that at the start", "energy", "finite: energy", "small", AtMost(0.01), "second order in the time step"),
        Row("ice and modes: energy, over that at the start", "energy", "modal: energy", "small", AtMost(0.01), "as above"),
    ]  # fmt: skip
