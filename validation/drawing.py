"""The figures of the page, with matplotlib."""

INK, RED, BLUE, QUIET, GOLD = "#1d2733", "#c8102e", "#2b6cb0", "#8a97a5", "#c98a12"
STYLE = {
    "font.size": 10, "font.family": "DejaVu Sans", "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK, "axes.linewidth": 0.7, "xtick.color": INK,
    "ytick.color": INK, "axes.spines.top": False, "axes.spines.right": False, "axes.titlesize": 10, "axes.titlelocation": "left", "legend.frameon": False,
    "axes.grid": True, "grid.color": "#e4e8ec", "grid.linewidth": 0.6, "axes.axisbelow": True, "figure.constrained_layout.use": True,
}  # fmt: skip


def drawn(path, rows, columns, size):
    """Figure and axes; savefig by the caller."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update(STYLE)
    path.parent.mkdir(parents=True, exist_ok=True)
    return plt.subplots(rows, columns, figsize=size, squeeze=False)


def plate(histories, fem, gap, path):
    """Centre, cylinder, velocity and force over time: perimpact's runs as lines, finite elements as circles."""
    import numpy as np

    figure, axes = drawn(path, 2, 2, (10, 7))
    arrays = {name: {column: np.array(values) for column, values in history.items()} for name, history in {**histories, "fem": fem, "gap": gap}.items()}

    def travel(history):
        return history["cylinder.position_y [m]"] - history["cylinder.position_y [m]"][0]

    panels = [
        ("displacement of the plate's centre [mm]", lambda h: 1e3 * h["centre.displacement_y [m]"]),
        ("displacement of the cylinder [mm]", lambda h: 1e3 * travel(h)),
        ("velocity of the cylinder [m/s]", lambda h: h["cylinder.velocity_y [m/s]"]),
        ("contact force, mean over 1 µs [MN]", lambda h: 1e-6 * h["cylinder.force_y [N]"]),
    ]
    lines = {
        "panel_1mm": ("perimpact, panels of 1 mm", {"color": BLUE, "lw": 3.2, "alpha": 0.55}),
        "analytic": ("perimpact, original method (no panels)", {"color": INK, "lw": 1.1, "ls": (0, (4, 2))}),
        "original": ("the same, contact radius 0 as in the paper", {"color": GOLD, "lw": 1.8}),
    }
    circles = {"fem": ("finite elements", RED), "gap": ("finite elements, gap of half a spacing", GOLD)}
    for axis, (title, of) in zip(axes.flat, panels):
        for name, (label, style) in lines.items():
            axis.plot(1e6 * arrays[name]["time [s]"], of(arrays[name]), label=label, **style)
        for name, (label, colour) in circles.items():
            axis.plot(1e6 * arrays[name]["time [s]"][::8], of(arrays[name])[::8], "o" if name == "fem" else "s", ms=4, mfc="white", mec=colour, mew=1.1, label=label, zorder=5)
        axis.set(title=title, xlim=(0, 200))
    for axis in axes[1]:
        axis.set_xlabel("time [µs]")
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=2, bbox_to_anchor=(0.5, 1.11))
    figure.savefig(path, dpi=100, bbox_inches="tight")


def panels(off, bound, share, path):
    """Accuracy and cost against the size of panels."""
    figure, ((left, right),) = drawn(path, 1, 2, (10, 3.9))
    sizes = [float(size) for size in off]
    left.loglog(sizes, [1e6 * bound(size) for size in off], color=QUIET, ls="--", lw=1.2, label=r"allowed: $3\,\Delta_m^2/(8R)$")
    left.loglog(sizes, [1e6 * value for value in off.values()], "o-", color=BLUE, ms=6, label="swept")
    left.set(title="off the original method, at any time [µm]", xlabel="size of panels Δ$_m$ [mm]")
    right.bar(range(len(sizes)), [100 * value for value in share.values()], color=BLUE, width=0.6)
    right.set_xticks(range(len(sizes)), [f"{size:g}" for size in sizes])
    right.set(title="contact's share of the run [%]", xlabel="size of panels Δ$_m$ [mm]")
    right.grid(axis="x", visible=False)
    left.set_xticks(sizes, [f"{size:g}" for size in sizes])
    left.minorticks_off()
    left.legend()
    figure.savefig(path, dpi=100)
