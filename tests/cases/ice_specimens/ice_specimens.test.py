"""Specimens of ice that yields: what they carry, and that their energy closes."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/ice_specimens"
sys.path[:0] = [str(ROOT / "tests/cli"), str(CASE)]
from claims import claim, main  # noqa: E402
from measure import measure  # noqa: E402


@claim("ice_specimens: a prism carries its compressive strength, and its plastic strain is an array of the frames")
def compression(scene):
    scene.expect_success("run", CASE / "compression.yaml", "--out", "specimens/compression", "--set", "output.frames=2")
    found = measure(scene.folder / "specimens")
    print(found)
    scene.assertAlmostEqual(found["compressive strength [MPa]"] / 2.3, 1, delta=0.05)  # as expected.csv has it
    scene.assertLess(found["compression energy error [-]"], 1e-6)
    scene.assertIn(b'Name="plastic_strain"', (scene.folder / "specimens/compression/frames/ice_00002.vtp").read_bytes())
    scene.assertGreater(scene.history("specimens/compression")["ice.plastic_dissipation [J]"][-1], 0)


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
