"""The figures of this folder, from the output of the examples:

    sph_splash 0.0167 10 && fem_bar 50        in some folder
    pictures.py FOLDER                        writes sph_splash.png and fem_bar.png beside this script
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

INK, PALE = "#22313f", "#8496a5"
plt.rcParams.update({"font.size": 8, "text.color": INK, "axes.edgecolor": PALE, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK})


def read_vtk(path):
    """Points, polygons, and arrays by name."""
    words = path.read_text().split()
    at = words.index("POINTS")
    count = int(words[at + 1])
    points = np.array(words[at + 3 : at + 3 + 3 * count], float).reshape(-1, 3)
    polygons, arrays = [], {}
    if "POLYGONS" in words:
        at = words.index("POLYGONS") + 3
        while at < len(words):
            corners = int(words[at])
            polygons.append([int(word) for word in words[at + 1 : at + 1 + corners]])
            at += 1 + corners
    for at, word in enumerate(words):
        if word == "SCALARS":
            arrays[words[at + 1]] = np.array(words[at + 6 : at + 6 + count], float)
    return points, polygons, arrays


def save(figure, name):
    """Saves with 256 colours: a third of the size."""
    path = Path(__file__).parent / name
    figure.savefig(path)
    Image.open(path).convert("RGB").quantize(256).save(path, optimize=True)


def splash(folder):
    hull, polygons, _ = read_vtk(folder / "splash_hull.vtk")
    azimuth, elevation = np.radians(-54), np.radians(18)
    view = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    faces = [(hull[p[0]], np.cross(hull[p[1]] - hull[p[0]], hull[p[2]] - hull[p[0]])) for p in polygons]
    figure = plt.figure(figsize=(9, 3), dpi=100)
    for column, frame in enumerate((1, 3, 5, 8)):
        points, _, arrays = read_vtk(folder / f"splash_{frame:03d}.vtk")
        axes = figure.add_axes([0.25 * column - 0.025, 0.08, 0.3, 0.9], projection="3d", computed_zorder=False)
        axes.patch.set_alpha(0)
        axes.add_collection3d(Poly3DCollection([hull[p] for p in polygons], facecolor="#d9a066", edgecolor="#8a5a2b", linewidth=0.6, zorder=2))
        # the hull is convex: a point outside a visible face is in front of it
        before = np.any([(points - corner) @ normal > 0 for corner, normal in faces if normal @ view > 0], axis=0)
        for drawn, zorder in ((~before, 1), (before, 3)):
            cloud, speed = points[drawn], arrays["speed"][drawn]
            order = np.argsort(cloud @ view)
            dots = axes.scatter(*cloud[order].T, c=speed[order], s=0.9, cmap="viridis", vmin=0, vmax=5, linewidths=0, zorder=zorder, depthshade=False)
        axes.set(xlim=(-0.5, 0.5), ylim=(-0.5, 0.5), zlim=(-0.4, 0.6))
        axes.set_box_aspect((1, 1, 1), zoom=1.15)
        axes.view_init(elev=np.degrees(elevation), azim=np.degrees(azimuth))
        axes.set_axis_off()
        figure.text(0.25 * column + 0.125, 0.93, f"{25 * frame} ms", ha="center")
    scale = figure.colorbar(dots, cax=figure.add_axes([0.36, 0.12, 0.28, 0.025]), orientation="horizontal")
    scale.set_label("speed [m/s]", labelpad=1)
    save(figure, "sph_splash.png")


def bar(folder):
    rows = list(csv.reader((folder / "bar_on_wall.csv").open()))[1:]
    time, force, theory = np.array(rows, float).T
    figure = plt.figure(figsize=(9, 3.2), dpi=110)
    axes = figure.add_axes([0.06, 0.15, 0.36, 0.74])
    axes.plot(1e3 * time, force, color="#2a78b5", lw=1, label="fem_bar, 50 cells")
    axes.plot(1e3 * time, theory, color=INK, lw=1, ls="--", label="wave equation")
    axes.set(xlabel="time [ms]", ylabel="force on the wall [N]", title="bar on a wall")
    axes.legend(frameon=False, loc="center")
    axes.spines[["top", "right"]].set_visible(False)

    axes = figure.add_axes([0.47, 0.04, 0.44, 0.85])
    for column in range(5):
        points, _, arrays = read_vtk(folder / f"bar_on_wedge_{column}.vtk")
        corners, polygons, _ = read_vtk(folder / f"bar_on_wedge_body_{column}.vtk")
        side = points[:, 1] > 0  # both halves are symmetric
        for polygon in polygons:
            if len(polygon) == 3:  # the ends of the wedge, viewed along its edge
                axes.fill(*(corners[polygon][:, [0, 2]] + [0.08 * column, 0]).T, color="#d9a066", ec="#8a5a2b", lw=0.6)
        cloud = axes.scatter(points[side, 0] + 0.08 * column, points[side, 2], c=1e-6 * arrays["axial_stress"][side], s=10, marker="s", linewidths=0, cmap="coolwarm", vmin=-0.5, vmax=0.5)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title("bar on a free wedge")
    scale = figure.colorbar(cloud, cax=figure.add_axes([0.93, 0.2, 0.012, 0.6]))
    scale.set_label("axial stress [MPa]")
    save(figure, "fem_bar.png")


if __name__ == "__main__":
    splash(Path(sys.argv[1]))
    bar(Path(sys.argv[1]))
