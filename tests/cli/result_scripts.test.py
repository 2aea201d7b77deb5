"""Results folders as scripts read them: names of files, scripts/results and cases/*/*.py."""

import importlib.util
import os
import shutil
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts/results"), str(Path(__file__).resolve().parent)]
from claims import DECK, claim, main  # noqa: E402

COUPLED = {"hull_panel/bar.py", "hull_panel/impacts.py", "hull_panel/solid.py"}  # need dolfinx or the package of Python
ONE_FOLDER = ["crack_branching/figures", "crack_branching/measure", "floating_strip/figure", "floating_strip/measure", "ice_paddle/figure", "ice_specimens/figures",
              "ice_specimens/measure", "ice_sphere/figures", "ice_sphere/measure", "kalthoff_winkler/figures", "kalthoff_winkler/measure", "plate_impact/table",
              "propeller_ice/figures", "propeller_ice/measure", "propeller_ice/table", "ship_ice/compare", "ship_ice/contributions", "ship_ice/figures",
              "ship_ice/long_run", "ship_ice/measure", "ship_ice/order_of_cracks", "submarine_surfacing/figures", "submarine_surfacing/measure", "uikku_ice/clearing", "uikku_ice/compare",
              "uikku_ice/figures", "uikku_ice/speeds"]  # fmt: skip


def script(t, path, *words, **variables):
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "LC_ALL": "C.UTF-8", **variables}
    return subprocess.run([sys.executable, ROOT / path, *words], cwd=t.folder, env=environment, capture_output=True, text=True, check=False)


def needs(*modules):
    for name in modules:
        if importlib.util.find_spec(name) is None:
            raise unittest.SkipTest(f"{name} is not installed")


def side_by_side(call, items):
    with ThreadPoolExecutor(2) as pool:
        return dict(zip(items, pool.map(call, items)))


@claim("results: a line is named by its time, without the rounding of step times dt")
def lines(t):
    times = ("along_y: {body: plate,", "along_y: {times: [1.3 us, 2.6 us, 5.1 us, 5.2 us], body: plate,")
    t.expect_success("run", t.deck(("{end: 20 us}", "{end: 5.2 us, step: 0.1 us}"), times), "--out", "r", "--no-report")
    t.assertEqual([name for name in t.files("r") if name.startswith("lines/")], [f"lines/along_y_t{time}e-06.csv" for time in (1.3, 2.6, 5.1, 5.2)])


@claim("scripts: every script of a case that is run explains itself with --help")
def helps(t):
    needs("matplotlib", "scipy")
    names = [str(path.relative_to(ROOT / "cases")) for path in sorted((ROOT / "cases").glob("*/*.py")) if "\nmain()\n" in path.read_text() or "__main__" in path.read_text()]
    t.assertGreater(len(names), 30)
    for name, said in side_by_side(lambda name: script(t, f"cases/{name}", "--help"), [name for name in names if name not in COUPLED]).items():
        t.assertEqual((said.returncode, said.stderr), (0, ""), name)
        t.assertTrue(said.stdout.startswith("usage: "), name)


@claim("scripts: a folder that is missing, and the results of another deck, end every script of a case with 2 and one sentence")
def refused(t):
    needs("matplotlib", "scipy")
    (t.folder / "other.yaml").write_text(DECK.replace("plate", "slab").replace("cylinder:", "roller:", 1))
    t.expect_success("run", "other.yaml", "--out", "other", "--no-report")
    jobs = [(name, folder) for name in ONE_FOLDER for folder in ("nowhere", "other")]
    for (name, folder), said in side_by_side(lambda job: script(t, f"cases/{job[0]}.py", job[1]), jobs).items():
        t.assertEqual(said.returncode, 2, (name, folder, said.stderr))
        t.assertRegex(said.stderr, r"^error: [^\n]*other[^\n]*\.\n$" if folder == "other" else r"^error: [^\n]*nowhere[^\n]*\.\n$", name)
    t.assertEqual(script(t, "cases/ship_ice/contributions.py", "nowhere").stderr, "error: nowhere has no history.csv; give a results folder written by perimpact run.\n")
    t.assertEqual(t.files("other"), [name for name in t.files("other") if "statistics" not in name])


@claim("scripts: a mean over a window weights rows by their length, and belongs to the middle of the window")
def windows(t):
    needs("numpy")
    import numpy as np
    from interval_means import mean, window_means

    generator = np.random.default_rng(5)
    time = np.concatenate([[0], np.cumsum(generator.uniform(0.01, 0.2, 200))])
    # rows of f = t² are its means over their intervals, (b² + ab + a²)/3
    rows = np.concatenate([[0], (time[1:] ** 2 + time[1:] * time[:-1] + time[:-1] ** 2) / 3])
    middles, means = window_means(time, rows, 1.0)
    t.assertGreater(len(middles), 150)
    t.assertLess(abs(means - middles**2 - 1 / 12).max(), 0.2 * time[-1] * 0.2)  # within a row its mean stands for the function
    t.assertAlmostEqual(mean(time, rows), time[-1] ** 2 / 3, delta=1e-9)
    # a constant that is twice as large in a last row of a tenth of the others
    time, rows = np.append(np.arange(11.0), 10.1), np.array([0.0] + [1] * 10 + [2])
    t.assertAlmostEqual(mean(time, rows), 10.2 / 10.1, delta=1e-12)
    middles, means = window_means(time, rows, 2.0)
    t.assertEqual(list(middles), [*range(1, 10), 9.1])
    t.assertAlmostEqual(means[-1], 2.1 / 2, delta=1e-12)
    t.assertEqual(len(window_means(time, rows, 20.0)[0]), 0)
    middles, means = window_means(time, rows, 2.0, is_zero_before=True)
    t.assertEqual([*zip(middles, means)][:3], [(0, 0.5), (1, 1), (2, 1)])


@claim("scripts: statistics of a load leave the results folder as it is, and come from the program of PERIMPACT, of PATH, or of the build")
def statistics(t):
    t.expect_success("run", t.deck(), "--out", "r", "--no-report")
    (t.folder / "r/statistics.csv").write_text("mine\n")
    before = {name: (t.folder / "r" / name).read_bytes() for name in t.files("r")}
    (t.folder / "bin").mkdir()
    (t.folder / "bin/perimpact").symlink_to(t.program)
    ask = "import sys; sys.path.insert(0, sys.argv[1]); from load_statistics import load_statistics; from results_folder import run; run(lambda: print(load_statistics('r', sys.argv[2], 8e-6)['mean']))"
    asked = lambda column, **variables: subprocess.run([sys.executable, "-c", ask, ROOT / "scripts/results", column], cwd=t.folder, env={**os.environ, **variables}, capture_output=True, text=True, check=False)  # noqa: E731
    known = float(asked("cylinder.force_y", PERIMPACT=t.program).stdout)
    t.assertGreater(known, 1e4)
    t.assertEqual(float(asked("cylinder.force_y", PATH=f"{t.folder / 'bin'}:{os.environ['PATH']}", PERIMPACT="").stdout), known)
    said = asked("nothing.force_y", PERIMPACT=t.program)
    t.assertEqual(said.returncode, 2)
    t.assertRegex(said.stderr, r"^error: [^\n]*r/history\.csv[^\n]*nothing\.force_y[^\n]*\n$")
    t.assertEqual({name: (t.folder / "r" / name).read_bytes() for name in t.files("r")}, before)


PARAVIEW = '''
"""Stands for ParaView: reads what the run wrote, and prints what is drawn."""
import sys
from pathlib import Path
from unittest.mock import MagicMock
sys.path.insert(0, {scripts!r})
from vtp_reader import read_vtp, series


class Array:
    def __init__(self, name, values):
        self.Name, self.values = name, values

    def GetNumberOfComponents(self):
        return 1 if self.values.ndim == 1 else self.values.shape[1]

    def GetRange(self, component):
        return 0.0, float(self.values.max())


class Arrays(dict):
    def GetArray(self, number):
        return list(self.values())[number]


class Simple:
    def OpenDataFile(self, path):
        path, source = Path(path), MagicMock()
        frames = series(path.parent.parent, path.stem)
        first = read_vtp(frames[0][1])
        source.picture, source.TimestepValues = first, [time for time, _ in frames]
        source.PointData = Arrays((name, Array(name, values)) for name, values in first.point.items())
        source.GetDataInformation().GetBounds.return_value = [bound for pair in zip(first.points.min(axis=0), first.points.max(axis=0)) for bound in pair]
        source.GetDataInformation().GetNumberOfPoints.return_value = len(first.points)
        return source

    class servermanager:
        @staticmethod
        def Fetch(source):
            return MagicMock(GetNumberOfPolys=lambda: len(source.picture.panels))

    def ColorBy(self, shown, by):
        print("coloured by", *by)

    def __getattr__(self, name):
        return MagicMock()


sys.modules["paraview"] = MagicMock(simple=Simple())
sys.argv = sys.argv[1:]
exec(compile(Path(sys.argv[0]).read_text(), sys.argv[0], "exec"))
'''


@claim("scripts: paraview_pictures.py draws any frames: thinned ones, those without impactors, and those of a run that has not ended")
def pictures(t):
    needs("numpy")
    (t.folder / "paraview.py").write_text(PARAVIEW.format(scripts=str(ROOT / "scripts/results")))
    draw = lambda *words: script(t, t.folder / "paraview.py", ROOT / "scripts/results/paraview_pictures.py", *words)  # noqa: E731
    breaks = ("density: 8000 kg/m3}", "density: 8000 kg/m3, critical_stretch: 0.0001}")

    def coloured(folder, *words):
        said = draw(folder, *words)
        t.assertEqual((said.returncode, said.stderr), (0, ""), folder)
        t.assertEqual(said.stdout.count("picture_"), 5)
        return [line for line in said.stdout.splitlines() if line.startswith("coloured")]

    for folder, changes, by in (
        ("elastic", (), "POINTS velocity Magnitude"),
        ("breaking", (breaks,), "POINTS damage"),
        ("thinned", (breaks, ("  frames: 4\n", "  frames: 4\n  frame_fields: [damage]\n")), "POINTS damage"),
        ("elastic_thinned", (("  frames: 4\n", "  frames: 4\n  frame_fields: [displacement]\n"),), None),
    ):
        t.expect_success("run", t.deck(*changes), "--out", folder, "--no-report")
        t.assertEqual(coloured(folder), [f"coloured by {by}"] if by else [], folder)
    t.assertEqual(coloured("elastic_thinned", "--colour", "displacement"), ["coloured by POINTS displacement Magnitude"])
    said = draw("elastic_thinned", "--colour", "damage")
    t.assertEqual(said.returncode, 2)
    t.assertRegex(said.stderr, r"^error: no frames have damage; they have displacement\.\n$")
    (t.folder / "breaking/run.json").unlink()
    t.assertEqual(coloured("breaking"), ["coloured by POINTS damage"])
    (t.folder / "breaking/frames/cylinder.pvd").unlink()
    t.assertEqual(coloured("breaking"), ["coloured by POINTS damage"])
    shutil.rmtree(t.folder / "breaking/frames")
    for folder in ("breaking", "nowhere"):
        said = draw(folder)
        t.assertEqual((said.returncode, said.stderr), (2, f"error: {folder} has no frames; run the deck with output.frames above 0.\n"))


main()
