#!/usr/bin/python3
"""Draws the pictures of shapes.md: a hull and a propeller as `perimpact shape` makes them, and what their parameters mean.

    docs/guide/shapes_figure.py build/release/perimpact        half a minute; needs numpy and matplotlib
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scripts/results"))
from render import Scene  # noqa: E402

HULL = "hull --length 155 --breadth 23 --draft 9 --stem-angle 24deg --waterline-angle 22deg --edge-length 5 --bow-edge-length 1.5".split()
PROPELLER = "propeller --diameter 4.12 --pitch-ratio 0.76 --area-ratio 0.669 --hub-ratio 0.301 --edge-length 0.2 --blade-edge-length 0.06".split()
COLOURS = {"bow": (0.86, 0.42, 0.34), "side": (0.62, 0.68, 0.76), "stern": (0.55, 0.72, 0.60), "bilge": (0.90, 0.72, 0.42), "bottom": (0.98, 0.86, 0.80),
           "deck": (0.84, 0.84, 0.82), "hub": (0.62, 0.66, 0.72), "blade": (0.88, 0.70, 0.38)}
LINE, WATER, NOTE = "#30343a", "#4a86b8", "#b3412e"


def shape(program, folder, arguments):
    """Vertices, and the triangles of each part."""
    subprocess.run([program, "shape", *arguments, "-o", "shape.obj"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    vertices, parts = [], {}
    for line in (folder / "shape.obj").read_text().splitlines():
        word, *rest = line.split()
        if word == "v":
            vertices.append([float(number) for number in rest])
        elif word == "g":
            part = parts.setdefault(rest[0], [])
        elif word == "f":
            part.append([int(number) - 1 for number in rest])
    return np.array(vertices), parts


def draw(axis, vertices, parts, edge_width, **view):
    scene = Scene(**view)
    for name, panels in parts.items():
        colour = np.array(COLOURS[name.split("_")[0]])
        scene.add_panels(vertices, panels, colour, 0.45 * colour, edge_width)
    axis.imshow(scene.picture(fold=2))
    axis.set_axis_off()


def hull(program, folder):
    vertices, parts = shape(program, folder, HULL)
    figure, (whole, bow) = plt.subplots(2, 1, figsize=(10, 8.2), height_ratios=[1, 1.35])
    draw(whole, vertices, parts, 0.10, direction=(-0.45, 0.85, -0.24), up=(0, 0, 1), pixels_per_metre=11.6, width=2000, height=560, centre=(75, 0, -1.5))
    draw(bow, vertices, parts, 0.05, direction=(-0.45, 0.85, -0.24), up=(0, 0, 1), pixels_per_metre=23, width=2000, height=800, centre=(30, 0, -1.5))
    for axis, text in ((whole, "all of it, from below"), (bow, "bow: panels of 1.5 m, growing behind it to 5 m")):
        axis.set_title(text, fontsize=12, loc="left")
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLOURS[name]) for name in ("bow", "side", "stern", "bilge", "bottom")]
    whole.legend(handles, ("bow", "side", "stern", "bilge", "bottom"), ncol=5, fontsize=11, frameon=False, loc="upper right", bbox_to_anchor=(1, 1.15), borderaxespad=0)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.94, bottom=0.01, hspace=0.12)
    figure.savefig(HERE / "figures/shape_hull.png", dpi=105)


def measure(axis, start, end, text, offset=(0, 0), colour=NOTE):
    axis.annotate("", start, end, arrowprops={"arrowstyle": "<->", "color": colour, "lw": 1.1, "shrinkA": 0, "shrinkB": 0})
    middle = (np.array(start) + end) / 2 + offset
    axis.text(*middle, text, color=colour, fontsize=11, ha="center", va="center", bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})


def arc(axis, centre, radius, low, high, text, reach=1.25):
    angles = np.radians(np.linspace(low, high, 60))
    axis.plot(centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles), color=NOTE, lw=1.3)
    middle = np.radians((low + high) / 2)
    axis.text(centre[0] + reach * radius * np.cos(middle), centre[1] + reach * radius * np.sin(middle), text, color=NOTE, fontsize=11, ha="center", va="center")


def hull_parameters():
    length, breadth, draft, freeboard, bilge = 155, 23, 9, 6, 3
    stem, stern, entrance, run = np.radians([24, 35, 22, 30])
    power = 2
    figure, axes = plt.subplots(3, 1, figsize=(10, 8), height_ratios=[0.8, 1.0, 1.6])

    side = axes[0]
    corners = np.array([[-freeboard / np.tan(stem), freeboard], [draft / np.tan(stem), -draft], [length - draft / np.tan(stern), -draft],
                        [length + freeboard / np.tan(stern), freeboard], [-freeboard / np.tan(stem), freeboard]])
    side.fill(*corners.T, facecolor="#eef0f2", edgecolor=LINE, lw=1.6)
    side.axhline(0, color=WATER, lw=1)
    measure(side, (0, -13), (length, -13), "length")
    measure(side, (70, -draft), (70, 0), "draft", (8, 0))
    measure(side, (70, 0), (70, freeboard), "freeboard", (11, 0))
    arc(side, (0, 0), 17, -24, 0, "stem_angle", 1.75)
    arc(side, (length, 0), 12, 180, 215, "stern_angle", 2.0)
    side.set_title("from the side", loc="left", fontsize=12)

    plan = axes[1]
    bow, aft = power * breadth / 2 / np.tan(entrance), breadth / np.tan(run)
    x = np.linspace(0, length, 800)
    y = breadth / 2 * (1 - (1 - np.clip(x / bow, 0, 1)) ** power) * (1 - (1 - np.clip((length - x) / aft, 0, 1)) ** 2)
    plan.fill_between(x, -y, y, facecolor="#dfeaf3", edgecolor=WATER, lw=1.6)
    plan.axhline(0, color=LINE, lw=0.8, ls="-.")
    plan.plot([0, 24], [0, 24 * np.tan(entrance)], color=NOTE, lw=1.1)
    plan.plot([length, length - 19], [0, 19 * np.tan(run)], color=NOTE, lw=1.1)
    arc(plan, (0, 0), 18, 0, 22, "waterline_angle", 1.75)
    arc(plan, (length, 0), 14, 150, 180, "stern_\nwaterline_angle", 2.0)
    measure(plan, (80, -breadth / 2), (80, breadth / 2), "breadth")
    measure(plan, (0, -14), (bow, -14), "bow: fullness · breadth/2 / tan(waterline_angle)", (6, -3.5))
    plan.set_title("waterline", loc="left", fontsize=12)

    section = axes[2]
    z = np.linspace(-draft, freeboard, 600)
    into = np.maximum(0, bilge - draft - z)
    for flare, style in ((0, "-"), (12, "--")):
        half = breadth / 2 + z * np.tan(np.radians(flare)) - np.where(into > 0, bilge - np.sqrt(np.maximum(0, bilge**2 - into**2)), 0)
        outline = np.concatenate([np.column_stack([-half[::-1], z[::-1]]), np.column_stack([half, z]), [[-half[-1], z[-1]]]])
        section.plot(*outline.T, color=LINE, lw=1.6 if flare == 0 else 1.0, ls=style)
    section.axhline(0, color=WATER, lw=1)
    centre = np.array([breadth / 2 - bilge, bilge - draft])
    section.annotate("", centre + bilge * np.array([0.70, -0.714]), centre, arrowprops={"arrowstyle": "->", "color": NOTE, "shrinkA": 0, "shrinkB": 0})
    section.text(*(centre + (-2.3, 0.6)), "bilge_radius", color=NOTE, fontsize=11, ha="center")
    section.plot([breadth / 2] * 2, [freeboard, freeboard + 1.6], color=NOTE, lw=0.8)
    section.text(breadth / 2 + 1.6, 3.6, "flare", color=NOTE, fontsize=11)
    section.text(0, -draft + 0.7, "bottom", fontsize=11, ha="center", color=LINE)
    section.text(-6, freeboard - 1.3, "deck", fontsize=11, ha="center", color=LINE)
    section.set_title("midship section; dashed with a flare of 12 deg", loc="left", fontsize=12)
    section.set_xlim(-30, 30)

    side.set(xlim=(-18, 172), ylim=(-16, 8))
    plan.set(xlim=(-18, 172), ylim=(-20, 13))
    for axis in axes:
        axis.set_aspect("equal")
        axis.set_axis_off()
    figure.subplots_adjust(left=0.01, right=0.99, top=0.96, bottom=0.01, hspace=0.1)
    figure.savefig(HERE / "figures/shape_hull_parameters.png", dpi=105)


def propeller(program, folder):
    vertices, parts = shape(program, folder, PROPELLER)
    figure, axes = plt.subplots(1, 2, figsize=(10, 5))
    draw(axes[0], vertices, parts, 0.005, direction=(1, 0.001, 0), up=(0, 0, 1), pixels_per_metre=230, width=1000, height=1000, centre=(0, 0, 0))
    draw(axes[1], vertices, parts, 0.005, direction=(-0.55, -0.75, 0.35), up=(0, 0, 1), pixels_per_metre=230, width=1000, height=1000, centre=(0, 0, 0))
    for axis, text in zip(axes, ("from ahead: backs of the blades", "from astern, starboard and above: faces")):
        axis.set_title(text, fontsize=12)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.93, bottom=0.01, wspace=0.02)
    figure.savefig(HERE / "figures/shape_propeller.png", dpi=105)


def propeller_parameters():
    """A blade of the B4-66.9 laid flat, its section at 0.7 R, and the propeller from the side."""
    radius = np.array([0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0])
    chord_table = np.array([1.662, 1.882, 2.050, 2.152, 2.187, 2.144, 1.970, 1.582, 0])
    leading_table = np.array([0.617, 0.613, 0.601, 0.586, 0.561, 0.524, 0.463, 0.351, 0.239])
    half, hub, share = 2.06, 0.62, 0.669 / 4
    figure, (outline, side, section) = plt.subplots(1, 3, figsize=(10, 4.4), width_ratios=[0.85, 0.85, 1.3])

    r = 1 - np.linspace(np.sqrt(1 - 0.25), 0, 300) ** 2
    smooth = lambda table: np.polyval(np.polyfit(radius, table, 6), r)  # good to a line's width
    chord = 2 * half * share * np.sqrt(np.maximum(0, smooth(chord_table**2)))
    lead = chord * smooth(leading_table)
    outline.fill(np.concatenate([lead, (lead - chord)[::-1]]), half * np.concatenate([r, r[::-1]]), facecolor="#f3e3c3", edgecolor=LINE, lw=1.5)
    outline.fill([-1, 1, 1, -1], [0, 0, hub, hub], facecolor="#d5dae0", edgecolor=LINE, lw=1.2)
    outline.plot([0, 0], [0, half], color=LINE, lw=0.8, ls="-.")
    at = np.searchsorted(r, 0.7)
    measure(outline, (lead[at] - chord[at], 0.7 * half), (lead[at], 0.7 * half), "chord")
    measure(outline, (1.2, 0), (1.2, half), "diameter\n/2", (0, 0.62))
    outline.text(0, 0.3, "hub", fontsize=11, ha="center", va="center", bbox={"facecolor": "#d5dae0", "edgecolor": "none", "pad": 1})
    outline.text(lead[at] + 0.0, 1.95, "leading\nedge", fontsize=9, ha="center")
    outline.text(-0.98, 1.75, "trailing\nedge", fontsize=9, ha="center")
    outline.set_title("a blade laid flat", fontsize=12)
    outline.set(xlim=(-1.25, 1.5), ylim=(-1.05, 2.3))

    rake, length = np.radians(15), 1.236
    side.fill([-length / 2, length / 2, length / 2, -length / 2], [-hub, -hub, hub, hub], facecolor="#d5dae0", edgecolor=LINE, lw=1.2)
    side.annotate("", (1.35, 0), (-0.9, 0), arrowprops={"arrowstyle": "->", "color": LINE, "ls": "-."})
    side.text(1.1, 0.12, "ahead", fontsize=10, ha="center")
    side.plot([0, 0], [0, half], color=LINE, lw=0.8, ls="-.")
    side.plot([-hub * np.tan(rake), -half * np.tan(rake)], [hub, half], color="#b07d20", lw=6, solid_capstyle="round")
    arc(side, (0, 0), 1.45, 90, 105, "rake", 1.14)
    measure(side, (-length / 2, -0.85), (length / 2, -0.85), "hub_length")
    measure(side, (0.85, -hub), (0.85, hub), "hub_ratio\n· diameter", (0.25, -0.3))
    side.set_title("from the side", fontsize=12)
    side.set(xlim=(-1.15, 1.6), ylim=(-1.05, 2.3))

    places = np.array([-1, -0.95, -0.9, -0.8, -0.7, -0.6, -0.5, -0.4, -0.2, 0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 1])
    rise = np.array([0, 0.0975, 0.19, 0.36, 0.51, 0.64, 0.75, 0.84, 0.96, 1, 0.9675, 0.866, 0.785, 0.684, 0.5615, 0.414, 0.33, 0.2337, 0.124, 0])
    chord, thickness, thickest, lift = 1.0, 0.16, 0.443, 0.1  # thicker than it is, to be seen
    s = np.where(places > 0, 1 - thickest + places * thickest, (1 - thickest) * (1 + places))
    back = rise * thickness * (1 - lift) + lift * thickness
    pitch = np.radians(19.1)
    turn = np.array([[np.cos(pitch), -np.sin(pitch)], [np.sin(pitch), np.cos(pitch)]])
    body = turn @ np.array([np.concatenate([s, s[::-1]]), np.concatenate([back, 0 * s])])
    section.fill(*body, facecolor="#f3e3c3", edgecolor=LINE, lw=1.5)
    section.plot([0, 1.1], [0, 0], color=LINE, lw=0.8, ls="-.")
    arc(section, (0, 0), 0.62, 0, 19.1, "pitch angle\natan(pitch/(2πr))", 1.36)
    crest = np.array([1 - thickest, 0])
    measure(section, tuple(turn @ crest), tuple(turn @ (crest + (0, thickness))), "")
    section.text(*(turn @ (crest + (-0.02, 0.24))), "thickness", color=NOTE, fontsize=11, ha="center")
    section.annotate("edge_thickness\n· thickness", turn @ np.array([1, 0.008]), (0.99, 0.62), color=NOTE, fontsize=11, ha="center",
                     arrowprops={"arrowstyle": "->", "color": NOTE})
    section.text(*(turn @ np.array([0.27, 0.14])), "back", fontsize=10, rotation=35, ha="center")
    section.text(*(turn @ np.array([0.33, -0.055])), "face", fontsize=10, rotation=19, ha="center")
    section.set_title("section at 0.7 R, drawn thicker than it is", fontsize=12)
    section.set(xlim=(-0.06, 1.2), ylim=(-0.62, 0.78))

    for axis in (outline, side, section):
        axis.set_aspect("equal")
        axis.set_axis_off()
    figure.subplots_adjust(left=0.01, right=0.99, top=0.92, bottom=0.01, wspace=0.03)
    figure.savefig(HERE / "figures/shape_propeller_parameters.png", dpi=105)


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        hull_parameters()
        propeller_parameters()
        hull(program, Path(folder))
        propeller(program, Path(folder))


if __name__ == "__main__":
    main(str(Path(sys.argv[1]).resolve()))
