#!/usr/bin/python3
"""Draws the figures of this case from the folder that variants.sh fills:

    cases/ice_sphere/figures.py results/ice_sphere      writes figures/*.png beside this script

hertz     force against time of a sphere that does not break, at three spacings, normal to a lattice axis and oblique, with Hertz
impulse   impulse over m v against the critical stretch, with the measured range
crushed   force against time of ice that is crushed and of ice that fails in tension only, with the theory of a plastic sphere
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import RADIUS, WINDOW, hertz, measure, options, plate_force, run, window_means  # noqa: E402

CASE = Path(__file__).resolve().parent
MEASURED = 0.8, 1.12  # source: README.md
STRENGTH = 2.3e6  # [Pa] of crushed.yaml, uniaxial compression
STRETCHES = "0.032", "0.01", "0.002", "3.2e-4"


def save(figure, name):
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures" / f"{name}.png", dpi=100)
    plt.close(figure)


def hertz_curve(mass, speed, steps=4000):
    """Time [s] and force [N] of m d'' = -k d^(3/2), leapfrog."""
    peak, duration, approach = hertz(mass, speed)
    stiffness, dt = peak / approach**1.5, duration / steps
    d, v, force = 0.0, speed, []
    for _ in range(steps):
        v -= 0.5 * dt * stiffness * max(d, 0) ** 1.5 / mass
        d += dt * v
        v -= 0.5 * dt * stiffness * max(d, 0) ** 1.5 / mass
        force.append(stiffness * max(d, 0) ** 1.5)
    return dt * np.arange(1, steps + 1), np.array(force)


def draw_hertz(results):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), sharex=True, sharey=True, layout="constrained")
    for axis, prefix, title in zip(axes, ("hertz", "hertz_oblique"), ("normal to a lattice axis", "oblique, along (1, 2, 3)")):
        for across, colour in ((20, "#8fb8d8"), (40, "#2a6fb0"), (60, "#12355b")):
            times, steps, force, mass, speed, *_ = plate_force(results / f"{prefix}_{across}")
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
    kinds = (("", "tension only", "#2a6fb0", "o-"), ("_contact", "tension only, fragment contact", "#2a6fb0", "o:"),
             ("_symmetric", "symmetric", "#b3312c", "s-"), ("_symmetric_contact", "symmetric, fragment contact", "#b3312c", "s:"))
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


def plastic_sphere(mass, speed, pressure, end):
    """Time [s] and force [N] of F = 2πR p d until the sphere stops, then none."""
    stiffness = 2 * np.pi * RADIUS * pressure
    rate = np.sqrt(stiffness / mass)
    times = np.linspace(0, end, 2000)
    return times, np.where(rate * times < np.pi / 2, speed * np.sqrt(stiffness * mass) * np.sin(rate * times), 0)


def draw_crushed(results):
    figure, axes = plt.subplots(1, 3, figsize=(14, 4.2), sharex=True, layout="constrained")
    tension, crushed = ("stretch_3.2e-4_contact", "tension only", "#b3312c"), ("crushed_20", "crushed", "#2a6fb0")
    steps_and_spacing = (("crushed_20_step_2", "step/2", "#8fb8d8"), ("crushed_20_step_4", "step/4", "#9aa7b5"), ("crushed_40", "40 across", "#12355b"))
    in_contact = (("crushed_in_contact_20", "crushed in contact", "#1b6b36"), ("crushed_in_contact_40", "the same, 40 across", "#77bb88"))
    for axis, runs, title in zip(axes, ((tension, crushed), (crushed, *steps_and_spacing), in_contact), ("critical stretch 3.2e-4, 20 across", "rigid contact: time step and spacing", "crushed in contact")):
        for name, label, colour in runs:
            times, steps, force, mass, speed, *_ = plate_force(results / name)
            first = np.flatnonzero(force > 0)[0]
            middles, means = window_means(times, force, WINDOW, is_zero_before=True)
            axis.plot(1e3 * (middles - times[first] + steps[first]), means / 1e6, color=colour, label=label)
        for multiple, style in ((1, ":"), (3, "--")):
            theory = plastic_sphere(mass, speed, multiple * STRENGTH, 20e-3)
            axis.plot(1e3 * theory[0], theory[1] / 1e6, color="#555555", lw=0.9, ls=style, label=f"plastic sphere, p$_c$ = {multiple if multiple > 1 else ''} σ$_c$")
        axis.set(title=title, xlabel="time from first contact [ms]", xlim=(0, 20), ylim=(0, None))
        axis.grid(alpha=0.25)
        axis.legend(frameon=False, fontsize=9)
    axes[0].set_ylabel("force on the plate, mean over 1 ms [MN]")
    save(figure, "crushed")


def main():
    results = options(__doc__).parse_args().results
    draw_hertz(results)
    draw_impulse(results)
    draw_crushed(results)


if __name__ == "__main__":
    run(main)
