"""Modes of elastic impactors from CalculiX and from arrays, against the theory of beams."""

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

import package  # makes perimpact importable; must come first
from claims import claim, main
from reports import ReportFile, read_pictures

import numpy as np

import beam
import perimpact
from perimpact import frd, modes

HERE = Path(__file__).resolve().parent
UNITS = ("mm", "t", "s")
LENGTH, WIDTH, HEIGHT = (size * 1e-3 for size in beam.SIZE)
MODULUS, DENSITY = beam.YOUNGS_MODULUS * 1e6, beam.DENSITY * 1e12  # SI
MASS = DENSITY * LENGTH * WIDTH * HEIGHT

# Euler and Bernoulli: cosh κ cos κ = -1 for a clamped beam, 1 for a free one
CLAMPED, FREE = (1.8751040687, 4.6940911330), (4.7300407449, 7.8532046241)


def frequency(root, thickness):
    return root**2 / (2 * np.pi) * np.sqrt(MODULUS * thickness**2 / (12 * DENSITY * LENGTH**4))


def clamped_shape(root, x, derivative=0):
    """φ or φ'' [1/√kg, 1/(m² √kg)] of unit modal mass: ∫ φ² over the length is the length times that at A = 1."""
    k, s = root * x / LENGTH, (np.cosh(root) + np.cos(root)) / (np.sinh(root) + np.sin(root))
    if derivative == 0:
        return (np.cosh(k) - np.cos(k) - s * (np.sinh(k) - np.sin(k))) / np.sqrt(MASS)
    return (root / LENGTH) ** 2 * (np.cosh(k) + np.cos(k) - s * (np.sinh(k) + np.sin(k))) / np.sqrt(MASS)


SPIN = 20.0  # rad/s
DECK = f"""\
title: A block on a cantilever that turns
time: {{end: 6 ms}}
bodies:
  block:
    shape: {{box: {{size: [0.1, 0.08, 0.1]}}}}
    position: [0.9, 0.05, 0.1025]
    spacing: 0.01
    velocity: [0, 0, -2]
    material: {{model: ordinary-state, youngs_modulus: 1 GPa, poissons_ratio: 0.25, density: 2000}}
impactors:
  beam:
    surface: {{file: beam.vtu}}
    mass: 39
    angular_velocity: [0, 0, {SPIN}]
    elastic: {{modes: beam.vtu}}
output: {{folder: results, frames: 3}}
"""


def read_beam():
    return modes.from_calculix(HERE / "beam.frd", UNITS)


def edges(read):
    """The stations along the beam, and the point numbers of its four edges at each."""
    x = np.unique(read.points[:, 0].round(9))
    corner = np.isin(read.points[:, 1].round(9), (0, WIDTH)) & np.isin(read.points[:, 2].round(9), (0, HEIGHT))
    return x, [np.flatnonzero(corner & (np.abs(read.points[:, 0] - station) < 1e-9)) for station in x]


def complaint(test, call, *arguments):
    with test.assertRaises(perimpact.InputError) as caught:
        call(*arguments)
    return str(caught.exception)


def run(test, *words):
    environment = {**os.environ, "PYTHONPATH": sys.path[0]}
    return subprocess.run([sys.executable, "-m", "perimpact.modes", *map(str, words)], env=environment, cwd=test.folder, capture_output=True, text=True)


@claim("modes: frequencies, shapes and modal mass of a cantilever from CalculiX are those of a beam, in SI")
def beam_theory(test):
    read = read_beam()
    expected = [(CLAMPED[0], HEIGHT, 2), (CLAMPED[0], WIDTH, 1), (CLAMPED[1], HEIGHT, 2), (CLAMPED[1], WIDTH, 1)]
    x, stations = edges(read)
    for mode, (root, thickness, axis) in enumerate(expected):
        # shear and rotary inertia, which Euler and Bernoulli leave out, are a share of (root · thickness / length)², at most 0.22
        left_out = (root * thickness / LENGTH) ** 2
        test.assertLess(abs(read.frequencies[mode] / frequency(root, thickness) - 1), 0.2 * left_out)
        deflection = np.array([read.shapes[mode][points, axis].mean() for points in stations])
        theory = clamped_shape(root, x) * np.sign(deflection[-1]) * np.sign(clamped_shape(root, LENGTH))
        test.assertLess(np.abs(deflection - theory).max(), 0.2 * left_out * np.abs(theory).max())
        test.assertLess(abs(abs(deflection[-1]) * np.sqrt(MASS) / 2 - 1), 0.2 * left_out)  # the tip moves by 2/√m


@claim("modes: shapes from CalculiX are orthonormal with respect to the mass of the beam")
def orthonormal(test):
    read = read_beam()
    x, stations = edges(read)
    weights = np.array([1.0, *[4.0, 2.0] * (beam.ELEMENTS - 1), 4.0, 1.0]) * (x[1] - x[0]) / 3  # Simpson
    mean = np.array([[shape[points].mean(axis=0) for points in stations] for shape in read.shapes])
    products = DENSITY * WIDTH * HEIGHT * np.einsum("ixc,jxc,x->ij", mean, mean, weights)
    # the mean over a section has no part in its rotation, whose share of the energy is (root · thickness / length)²/12, up to 0.02
    test.assertLess(np.abs(products - np.eye(4)).max(), 0.03)


@claim("modes: stresses from CalculiX are those of bending at unit modal coordinate")
def bending_stress(test):
    read = read_beam()
    top = np.flatnonzero((np.abs(read.points[:, 0] - LENGTH / 2) < 1e-9) & (np.abs(read.points[:, 2] - HEIGHT) < 1e-9) & (read.points[:, 1] == 0))
    tip = np.argmax(read.points[:, 0])
    curvature = clamped_shape(CLAMPED[0], LENGTH / 2, 2) * np.sign(read.shapes[0][tip, 2])
    expected = -MODULUS * HEIGHT / 2 * curvature  # a beam that bends upward is compressed at its top
    stress = read.stresses[0][top[0]]
    test.assertLess(abs(stress[0] / expected - 1), 0.02)  # extrapolated from integration points within an element of 1/8 of the length
    test.assertLess(np.abs(stress[[1, 2, 3, 4]]).max(), 0.01 * abs(expected))


@claim("modes: the boundary of solids is closed, also with mid-side nodes, and is the impactor's surface")
def boundary(test):
    read = read_beam()
    test.assertEqual(sorted({len(face) for face in read.faces}), [8])
    test.assertEqual(len(read.faces), 4 * beam.ELEMENTS + 2)
    path = test.folder / "beam.vtu"
    modes.write(path, read.points, read.faces, read.frequencies, read.shapes, read.stresses)
    mesh = subprocess.run([sys.argv[1], "mesh", path], capture_output=True, text=True)
    test.assertEqual((mesh.returncode, mesh.stderr), (0, ""))
    test.assertIn("closure           closed", mesh.stdout)
    test.assertIn("volume            0.005 m3", mesh.stdout)
    for kind, nodes, faces in ((1, 8, 6), (2, 6, 5), (3, 4, 4), (4, 20, 6), (5, 15, 5), (6, 10, 4), (8, 6, 1), (10, 8, 1)):
        test.assertEqual(len(frd.boundary_faces([(kind, list(range(nodes)))])), faces)
    test.assertEqual(frd.boundary_faces([(11, [1, 2])]), [])
    two = [(3, [0, 1, 2, 3]), (3, [1, 2, 3, 4])]
    test.assertEqual(len(frd.boundary_faces(two)), 6)


@claim("modes: damaged files of CalculiX are refused in a sentence, whatever line is damaged")
def damaged(test):
    lines = (HERE / "beam.frd").read_text(encoding="latin-1").splitlines()
    first = lambda start: next(k for k, line in enumerate(lines) if line.startswith(start))  # noqa: E731
    result, element = first("  100"), first("    3") + 2
    for number, line in [
        (result, lines[result][:12] + "x" * 12 + lines[result][24:]),
        (result + 1, lines[result + 1].rsplit(None, 2)[0] + " few 1"),
        (result + 1, " -4  DISP"),
        (first("    1PMODE"), "    1PMODE  one"),
        (first("    1PSTEP"), "    1PSTEP  x"),
        (element, lines[element][: len(lines[element]) // 2]),
    ]:
        (test.folder / "bad.frd").write_text("\n".join([*lines[:number], line, *lines[number + 1 :]]), encoding="latin-1")
        done = run(test, "bad.frd", "bad.vtu", "--units", *UNITS)
        test.assertEqual((done.returncode, done.stderr.count("\n"), "Traceback" in done.stderr), (2, 1, False), (line, done.stderr))
    test.assertFalse((test.folder / "bad.vtu").exists())


@claim("modes: the command converts a file, onto the vertices of a surface too, and refuses in one sentence")
def command(test):
    done = run(test, HERE / "beam.frd", "beam.vtu", "--units", *UNITS, "--damping", "0.02")
    test.assertEqual((done.returncode, done.stderr), (0, ""))
    test.assertEqual(done.stdout.splitlines()[0], "mode 1, 41.9 Hz: mode_1")
    test.assertEqual(done.stdout.splitlines()[-1], "beam.vtu: 4 modes on 104 points, with stresses")
    done = run(test, HERE / "beam.frd", "few.csv", "--units", *UNITS, "--surface", "beam.vtu", "--modes", "3,1")
    test.assertEqual((done.returncode, done.stderr), (0, ""))
    lines = (test.folder / "few.csv").read_text().splitlines()
    test.assertEqual(lines[0], "frequency [Hz], 262.1510145, 41.89756174")
    test.assertEqual(len(lines), 2 + 104)
    done = run(test, HERE / "beam.frd", "wrong.vtu", "--surface", "beam.vtu")
    test.assertEqual(done.returncode, 2)
    test.assertIn("has no node within 1.01e-05 m; the nearest is", done.stderr)
    test.assertEqual(run(test, "absent.frd", "out.vtu").returncode, 2)
    test.assertIn("only .frd files of CalculiX are converted", run(test, "beam.vtu", "out.vtu").stderr)
    test.assertIn("the unit furlong is unknown", run(test, HERE / "beam.frd", "out.vtu", "--units", "furlong", "t", "s").stderr)


@claim("modes: vertices of a surface in any order have the modes of their nodes, and their own positions")
def surface_order(test):
    read = read_beam()
    order = np.random.default_rng(3).permutation(len(read.points))[:50]
    vertices = read.points[order] + 2e-6  # a rounding as of six digits
    placed = modes.on_surface(read, vertices, [[0, 1, 2]])
    np.testing.assert_array_equal(placed.points, vertices)
    np.testing.assert_array_equal(placed.shapes, read.shapes[:, order])
    np.testing.assert_array_equal(placed.stresses, read.stresses[:, order])
    vertices[7, 2] += 0.01
    test.assertIn("vertex 7 of the surface (counted from 0)", complaint(test, modes.on_surface, read, vertices))


@claim("modes: eigenvectors of K φ = λ M φ become frequencies and shapes of unit modal mass")
def eigenvectors(test):
    # a point of 2 kg on springs of 8, 18 and 32 N/m
    stiffness, mass = np.diag([8.0, 18.0, 32.0]), 2 * np.eye(3)
    eigenvalues, vectors = np.linalg.eigh(stiffness / 2)
    for given in (mass, np.array([2.0])):
        frequencies, shapes = modes.from_eigenvectors(eigenvalues, 5 * vectors, given)
        np.testing.assert_allclose(frequencies * 2 * np.pi, [2, 3, 4], rtol=1e-14)
        np.testing.assert_allclose(np.abs(shapes[:, 0]), np.eye(3) / np.sqrt(2), atol=1e-14)
    test.assertEqual(complaint(test, modes.from_eigenvectors, [0.0], np.ones((3, 1))), "eigenvalue 1 is 0, but that of an elastic mode is positive; leave out rigid-body modes.")
    test.assertIn("vectors has the shape (4, 1)", complaint(test, modes.from_eigenvectors, [1.0], np.ones((4, 1))))
    test.assertIn("mode 1 has a modal mass of -3 kg", complaint(test, modes.normalised, np.ones((1, 1, 3)), np.array([-1.0])))


@claim("modes: arrays that do not fit each other are not written")
def refused(test):
    points, shapes = np.zeros((4, 3)), np.ones((2, 4, 3))

    def sentence(**changes):
        arguments = {"path": test.folder / "x.vtu", "points": points, "faces": [[0, 1, 2]], "frequencies": [1.0, 2.0], "shapes": shapes, **changes}
        return complaint(test, lambda: modes.write(**arguments))

    test.assertEqual(sentence(shapes=shapes[:1]), "shapes has the shape (1, 4, 3), but 4 points and 2 modes need (2, 4, 3).")
    test.assertEqual(sentence(stresses=np.ones((2, 4, 3))), "stresses has the shape (2, 4, 3), but 4 points and 2 modes need (2, 4, 6).")
    test.assertEqual(sentence(shapes=np.nan * shapes), "shapes has numbers that are not finite.")
    test.assertIn("mode 2 has a frequency of 0 Hz", sentence(frequencies=[1.0, 0.0]))
    test.assertEqual(sentence(faces=[[0, 1, 4]]), "faces has point numbers outside 0 to 3.")
    test.assertEqual(sentence(frequencies=[], shapes=np.ones((0, 4, 3))), "there are no modes to write.")
    test.assertTrue(sentence(path="x.stl").endswith("x.stl: modes are written as .vtu or .csv."))


@claim("modes: rigid motions are told from elastic modes")
def rigid(test):
    points = np.random.default_rng(5).normal(size=(20, 3))
    motion = np.array([1.0, 2.0, 3.0]) + np.cross([0.3, -0.2, 0.5], points)
    test.assertTrue(modes.is_rigid(points, motion))
    bent = motion.copy()
    bent[:, 2] += 0.1 * points[:, 0] ** 2
    test.assertFalse(modes.is_rigid(points, bent))


@claim("modes: frames of an elastic impactor have the deformed surface with its displacements and the stresses that belong to them, and so has the report")
def deformed_frames(test):
    read = modes.chosen(read_beam(), [1, 3])  # bending by a force along z
    modes.write(test.folder / "beam.vtu", read.points, read.faces, read.frequencies, read.shapes, read.stresses, 0.02)
    (test.folder / "deck.yaml").write_text(DECK)
    done = subprocess.run([sys.argv[1], "run", "deck.yaml", "--threads", "1"], cwd=test.folder, capture_output=True, text=True)
    test.assertEqual(done.returncode, 0, done.stderr)
    test.assertEqual(subprocess.run([sys.argv[1], "report", "results"], cwd=test.folder, capture_output=True).returncode, 0)
    report = ReportFile(test.folder / "results/report.html")
    test.assertEqual(report.notes, [])
    about, vertices, panels, pictures = report.impactor("beam")
    test.assertEqual([array["unit"] for array in about["arrays"][-2:]], ["m", "Pa"])
    basis = read.shapes.reshape(2, -1).T
    centre = np.array([LENGTH, WIDTH, HEIGHT]) / 2
    for number, (time, motion, picture) in enumerate(zip(report.times, about["motions"], pictures, strict=True)):
        frame = {name: np.array(rows) for name, rows in read_pictures(test.folder / f"results/frames/beam_{number:05}.vtp").items() if name != "panels"}
        angle = SPIN * time
        turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
        u = frame["displacement"]
        np.testing.assert_allclose(frame["points"], (read.points - centre) @ turn.T + centre + u, rtol=0, atol=1e-7)  # single precision
        q, *_ = np.linalg.lstsq(basis, (u @ turn).ravel(), rcond=None)
        size = np.abs(u).max()
        np.testing.assert_allclose((basis @ q).reshape(-1, 3), u @ turn, rtol=0, atol=1e-6 * size + 1e-12)
        stress = np.einsum("k,knc->nc", q, read.stresses)
        largest = np.abs(stress).max()
        np.testing.assert_allclose(frame["stress"], stress, rtol=0, atol=1e-5 * largest + 1)
        tensors = frame["stress"][:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
        principal = np.linalg.eigvalsh(tensors)
        von_mises = np.sqrt(((principal - np.roll(principal, 1, axis=1)) ** 2).sum(axis=1) / 2)
        np.testing.assert_allclose(frame["von_mises_stress"][:, 0], von_mises, rtol=0, atol=1e-5 * largest + 1)
        # in the report: the deformed surface, and means over the corners of each panel
        shown = np.array(vertices) + np.array([picture[axis] for axis in "xyz"]).T
        rows = np.array(motion).reshape(3, 4)
        step = max(array["step"] for array in about["deformation"])
        np.testing.assert_allclose(shown @ rows[:, :3].T + rows[:, 3], frame["points"], rtol=0, atol=1e-6 + step)
        means = [von_mises[panel].mean() for panel in panels]
        np.testing.assert_allclose(picture["von_mises_stress"], means, rtol=0, atol=about["arrays"][-1]["step"] + 1e-5 * largest + 1)
    test.assertGreater(size, 1e-3)  # the beam bends
    history = test.history("results")
    test.assertLess(abs(history["beam.largest_deflection [m]"][-1] / np.linalg.norm(u, axis=1).max() - 1), 1e-6)
    test.assertLess(abs(history["beam.largest_von_mises_stress [Pa]"][-1] / von_mises.max() - 1), 1e-5)


@claim("modes: a damaged .frd file is refused with its line, or read")
def damaged(test):
    text = (HERE / "beam.frd").read_text()
    path = test.folder / "beam.frd"

    def refusal(changed):
        path.write_text(changed)
        return complaint(test, modes.from_calculix, path, UNITS)

    test.assertIn("the file has no vibration modes", refusal(text.replace("1PMODE", "1PTIME")))
    test.assertIn(":12: the block is binary", refusal(text.replace("104                                     1", "104                                     2", 1)))
    test.assertIn(":13: this line is not the values of a node", refusal(text.replace("0.00000E+00", "0.000x0E+00", 1)))
    test.assertIn("the file ends within a block; it is truncated", refusal(text[: text.index("\n", len(text) // 2) + 1]))
    for length in range(0, len(text), 997):
        path.write_text(text[:length])
        try:
            modes.from_calculix(path, UNITS)
        except perimpact.InputError:
            pass


@claim("modes: CalculiX computes the file of the tests, and the modes of a free beam, whose rigid motions are left out")
def calculix(test):
    if shutil.which("ccx") is None:
        test.skipTest("CalculiX (ccx) is not installed")
    for name, is_clamped, count in (("clamped", True, 4), ("free", False, 8)):
        (test.folder / f"{name}.inp").write_text(beam.model(is_clamped, count))
        subprocess.run(["ccx", name], cwd=test.folder, check=True, capture_output=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    clamped = modes.from_calculix(test.folder / "clamped.frd", UNITS)
    np.testing.assert_allclose(clamped.frequencies, read_beam().frequencies, rtol=1e-4)  # of an iterative solver
    done = run(test, "free.frd", "free.vtu", "--units", *UNITS)
    test.assertEqual(done.returncode, 0, done.stderr)
    lines = done.stdout.splitlines()
    test.assertEqual([line.endswith("Hz: rigid motion, left out") for line in lines[:6]], 6 * [True])
    for line, thickness in zip(lines[6:8], (HEIGHT, WIDTH)):
        test.assertLess(abs(float(line.split()[2]) / frequency(FREE[0], thickness) - 1), 0.2 * (FREE[0] * thickness / LENGTH) ** 2)


@claim("modes: the automatic time step resolves bodies and the highest mode; a given step that resolves it poorly is reported, one that does not is refused")
def time_step(test):
    read = read_beam()
    highest = 2 * np.pi * read.frequencies.max()
    modes.write(test.folder / "beam.vtu", read.points, read.faces, read.frequencies, read.shapes, read.stresses)

    def simulation(modulus, **settings):
        (test.folder / "deck.yaml").write_text(DECK.replace("youngs_modulus: 1 GPa", f"youngs_modulus: {modulus}"))
        return perimpact.Simulation.from_deck(test.folder / "deck.yaml", set={f"time.{key}": value for key, value in settings.items()})

    end = 6e-3
    short = simulation("1 MPa")
    test.assertEqual(short.steps, np.ceil(end / (0.5 / highest)))  # the block alone allows more
    test.assertFalse(any("shorter than the bodies need" in warning for warning in short.warnings))
    soft = simulation("1 kPa").warnings
    test.assertTrue(any("times shorter than the bodies need. Leave out high modes" in warning for warning in soft), soft)
    stiff, stiffer = simulation("1 GPa").steps, simulation("4 GPa").steps
    test.assertGreater(stiff, 2 * end * highest)
    test.assertLess(abs(stiffer / stiff - 2), 0.02)  # the block decides
    poor = simulation("1 MPa", step=1.2 / highest)
    test.assertTrue(any("resolves the highest mode of an elastic impactor" in warning for warning in poor.warnings), poor.warnings)
    test.assertFalse(any("highest mode" in warning for warning in simulation("1 MPa", step=0.4 / highest).warnings))
    with test.assertRaises(perimpact.InputError) as caught:
        simulation("1 MPa", step=2.1 / highest)
    test.assertIn("is too long for the highest mode of an elastic impactor", str(caught.exception))


@claim("modes: the example for dolfinx has frequencies, shapes and stresses between those of a beam and of a wide plate, and its file makes an impactor elastic")
def dolfinx(test):
    if importlib.util.find_spec("dolfinx") is None:
        test.skipTest("dolfinx is not installed")
    sys.path.insert(0, str(package.ROOT / "python" / "examples"))
    os.environ["XDG_CACHE_HOME"] = str(test.folder)  # of compiled forms
    import dolfinx_modes as example

    vertices, faces, frequencies, shapes, stresses = example.plate()
    wide = 1 / np.sqrt(1 - example.POISSON**2)  # of the frequency, where the plate cannot bend across
    root, length, thickness = CLAMPED[0], example.LENGTH, example.THICKNESS
    slender = root**2 / (2 * np.pi) * np.sqrt(example.YOUNG * thickness**2 / (12 * example.DENSITY * length**4))
    test.assertGreater(frequencies[0], slender)
    test.assertLess(frequencies[0], wide * slender)
    mass = example.DENSITY * length * example.BREADTH * thickness
    tip = np.abs(shapes[0, np.isclose(vertices[:, 0], length), 2]).mean()
    test.assertLess(abs(tip / (2 / np.sqrt(mass)) - 1), 0.01)  # shear, and corners that bend
    # the curvature of the beam where the clamp disturbs it no more, on the top, in the middle of the breadth
    k, s = root / 2, (np.cosh(root) + np.cos(root)) / (np.sinh(root) + np.sin(root))
    curvature = (root / length) ** 2 * (np.cosh(k) + np.cos(k) - s * (np.sinh(k) + np.sin(k))) / np.sqrt(mass)
    here = np.isclose(vertices, [length / 2, example.BREADTH / 2, thickness]).all(axis=1)
    test.assertEqual(here.sum(), 1)
    ratio = np.abs(stresses[0, here, 0])[0] / (0.5 * example.YOUNG * thickness * curvature)
    test.assertGreater(ratio, 1)
    test.assertLess(ratio, wide**2)

    modes.write(test.folder / "plate.vtu", vertices, faces.tolist(), frequencies, shapes, stresses)
    deck = f"""\
title: A block on a plate
time: {{end: 2 ms}}
bodies:
  block:
    shape: {{box: {{size: [0.1, 0.08, 0.1]}}}}
    position: [0.9, 0.15, 0.0715]
    spacing: 0.01
    velocity: [0, 0, -2]
    material: {{model: ordinary-state, youngs_modulus: 1 GPa, poissons_ratio: 0.25, density: 2000}}
impactors: {{plate: {{surface: {{file: plate.vtu}}, mass: {mass}, elastic: {{modes: plate.vtu}}}}}}
"""
    (test.folder / "deck.yaml").write_text(deck)
    simulation = perimpact.Simulation.from_deck(test.folder / "deck.yaml")
    simulation.run()
    test.assertGreater(simulation.history["plate.elastic_energy [J]"][-1], 0)


main()
