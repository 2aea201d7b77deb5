#!/usr/bin/python3
"""Properties of sea ice from temperature and salinity, for ice.md: writes its tables and its figure.

    docs/theory/ice.py
"""

import re
from math import exp, sqrt
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = HERE / "ice.md"
COLDEST, WARMEST = -22.9, -0.5  # of Frankenstein and Garner's fit [°C]


def brine_volume(temperature, salinity):
    """Share of the volume that is brine; °C and parts per thousand."""
    assert COLDEST <= temperature <= WARMEST
    return 1e-3 * salinity * (49.185 / abs(temperature) + 0.532)


def flexural_strength(brine):
    return 1.76e6 * exp(-5.88 * sqrt(brine))  # [Pa]


def youngs_modulus(brine):
    return 10e9 * (1 - 3.51 * brine) - 1e9  # [Pa]


# Timco and Frederking (1990): factor [MPa] and the porosity [‰] without strength, by the kind of ice and the direction of the load
COMPRESSION = {"columnar, along the sheet": (37, 270), "columnar, across the sheet": (160, 200), "granular": (49, 280)}
SLOWEST, FASTEST = 1e-7, 1e-3  # [1/s] of their fit
COLUMNS = (("columnar, along the sheet", "1e-4"), ("columnar, along the sheet", "1e-3"), ("granular", "1e-3"), ("columnar, across the sheet", "1e-3"))  # of the table


def compressive_strength(porosity, strain_rate, kind="columnar, along the sheet"):
    """[Pa] from the share of the volume that is brine and air, and the strain rate [1/s]."""
    assert SLOWEST <= strain_rate <= FASTEST
    factor, most = COMPRESSION[kind]
    return 1e6 * factor * strain_rate**0.22 * (1 - sqrt(1e3 * porosity / most))


def critical_stretch(strength, young, layers):
    return (1 - 1 / layers) * strength / young


def characteristic_length(young, thickness, poisson=0.25, water=1025.0, gravity=9.81):
    return (young * thickness**3 / (12 * (1 - poisson**2) * water * gravity)) ** 0.25  # [m]


def properties():
    lines = ["| T [°C] | S [‰] | ν_b | σ_f [MPa] | E [GPa] | σ_f/E | l [m], H = 1 m |", "|---|---|---|---|---|---|---|"]
    for temperature in (-2, -5, -10, -20):
        for salinity in (1, 4, 8):
            brine = brine_volume(temperature, salinity)
            strength, young = flexural_strength(brine), youngs_modulus(brine)
            numbers = f"{brine:.4f} | {1e-6 * strength:.3f} | {1e-9 * young:.2f} | {strength / young:.2e} | {characteristic_length(young, 1):.2f}"
            lines.append(f"| −{-temperature} | {salinity} | {numbers} |")
    return lines


def stretches():
    layers = (3, 4, 6, 8, 12)
    kinds = [("−2 °C, 8 ‰", brine_volume(-2, 8)), ("−5 °C, 4 ‰", brine_volume(-5, 4)), ("−20 °C, 1 ‰", brine_volume(-20, 1))]
    ices = [(name, flexural_strength(brine), youngs_modulus(brine)) for name, brine in kinds] + [("0.5 MPa, 1.8 GPa", 0.5e6, 1.8e9)]
    lines = ["| s_c | " + " | ".join(f"{n} layers" for n in layers) + " |", "|---" * (len(layers) + 1) + "|"]
    for name, strength, young in ices:
        lines.append(f"| {name} | " + " | ".join(f"{critical_stretch(strength, young, n):.3e}" for n in layers) + " |")
    return lines


def compression():
    lines = ["| T [°C] | S [‰] | ν_b | " + " | ".join(f"{kind}, {rate} 1/s" for kind, rate in COLUMNS) + " |", "|---" * (3 + len(COLUMNS)) + "|"]
    for temperature in (-2, -5, -10, -20):
        for salinity in (1, 4, 8):
            brine = brine_volume(temperature, salinity)
            strengths = [compressive_strength(brine, float(rate), kind) if 1e3 * brine < COMPRESSION[kind][1] else 0 for kind, rate in COLUMNS]
            lines.append(f"| −{-temperature} | {salinity} | {brine:.4f} | " + " | ".join(f"{1e-6 * strength:.2f}" for strength in strengths) + " |")
    return lines


def page(text):
    """The page with its tables updated, each between <!-- NAME --> and <!-- end -->."""
    kinds = {"properties": properties, "stretches": stretches, "compression": compression}
    return re.sub(r"<!-- (properties|stretches|compression) -->\n(?:[^<]*?\n)?<!-- end -->", lambda found: "\n".join([f"<!-- {found[1]} -->", *kinds[found[1]](), "<!-- end -->"]), text)


def figure():
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": 13})
    temperatures = [COLDEST + (WARMEST - COLDEST) * i / 400 for i in range(401)]
    drawn, (strength, modulus) = plt.subplots(1, 2, figsize=(10, 4.8), layout="constrained")
    for salinity, color in ((1, "C0"), (4, "C2"), (8, "C1"), (12, "C3")):
        warm = [t for t in temperatures if youngs_modulus(brine_volume(t, salinity)) > 0]
        strength.plot(warm, [1e-6 * flexural_strength(brine_volume(t, salinity)) for t in warm], color, lw=2.2)
        modulus.plot(warm, [1e-9 * youngs_modulus(brine_volume(t, salinity)) for t in warm], color, lw=2.2, label=f"{salinity} ‰")
    strength.axhspan(0.3, 0.7, color="0.5", alpha=0.15, lw=0)
    strength.annotate("usual in design", (-22.5, 0.32), fontsize=12, color="0.35")
    strength.set(title="flexural strength [MPa]", xlabel="temperature of the ice [°C]", ylim=(0, None))
    modulus.set(title="Young's modulus [GPa]", xlabel="temperature of the ice [°C]", ylim=(0, None))
    modulus.legend(title="salinity", frameon=False, loc="lower left")
    for axes in (strength, modulus):
        axes.grid(alpha=0.3)
        axes.set_xlim(COLDEST, WARMEST)
    drawn.suptitle("Warm and salty ice is weak, and soft near melting", fontsize=14)
    drawn.savefig(HERE / "figures/ice_properties.png", dpi=100)


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text()))
    figure()
