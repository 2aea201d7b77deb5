#!/usr/bin/python3
"""Draws the figures of this case from the folder that variants.sh fills:

    cases/ice_sphere/figures.py results/ice_sphere      writes figures/*.png beside this script

hertz     force against time of a sphere that does not break, at three spacings, normal to a lattice axis and oblique, with Hertz
impulse   impulse over m v against the critical stretch, with the measured range
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import blow, hertz, measure  # noqa: E402

CASE = Path(__file__).resolve().parent
MEASURED = 0.8, 1.12  # source: README.md
STRETCHES = "0.032", "0.01", "0.002", "3.2e-4"


def save(figure, name):
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures" / f"{name}.png", dpi=100)
    plt.close(figure)


def hertz_curve(mass, speed, steps=4000):
    """Time [s] and force [N] of m d'' = -k d^(3/2), leapfrog."""
    largest, long, approach = hertz(mass, speed)
    stiffness, dt = largest / approach**1.5, long / steps
    d, v, force = 0.0, speed, []
    for _ in range(steps):
        v -= 0.5 * dt * stiffness * max(d, 0) ** 1.5 / mass
        d += dt * v
        v -= 0.5 * dt * stiffness * max(d, 0) ** 1.5 / mass
        force.append(stiffness * max(d, 0) ** 1.5)
    return dt * np.arange(1, steps + 1), np.array(force)


def draw_hertz(results):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), sharex=True, sharey=True, layout="constrained")
    for axis, prefix, title in zip(axes, ("hertz", "hertz_oblique"), ("along an axis of the lattice", "askew, along (1, 2, 3)")):
        for across, colour in ((20, "#8fb8d8"), (40, "#2a6fb0"), (60, "#12355b")):
            times, steps, force, mass, speed, _ = blow(results / f"{prefix}_{across}")
            first = np.flatnonzero(force > 0)[0]
            middles = times - steps / 2 - (times[first] - steps[first])
            axis.plot(1e3 * middles, force / 1e6, color=colour, label=f"{across} across")
        times, force = hertz_curve(mass, speed)
        axis.plot(1e3 * times, force / 1e6, color="#b3312c", ls="--", label="Hertz")
        axis.set(title=title, xlabel="time from first contact [ms]", xlim=(0, 5), ylim=(0, None))
        axis.grid(alpha=0.25)
    axes[0].set_ylabel("force on the plate [MN]")
    axes[1].legend(frameon=False)
    save(figure, "hertz")


def draw_impulse(results):
    figure, axis = plt.subplots(figsize=(9, 4.6), layout="constrained")
    axis.axhspan(*MEASURED, color="#e7dcc3", label="measured, Hopkinson bar")
    kinds = (("", "tension only", "#2a6fb0", "o-"), ("_pushes", "tension only, debris pushes debris", "#2a6fb0", "o:"),
             ("_symmetric", "symmetric", "#b3312c", "s-"), ("_symmetric_pushes", "symmetric, debris pushes debris", "#b3312c", "s:"))
    for ending, label, colour, style in kinds:
        ratios = [measure(results / f"stretch_{stretch}{ending}")["impulse [-]"] for stretch in STRETCHES]
        axis.plot([float(stretch) for stretch in STRETCHES], ratios, style, color=colour, label=label)
    for name, label, side, place in (("unbroken", "never breaks", "bottom", 2.6e-3), ("dust", "dust", "top", 2.6e-2)):
        ratio = measure(results / name)["impulse [-]"]
        axis.axhline(ratio, color="#555555", lw=0.9, ls="--")
        axis.text(place, ratio, f"{label}: {ratio:.2f}", fontsize=10, va=side)
    axis.set(xscale="log", xlabel="critical stretch", ylabel="impulse/(m v)", xlim=(2.5e-4, 0.04), ylim=(0.7, 2.1))
    axis.legend(frameon=False, loc="upper left", bbox_to_anchor=(0.0, 0.92))
    save(figure, "impulse")


def main():
    results = Path(sys.argv[1])
    draw_hertz(results)
    draw_impulse(results)


if __name__ == "__main__":
    main()
