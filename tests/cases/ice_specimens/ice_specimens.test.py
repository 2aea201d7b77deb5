"""Specimens of ice that yields: what they carry, and that their energy closes."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/ice_specimens"
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "scripts/results"), str(CASE)]
from claims import claim, main, variants  # noqa: E402
from measure import EDGES, measure, width_of_sphere  # noqa: E402
from vtp_reader import pictures  # noqa: E402

SPLITTING = 0.502  # [MPa] as expected.csv has it


@claim("ice_specimens: a prism carries its compressive strength, and its plastic strain is an array of the frames")
def compression(scene):
    scene.expect_success("run", CASE / "compression.yaml", "--out", "specimens/compression", "--set", "output.frames=2")
    found = measure(scene.folder / "specimens")
    print(found)
    scene.assertAlmostEqual(found["compressive strength [MPa]"] / 2.3, 1, delta=0.05)  # as expected.csv has it
    scene.assertLess(found["compression energy error [-]"], 1e-6)
    scene.assertIn(b'Name="plastic_strain"', (scene.folder / "specimens/compression/frames/ice_00002.vtp").read_bytes())
    scene.assertGreater(scene.history("specimens/compression")["ice.plastic_dissipation [J]"][-1], 0)


@claim("ice_specimens: a prism of crushed ice carries its compressive strength once, and little afterwards")
def crushed(scene):
    scene.expect_success("run", CASE / "crushed.yaml", "--out", "specimens/crushed", "--set", "output.frames=0", "--set", "time.end=17 ms")
    found = measure(scene.folder / "specimens")
    print(found)
    scene.assertAlmostEqual(found["crushed strength [MPa]"] / 2.3, 1, delta=0.05)  # as expected.csv has it
    scene.assertLess(found["crushed residual strength [-]"], 0.2)
    scene.assertLess(found["crushed energy error [-]"], 1e-5)


@claim("ice_specimens: scaled constants scale the strength")
def scaled(scene):
    scene.expect_success("run", CASE / "compression.yaml", "--out", "specimens/compression", "--set", "output.frames=0", "--set", "time.end=8 ms",
                         "--set", "bodies.ice.material.plasticity.compressive_strength=1.2 MPa")  # fmt: skip
    scene.assertAlmostEqual(measure(scene.folder / "specimens")["compressive strength [MPa]"] / 1.2, 1, delta=0.05)


@claim("ice_specimens: check reports the compressive strength, and where free faces split before it is reached")
def checked(scene):
    done = scene.expect_success("check", CASE / "compression.yaml")
    scene.assertIn("yields            at 2.3e+06 Pa in uniaxial compression\n", done.out)
    strong = scene.expect_success("check", CASE / "compression.yaml", "--set", "bodies.ice.material.plasticity.compressive_strength=6 MPa")
    scene.assertIn("at 6e+06 Pa in uniaxial compression; specimens with free faces split before, at about 4.8e+06 Pa\n", strong.out)


@claim("ice_specimens: check reports what layers carry in bending, and at which stress ice without plasticity breaks in compression")
def implied(scene):
    stiff = scene.expect_success("check", CASE / "bending.yaml")
    scene.assertIn("flexural strength 5e+05 Pa with 8 layers\n", stiff.out)
    soft = scene.expect_success("check", CASE / "bending.yaml", "--set", "bodies.ice.bending_calibration=none", "--set",
                                "bodies.ice.shape={box: {size: [2, 0.8, 0.2]}}")  # fmt: skip
    # a beam of such layers breaks at 0.471 MPa
    found = re.search(r"flexural strength 5e\+05 Pa with 8 layers; with the bending stiffness of these layers (\S+) Pa\n", soft.out)
    scene.assertAlmostEqual(float(found[1]) / 0.471e6, 1, delta=0.01)
    material = "bodies.ice.material={model: bond-based, youngs_modulus: 1.8 GPa, density: 900, critical_stretch: 3.2e-4}"
    for hardening, sentence in (
        ("0", "bonds break       at 2.304e+06 Pa in uniaxial compression where strain is uniform; specimens with free faces at about 1.56e+06 Pa\n"),
        ("0.3", "bonds break       never in uniaxial compression, where strain is uniform; specimens with free faces at about 8.23e+06 Pa\n"),
        ("0.4", "bonds break       never in uniaxial compression\n"),
    ):
        done = scene.expect_success("check", CASE / "compression.yaml", "--set", material, "--set", f"bodies.ice.failure={{compression_hardening: {hardening}}}")
        scene.assertIn(sentence, done.out)


@claim("ice_specimens: ice that may yield has the estimated and the exact critical step of ice that may not")
def step(scene):
    bond_based = "bodies.ice.material={model: bond-based, youngs_modulus: 1.8 GPa, density: 900, critical_stretch: 3.2e-4PLASTICITY}"
    found = []
    for plasticity in ("", ", plasticity: {compressive_strength: 2.3 MPa}", ", plasticity: {compressive_strength: 2.3 MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}"):
        done = scene.expect_success("check", CASE / "compression.yaml", "--out", "checked", "--set", bond_based.replace("PLASTICITY", plasticity))
        found.append(re.search(r"of the estimated stable step \((\S+) s\), \S+ of the exact critical step \((\S+) s\)", done.out).groups())
        scene.assertEqual("yields" in done.out, bool(plasticity))
    scene.assertEqual(len(set(found)), 1, found)


@claim("ice_specimens: a disc splits where tension across its loaded diameter is 0.8 E s_c, and the crack lies on that diameter")
def splitting(scene):
    scene.expect_success("run", CASE / "brazilian.yaml", "--out", "specimens/brazilian", "--set", "output.frames=1", "--set", "time.end=10.5 ms")
    found = measure(scene.folder / "specimens")
    print(found)
    scene.assertAlmostEqual(found["splitting strength [MPa]"] / SPLITTING, 1, delta=0.05)  # as expected.csv has it
    scene.assertLess(found["splitting energy error [-]"], 1e-5)
    *_, (_, disc) = pictures(scene.folder / "specimens/brazilian", "ice")
    first = disc.points - disc.point["displacement"]
    broken = disc.point["damage"] > 0.3
    inner = abs(first[:, 2]) < 0.1
    scene.assertGreater(sum(broken & inner), 50)
    scene.assertLess(abs(first[broken & inner, 0]).max(), 0.03)  # the horizon
    scene.assertGreater(disc.points[broken & inner & (first[:, 0] > 0), 0].mean() - first[broken & inner & (first[:, 0] > 0), 0].mean(), 0)  # it opens


@claim("ice_specimens: a prism pulled apart carries 11 % less than E s_c")
def tension(scene):
    scene.expect_success("run", CASE / "tension.yaml", "--out", "specimens/tension", "--set", "output.frames=0")
    found = measure(scene.folder / "specimens")
    scene.assertAlmostEqual(found["tensile strength [MPa]"] / 0.511, 1, delta=0.02)
    scene.assertLess(found["tension energy error [-]"], 1e-5)


@claim("ice_specimens: a specimen that ended before it broke has no strength, and measure.py refuses it")
def unbroken(scene):
    scene.expect_success("run", CASE / "tension.yaml", "--out", "specimens/tension", "--set", "output.frames=0", "--set", "time.end=2 ms")
    done = subprocess.run([sys.executable, CASE / "measure.py", scene.folder / "specimens"], capture_output=True, text=True, check=False)
    scene.assertEqual((done.returncode, done.stdout), (2, ""))
    scene.assertIn("tension ended before a bond broke", done.stderr)


@claim("ice_specimens: a ball that only yields rebounds with less than a fifth of its speed, and its energy closes")
def ball(scene):
    scene.expect_success("run", CASE / "ball.yaml", "--out", "specimens/ball", "--set", "output.frames=0", "--set", "bodies.ice.spacing=0.0625")
    found = measure(scene.folder / "specimens")
    print(found)
    scene.assertGreater(found["ball impulse [-]"], 1)
    scene.assertLess(found["ball impulse [-]"], 1.2)  # 1.13 here; 1.96 of a ball that stays elastic (cases/ice_sphere)
    scene.assertLess(found["ball energy error [-]"], 1e-4)


@claim("ice_specimens: every indenter and impactor is predicted to make contact with the ice before the end, and a narrow indenter makes contact at once")
def indenters(scene):
    for name in ("drop", "indentation", *EDGES):
        done = scene.expect_success("check", CASE / f"{name}.yaml")
        scene.assertRegex(done.out, r"first contact     with ice at \S+ s \(step \d+\)", name)
    scene.expect_success("run", CASE / "edge_narrow.yaml", "--out", "specimens/edge_narrow", "--set", "output.frames=1", "--set", "time.end=0.6 ms")
    found = measure(scene.folder / "specimens")
    scene.assertGreater(found["edge_narrow [-]"], 0.1)
    scene.assertLess(found["edge_narrow energy error [-]"], 1e-3)


@claim("ice_specimens: every run of variants.sh makes contact, or has loads, and perimpact check accepts it")
def variants_of_the_page(scene):
    runs = variants(CASE)
    scene.assertEqual([name for _, name, _ in runs], ["kierkegaard_coarse/drop", "riska/drop", "riska_coarse/drop", "riska_whole/drop", "crushed/indentation", "uncalibrated/bending"])
    for deck, name, settings in runs:
        out = scene.expect_success("check", deck, "--out", name, *(word for setting in settings for word in ("--set", setting))).out
        if "bending" not in name:
            scene.assertRegex(out, r"first contact     with ice at \S+ s \(step \d+\)", name)


@claim("ice_specimens: the width of a sphere in an edge is the mean width of its section over the thickness")
def sphere_in_an_edge(scene):
    for depth in (0.001, 0.0038, 0.007):  # below and above the thickness of 0.06
        heights = [0.06 * (number + 0.5) / 20000 - 0.03 for number in range(20000)]
        chords = [2 * max(0.0, 0.12**2 - (0.12 - depth) ** 2 - height**2) ** 0.5 for height in heights]
        scene.assertAlmostEqual(width_of_sphere(depth) * len(chords) / sum(chords), 1, delta=1e-6)  # midpoint rule


@claim("ice_specimens: check says to the deck of the calibration page what the page quotes")
def calibration(scene):
    page = (ROOT / "docs/guide/calibration.md").read_text(encoding="utf-8")
    deck = re.search(r"\n\n((?:    .+\n)*    bodies:\n(?:    .+\n)+)", page)[1]
    (scene.folder / "sheet.yaml").write_text("".join(line[4:] for line in deck.splitlines(keepends=True)))
    quoted = re.search(r"reports what this implies .+:\n\n((?: {6}.+\n)+)", page)[1]
    out = scene.expect_success("check", "sheet.yaml").out
    scene.assertGreaterEqual(quoted.count("\n"), 3)
    for line in quoted.splitlines():
        scene.assertIn(line.strip() + "\n", out)
    soft = scene.expect_success("check", "sheet.yaml", "--set", "bodies.sheet.bending_calibration=none").out
    scene.assertIn(re.search(r"\| without `bending_calibration` \| (.+) \|", page)[1] + "\n", soft)


@claim("ice_specimens: plasticity that contradicts the deck ends with a sentence and exit code 2")
def refused(scene):
    for change, sentence in (
        ("bodies.ice.material.model=correspondence", "but the model is correspondence; change the model, or remove plasticity."),
        ("bodies.ice.material.plasticity.compressive_strength=-1 MPa", "compressive_strength is \"-1 MPa\", but it must be above 0."),
        ("bodies.ice.material.plasticity.surface=kierkegaard", "compressive_strength is given beside surface: kierkegaard"),
    ):
        done = scene.run_program("check", CASE / "compression.yaml", "--set", change)
        scene.assertEqual(done.code, 2)
        scene.assertIn(sentence, done.err)


main()
