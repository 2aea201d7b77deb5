"""The figures of the plate case are drawn from made-up results, whose numbers are known by formula."""

import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[3]
CASE = ROOT / "cases/plate_impact"
sys.path[:0] = [str(CASE), str(ROOT / "scripts/results"), str(ROOT / "tests/fixtures")]
try:
    import matplotlib  # noqa: F401  only whether it is there
    import numpy as np
    from plate_results import displacement, lattice, write_results
    from render import Scene
    from results import Results, middle_layer
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

CURVES = ["fig16a", "fig16b", "fig16c", "fig17a", "fig17b", "fig17c"]


def draw(out, *arguments):
    return subprocess.run([sys.executable, CASE / "figures.py", *arguments, "--out", out], capture_output=True, text=True)


def middle_layer_is_found_whatever_the_order_of_particles(run):
    picture = run.frame("plate", 199e-6)
    assert picture.time == 200e-6
    shuffled = np.random.default_rng(1).permutation(len(picture.points))
    picture.points, picture.point["displacement"] = picture.points[shuffled], picture.point["displacement"][shuffled]
    position, u = middle_layer(picture)
    X = lattice(0.004)
    X = X[X[:, 2] == 0].reshape(25, 50, 3)
    wanted = displacement(X.reshape(-1, 3), 200e-6).reshape(X.shape)
    assert u.shape == X.shape
    assert np.abs(u - wanted).max() < 1e-9  # 5 mm as float: 2.3e-10
    assert np.abs(position - X - wanted).max() < 1e-8  # 0.1 m as float: 3.7e-9


def the_nearest_profile_is_taken(run):
    (run.folder / "lines/along_x_t5e-05.csv").write_text("position_x [m]\n7\n")
    assert run.line("along_x", 60e-6)["position_x [m]"] == [7]
    assert len(run.line("along_x", 200e-6)["position_x [m]"]) == 41


def what_is_nearer_hides_what_is_behind():
    red, green = np.array([[1.0, 0, 0]]), np.array([[0, 1.0, 0]])
    for order in (1, -1):  # whichever is drawn first
        scene = Scene(direction=(0, 0, 1), up=(0, 1, 0), pixels_per_metre=10, width=40, height=40, centre=(0, 0, 0))
        for height, colour in ((1, red), (-1, green))[::order]:
            scene.add_balls(np.array([[0, 0, height]]), 0.5 + 0.5 * (height < 0), colour)
        picture = scene.picture()
        assert picture[20, 20, 0] > 0 and picture[20, 20, 1] == 0  # the small red ball in front
        assert picture[20, 28, 0] == 0 and picture[20, 28, 1] > 0  # the rim of the large green one
        assert picture[20, 32, 3] == 0  # nothing
        scene.add_panels(np.array([[-1, -1, 2], [1, -1, 2], [1, 1, 2]]), [[0, 2, 1]], (0, 0, 1), (0, 0, 1), 0)
        assert (scene.picture() == picture).all()  # a panel that faces away is not seen
        scene.add_panels(np.array([[-1, -1, 2], [1, -1, 2], [1, 1, 2]]), [[0, 1, 2]], (0, 0, 1), (0, 0, 1), 0)
        assert scene.picture()[22, 24, 2] > 0 and (scene.picture()[16, 12] == picture[16, 12]).all()


def all_figures_are_drawn(folder, runs):
    done = draw(folder / "figures", *runs, "--only", "fig")
    assert done.returncode == 0, done.stderr
    for name in ["fig13", "fig14", "fig15", *CURVES]:
        assert (folder / f"figures/{name}.png").read_bytes().startswith(b"\x89PNG"), name


def what_is_missing_is_named_and_the_rest_is_drawn(folder, run):
    (run / "history.csv").rename(run / "elsewhere.csv")
    done = draw(folder / "fewer", run, "--only", "fig16")
    assert done.returncode == 1 and "history.csv" in done.stderr
    assert sorted(path.stem for path in (folder / "fewer").iterdir()) == ["fig16b", "fig16c"]


def main():
    what_is_nearer_hides_what_is_behind()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        runs = [folder / "panel_2mm", folder / "analytic"]
        for run in runs:
            write_results(run)
        assert [Results(run).label for run in runs] == ["$\\Delta_m$ = 2 mm", "original method"]
        middle_layer_is_found_whatever_the_order_of_particles(Results(runs[0]))
        the_nearest_profile_is_taken(Results(runs[0]))
        all_figures_are_drawn(folder, runs)
        what_is_missing_is_named_and_the_rest_is_drawn(folder, runs[1])


main()
