"""An ice sphere on a rigid plate: exactly known limits, Hertz contact, and measured impulses."""

from rows import AtMost, Between, Row, Within
from runner import script_of

TITLE = "An ice sphere hits a plate"
LONG = False
DECK, OBLIQUE, CRUSHED = (f"cases/ice_sphere/{deck}.yaml" for deck in ("deck", "oblique", "crushed"))
STRETCH, SYMMETRIC = "bodies.ice.material.critical_stretch", "bodies.ice.failure.compression=symmetric"
UNBROKEN = "bodies.ice.material={model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.25, density: 900}"


def measure(runner):
    script = script_of("cases/ice_sphere/measure.py")

    def found(name, deck, *settings):
        return script.measure(runner.run("ice_sphere", name, deck, *settings))

    dust = found("dust", DECK, f"{STRETCH}=1e-12", SYMMETRIC)
    unbroken = found("unbroken", DECK, UNBROKEN, "time.end=80 ms")
    weak = found("stretch_0.002_symmetric", DECK, f"{STRETCH}=0.002", SYMMETRIC)
    tension = found("stretch_0.002", DECK, f"{STRETCH}=0.002")
    oblique = found("hertz_oblique_40", OBLIQUE, "bodies.ice.spacing=0.025", "output.history_interval=0.05 ms", "output.frames=0")
    crushed = found("crushed_20", CRUSHED)
    halved = found("crushed_20_step_2", CRUSHED, "time.step=9.5 us")
    in_contact = found("crushed_in_contact_20", CRUSHED, "contact.impactors.crushing_pressure=2.3 MPa")
    return {
        "dust": dust["impulse [-]"],
        "unbroken": unbroken["impulse [-]"],
        "crushed": weak["impulse [-]"],
        "tension": tension["impulse [-]"],
        "hertz peak": oblique["peak over Hertz [-]"],
        "hertz duration": oblique["duration over Hertz [-]"],
        "crushed ice": crushed["impulse [-]"],
        "crushed energy": crushed["energy balance error [-]"],
        "crushed energy falls": halved["energy balance error [-]"] / crushed["energy balance error [-]"],
        "crushed peak": crushed["peak, 1 ms [N]"] / 1e6,
        "crushed peak changes": halved["peak, 1 ms [N]"] / crushed["peak, 1 ms [N]"],
        "crushed in contact": in_contact["p_c [Pa]"] / 2.3e6,
        "crushed in contact, time": in_contact["time to 90 % over the formula's [-]"],
        "crushed flow changes": halved["plastic dissipation [-]"] / crushed["plastic dissipation [-]"],
    }


def text(n):
    return f"""All variants: [the case](../cases/ice_sphere/README.md). The impulse over m v is 1 without rebound and 2 for full rebound. If bonds break in tension only, it is
{n["tension"]:.2f} at a critical stretch of 0.002, more than was measured: ice crushes. [Ice that
is crushed](theory/ice_plasticity.md#crushed-ice) has a peak force of {n["crushed peak"]:.2f} MN over 1 ms."""


def rows():
    hertz = "H. Hertz; K. L. Johnson, *Contact Mechanics* (1985), 11.4"
    return [
        Row("ice without strength: impulse over m v", "momentum of the ice, no rebound", "dust", "exact", Within(1, 1e-8), "rounding: each particle stops"),
        Row("ice that never breaks: impulse over m v", "2, less the energy in vibration", "unbroken", "", Between(1.9, 2), "2 is full rebound; at 20 across 4 % remain in vibration"),
        Row("ice that also breaks in compression, stretch 0.002: impulse over m v", "Sun, Lam and others, 149 tests: 0.8 to 1.12", "crushed", "", Between(0.8, 1.12), "the range of the tests"),
        Row("ice that is crushed, specimens' constants: impulse over m v", "Sun, Lam and others, 149 tests: 0.8 to 1.12", "crushed ice", "", Between(0.8, 1.12), "the range of the tests"),
        Row("ice that is crushed: energy balance error over the initial kinetic energy", "energy balance", "crushed energy", "small", AtMost(1e-3), "flow, and contact between fragments, of first order in the step"),
        Row("the same at half the step over that at the full step", "first order in the step: 0.5", "crushed energy falls", "", Within(0.5, 0.25), "fragments differ between the runs"),
        Row("ice that is crushed: peak force at half the step over that at the full step", "independent of the step", "crushed peak changes", "", Within(1, 0.1), "stresses return to within 5 % of the strength, and fragments differ between the runs"),
        Row("the same: plastic dissipation", "independent of the step", "crushed flow changes", "", Within(1, 0.1), "as above"),
        Row("ice that is crushed in contact: pressure p_c of the plastic sphere that loses half of its momentum in the same time, over crushing_pressure", "F = 2πR p_c d", "crushed in contact", "", Within(1, 0.15), "layers of the lattice, parallel to the plate, are crushed one after the other"),
        Row("the same: time in which it loses 90 % of its momentum, over that of the formula", "F = 2πR p_c d", "crushed in contact, time", "", Within(1, 0.15), "half of the sphere is in other fragments by then"),
        Row("peak force over Hertz, 40 across, oblique lattice", hertz, "hertz peak", "", Within(1, 0.05), "the contact radius is a quarter of the sphere's, and waves need a sixth of the contact time to cross the sphere: a few per cent at best"),
        Row("duration over Hertz, 40 across, oblique lattice", hertz, "hertz duration", "", Within(1, 0.05), "as above"),
    ]  # fmt: skip
