"""Decks that are written from the data of a ship and of level ice."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SCRIPT = ROOT / "cases/ship_ice/level_ice.py"
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "cases/ship_ice")]
from claims import claim, main  # noqa: E402
from level_ice import LevelIceRun, deck  # noqa: E402

# another ship than those of the cases, in thinner and stronger ice
OPTIONS = ["--length", "120", "--beam", "20", "--draft", "7", "--stem", "28", "--waterline", "26", "--fullness", "1.6", "--displacement", "11000e3", "--friction", "0.1",
           "--thickness", "0.8", "--young", "3e9", "--strength", "550e3", "--compressive-strength", "3e6", "--speed", "1.5"]  # fmt: skip


def write(t, *options):
    return subprocess.run([sys.executable, SCRIPT, *options, "--out", t.folder / "ship.yaml"], capture_output=True, text=True, check=False)


@claim("level ice: the deck of a ship is accepted without a warning, with the strengths of its ice and a step below the stable one")
def accepted(t):
    said = write(t, *OPTIONS)
    t.assertEqual(said.returncode, 0, said.stderr)
    checked = t.expect_no_warning("check", "ship.yaml", "--out", "checked").out
    t.assertIn("yields            at 3e+06 Pa in uniaxial compression", checked)
    t.assertIn(f"flexural strength {550e3 * 15 / 16:.4g} Pa with 3 layers", checked)  # 1/(1 - ν²) times this in a wide sheet
    t.assertLess(float(re.search(r"([\d.]+) of the exact critical step", checked)[1]), 0.62)
    # the window starts to follow at the length of the bow, which the program measures on the hull
    bow = float(re.search(r"bow, stern\s+([\d.]+)", t.expect_success("shape", "hull", "--length", "120", "--breadth", "20", "--draft", "7", "--freeboard", "6",
        "--stem-angle", "28 deg", "--waterline-angle", "26 deg", "--fullness", "1.6", "--edge-length", "2", "--out", "hull.stl").out)[1])  # fmt: skip
    start = float(re.search(r"start_after: (\d+) m", (t.folder / "ship.yaml").read_text(encoding="utf-8"))[1])
    t.assertGreaterEqual(start, bow)
    t.assertLess(start, bow + 1)


@claim("level ice: no ship and no ice is assumed where their data are not given")
def needed(t):
    for n in range(0, len(OPTIONS), 2):
        if OPTIONS[n] in ("--fullness", "--displacement"):
            continue
        said = write(t, *OPTIONS[:n], *OPTIONS[n + 2 :])
        t.assertEqual(said.returncode, 2)
        t.assertIn(f"required: {OPTIONS[n]}", said.stderr)
        t.assertFalse((t.folder / "ship.yaml").exists())


@claim("level ice: sheets of any thickness are whole numbers of spacings")
def whole(t):
    for hundredths in range(20, 400):
        text = deck(LevelIceRun(thickness=hundredths / 100), "title", "# heading", "results/r")
        sizes = re.search(r"box: {size: \[(\S+) m, (\S+) m, (\S+) m\]}}\n", text).groups()
        counts = re.search(r"spacing: (\S+) m +# (\d+) x (\d+) x", text).groups()
        for size, count in zip(sizes, (*counts[1:], 3)):
            t.assertLess(abs(float(size) / float(counts[0]) / int(count) - 1), 1e-6, hundredths)  # which the program accepts


@claim("level ice: the interval that the script prints for the mean is the end of the run, of ten cusps and more at the speed of the run")
def interval(t):
    said = write(t, *OPTIONS).stdout
    begin, end = (float(number) for number in re.search(r"--from ([\d.]+) --to ([\d.]+)", said).groups())
    t.assertAlmostEqual(end, float(re.search(r"end: ([\d.]+) s", (t.folder / "ship.yaml").read_text(encoding="utf-8"))[1]), delta=0.01)
    length = (3e9 * 0.8**3 / (12 * (1 - 0.25**2) * 1025 * 9.81)) ** 0.25
    t.assertGreater(1.5 * (end - begin), 10 * 0.32 * length - 0.02)


@claim("level ice: a ship that is driven is free in surge and heave, floats, and has its net thrust at every speed")
def driven(t):
    t.assertEqual(write(t, *OPTIONS, "--bollard-pull", "500e3", "--open-water-speed", "8").returncode, 0)
    checked = t.expect_no_warning("check", "ship.yaml", "--out", "checked").out
    t.assertIn("it floats at a draft of", checked)
    deck = (t.folder / "ship.yaml").read_text(encoding="utf-8")
    t.assertIn("free_dofs: [x, z]", deck)
    speeds, factors = ([float(word) for word in re.search(rf"{name}: \[([^\]]*)\]", deck)[1].split(", ")] for name in (" speeds", "speed_factors"))
    t.assertIn("force: [-500 kN, 0, 0], speeds", deck)
    t.assertEqual((speeds[0], factors[0]), (0, 1))
    t.assertGreater(speeds[-1], 8)  # faster than in open water it is braked
    for speed in (0.7, 3.3, 5.1, 8, 9):
        k = next(k for k, end in enumerate(speeds) if end >= speed)
        linear = factors[k - 1] + (factors[k] - factors[k - 1]) * (speed - speeds[k - 1]) / (speeds[k] - speeds[k - 1])
        t.assertAlmostEqual(linear, 1 - speed / 24 - 2 * speed * speed / 192, delta=2e-3)  # a chord of 0.8 m/s: 0.8² · (4/3/64)/8


@claim("level ice: a slow ship with the inertial forces of a faster one has ice that is heavier by the square of their ratio, and steps longer by the ratio")
def inertial(t):
    def numbers(inertial_speed):
        write(t, *OPTIONS[:-1], "0.3", "--inertial-speed", str(inertial_speed))
        text = (t.folder / "ship.yaml").read_text(encoding="utf-8")
        (t.folder / "ship.yaml").unlink()
        patterns = (r"step: ([\d.]+) ms", r"mass_scaling: ([\d.]+)", r"velocities: \[-([\d.]+)", r"reflection: ([\d.]+)")
        return [float(re.search(pattern, text)[1]) for pattern in patterns]

    plain, scaled = numbers(0), numbers(1.2)
    for ratio, (before, after) in zip((4, 16, 0.5, 1), zip(plain, scaled)):  # the approach at 0.75 m/s, with the inertial forces of 3 m/s
        t.assertAlmostEqual(after / before, ratio, delta=0.006 * ratio)  # three digits are written
    t.assertEqual(numbers(0.2), plain)  # slower than the ship
    write(t, *OPTIONS[:-1], "0.3", "--inertial-speed", "1.2")
    t.expect_no_warning("check", "ship.yaml", "--out", "checked")


@claim("level ice: with four layers spacing and step are smaller, the strength is the same, and one layer alone is fixed at the edges, which can rotate")
def layers(t):
    write(t, *OPTIONS)
    three = (t.folder / "ship.yaml").read_text(encoding="utf-8")
    (t.folder / "ship.yaml").unlink()
    t.assertEqual(write(t, *OPTIONS, "--layers", "4").returncode, 0)
    four = (t.folder / "ship.yaml").read_text(encoding="utf-8")
    for pattern in (r"spacing: ([\d.]+) m", r"step: ([\d.]+) ms"):
        before, after = (float(re.search(pattern, text)[1]) for text in (three, four))
        t.assertAlmostEqual(after / before, 3 / 4, delta=0.004)  # three digits are written
    checked = t.expect_no_warning("check", "ship.yaml", "--out", "checked").out
    t.assertIn(f"flexural strength {550e3 * 15 / 16:.4g} Pa with 4 layers", checked)
    counts = [int(count.replace(" ", "")) for count in re.search(r"spacing: \S+ m +# (\d+) x (\d+) x 4 particles", four).groups()]
    fixed = {name: int(count) for name, count in re.findall(r"sheet\.(ahead|left|right) +fixed, (\d+) particles", checked)}
    t.assertEqual(fixed, {"ahead": 3 * counts[1], "left": 3 * (counts[0] - 3), "right": 3 * (counts[0] - 3)})


@claim("level ice: with more ice behind the stem the sheet is longer by as much and the window follows later; the ship travels as far")
def astern(t):
    def numbers(*options):
        write(t, *OPTIONS, *options)
        text = (t.folder / "ship.yaml").read_text(encoding="utf-8")
        (t.folder / "ship.yaml").unlink()
        patterns = (r"box: {size: \[([\d.]+) m", r"start_after: ([\d.]+) m", r"end: ([\d.]+) s")
        return [float(re.search(pattern, text)[1]) for pattern in patterns]

    (length, start, end), (longer, later, same_end) = numbers(), numbers("--astern", "80")
    t.assertEqual((later, same_end), (80, end))
    t.assertAlmostEqual(longer - length, 80 - start, delta=8 * 0.8 / 3)  # lengths are multiples of eight spacings
    write(t, *OPTIONS, "--astern", "80")
    t.expect_no_warning("check", "ship.yaml", "--out", "checked")


@claim("level ice: the hull has the stem radius that is given, and a sharp stem without one")
def stem(t):
    for options, words in (([], "fullness: 1.6, edge_length"), (["--stem-radius", "0.4"], "fullness: 1.6, stem_radius: 0.4 m, edge_length")):
        write(t, *OPTIONS, *options)
        t.assertIn(words, (t.folder / "ship.yaml").read_text(encoding="utf-8"))
        t.expect_no_warning("check", "ship.yaml", "--out", "checked")
        (t.folder / "ship.yaml").unlink()


@claim("level ice: data that are impossible, and a file that exists, are refused with a sentence")
def refused(t):
    for change, words in (
        (["--thickness", "0"], "--thickness is 0, but must be positive."),
        (["--waterline", "95"], "--waterline is 95, but must be an angle from 2 to 90 degrees."),
        (["--stem", "0.49"], "--stem is 0.49, but must be an angle from 2 to 90 degrees."),  # radians
        (["--fullness", "9"], "--fullness is 9, but must be from 1 to 4."),
        (["--strength", "0.55", "--compressive-strength", "3"], "--strength is 0.55 Pa, but ice has more than 1000 Pa; give it in Pa"),
        (["--young", "3"], "--young is 3 Pa, but ice has more than 1e+06 Pa"),
        (["--compressive-strength", "5e5"], "must exceed --strength"),
        (["--ice", "1030"], "does not float"),
        (["--ahead=-1"], "--ahead is -1, but must be positive."),
        (["--friction=-0.1"], "--friction is -0.1, but must not be negative."),
        (["--inertial-speed=-1"], "--inertial-speed is -1, but must not be negative."),
        (["--layers", "1"], "--layers is 1, but must be at least 2"),
        (["--astern", "20"], "--astern is 20, but must be at least the length of the bow (33 m)"),
        (["--bollard-pull", "5e5"], "--open-water-speed is 0, but must exceed --speed (1.5)"),
        (["--open-water-speed", "8"], "--open-water-speed is given without --bollard-pull"),
    ):
        said = write(t, *OPTIONS, *change)
        t.assertEqual(said.returncode, 2)
        t.assertIn(words, said.stderr)
        t.assertFalse((t.folder / "ship.yaml").exists())
    (t.folder / "ship.yaml").write_text("mine", encoding="utf-8")
    said = write(t, *OPTIONS)
    t.assertIn("ship.yaml exists; remove it, or choose another --out.", said.stderr)
    t.assertEqual((t.folder / "ship.yaml").read_text(encoding="utf-8"), "mine")


if __name__ == "__main__":
    main()
