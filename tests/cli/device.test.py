"""Runs with --device. The device is emulated; no test runs on a GPU."""

import os
import shutil
from pathlib import Path

from claims import MOVES, claim, main
from folders import SHORT, contents

CASES = Path(__file__).resolve().parents[2] / "cases"


def run(t, deck, device, out, *options):
    t.expect_success("run", deck, "--device", device, "--out", out, "--no-report", *options)
    return t.report(out)


def expect_same(t, deck, *options):
    """Bitwise the results of the scalar kernel; the report of the run on the device."""
    scalar = run(t, deck, "cpu-scalar", "scalar", "--force", *options)
    emulated = run(t, deck, "emulated", "emulated", "--force", *options)
    t.assertEqual(contents(t, "emulated"), contents(t, "scalar"))
    t.assertEqual(emulated["state_hash"], scalar["state_hash"])
    t.assertEqual(emulated["device"], "emulated on the host")
    t.assertNotIn("device", scalar)
    return emulated


def expect_broken(t, body):
    t.assertLess(body["intact_bonds"], body["bonds"])


@claim("device: a plate and all files of its results are bitwise those of the scalar kernel, also where bonds break")
def _(t):
    report = expect_same(t, t.deck(*SHORT))
    expect_broken(t, report["bodies"]["plate"])
    expect_same(t, t.deck(*SHORT, ("poissons_ratio: 0.25", "poissons_ratio: 0.33")))


@claim("device: a plate of a correspondence material, and a body whose window moves, have bitwise the files of the scalar kernel")
def _(t):
    report = expect_same(t, t.deck(*SHORT, ("model: ordinary-state", "model: correspondence")))
    expect_broken(t, report["bodies"]["plate"])
    expect_same(t, t.deck(*MOVES))
    t.assertNotEqual(t.history("emulated")["plate.window_travel [m]"][-1], 0)


FEW = ("--set", "output.frames=2")


@claim("device: shipped decks at reduced size have bitwise the results of the scalar kernel: impacted plate, notched plate")
def _(t):
    expect_same(t, CASES / "plate_impact/deck.yaml", "--set", "bodies.plate.spacing=2 mm", "--set", "bodies.plate.shape.box.size=[200 mm, 100 mm, 8 mm]",
                "--set", "time.step=0.2 us", "--set", "time.end=20 us", *FEW)
    notched = expect_same(t, CASES / "kalthoff_winkler/deck.yaml", "--set", "bodies.plate.shape.box.size=[100 mm, 100 mm, 3 mm]",
                          "--set", "bodies.plate.material.critical_stretch=0.003", "--set", "time.end=9 us", *FEW)
    expect_broken(t, notched["bodies"]["plate"])


@claim("device: shipped decks at reduced size have bitwise the results of the scalar kernel: a ship in level ice that is crushed, in rigid contact and where it is crushed in contact")
def _(t):
    ship = ("--set", "impactors.ship.position=[-0.15 m, 0, 0]", "--set", "impactors.ship.velocity=[-20 m/s, 0, 0]",
            "--set", "bodies.sheet.material.flexural_strength=50 kPa", "--set", "time.end=0.0088 s", *FEW)  # fmt: skip
    expect_same(t, CASES / "ship_ice/deck.yaml", *ship)
    t.assertGreater(t.history("emulated")["ship.crushing_dissipation [J]"][-1], 0)
    # an edge is crushed through: a particle takes 2.3 MPa times 0.296 m3
    expect_same(t, CASES / "ship_ice/deck.yaml", *ship, "--set", "impactors.ship.velocity=[-250 m/s, 0, 0]")
    t.assertGreater(t.history("emulated")["ship.crushing_dissipation [J]"][-1], 3e6)
    rigid = expect_same(t, CASES / "ship_ice/paper.yaml", *ship, "--set", "contact.impactors={friction: 0}")
    expect_broken(t, rigid["bodies"]["sheet"])
    t.assertGreater(t.history("emulated")["sheet.plastic_dissipation [J]"][-1], 0)


@claim("device: a checkpoint of the scalar kernel is resumed on a device, and one of a device by the scalar kernel, with the results of a run in one go")
def _(t):
    deck = t.deck(*SHORT, ("  frames: 4\n", "  frames: 0\n"))
    whole = run(t, deck, "cpu-scalar", "whole")
    for first, second in ("cpu-scalar", "emulated"), ("emulated", "cpu-scalar"):
        run(t, deck, first, first, "--set", "time.end=15 us")
        t.assertEqual(run(t, deck, second, first, "--resume")["state_hash"], whole["state_hash"])


@claim("device: where the library for GPUs is missing, of another version or finds no GPU, --device cuda is refused in one sentence")
def _(t):
    deck = t.deck(*SHORT)
    library = Path(t.program).parent / "libperimpact_cuda.so"
    if library.exists() and not Path("/dev/nvidiactl").exists():
        t.expect_complaint(t.run_program("run", deck, "--device", "cuda"), 2, "--device cuda: there is no usable GPU (", "omit --device")
    t.environment["PERIMPACT_CUDA_LIBRARY"] = "absent.so"
    t.expect_complaint(t.run_program("run", deck, "--device", "cuda"), 2, "--device cuda needs libperimpact_cuda.so, which cannot be opened (", "absent.so")
    t.environment["PERIMPACT_CUDA_LIBRARY"] = "libm.so.6"
    t.expect_complaint(t.run_program("run", deck, "--device", "cuda"), 2, "libm.so.6 is not of the version of this program; build both from the same sources.")
    del t.environment["PERIMPACT_CUDA_LIBRARY"]
    t.program = shutil.copy(t.program, t.folder)
    t.expect_complaint(t.run_program("run", deck, "--device", "cuda"), 2, "--device cuda needs libperimpact_cuda.so, which is not installed; build perimpact from "
                       "source where nvcc is installed, or omit --device.")
    t.assertEqual(t.files("."), sorted(["deck.yaml", os.path.basename(t.program)]))


@claim("device: what a deck needs and devices do not support is refused with its place")
def _(t):
    refused = {
        "quasi-static increments are not supported on a device": (("time: {end: 20 us}", "time: {end: 20 us, relax: {increments: 2}}"), ("  history_interval: 2 us\n", "")),
    }
    for what, changes in refused.items():
        done = t.run_program("run", t.deck(*changes), "--device", "emulated")
        t.assertEqual(done.code, 2, done)
        t.assertIn(f": {what}; omit --device.", done.err)
        t.assertRegex(done.err, r"deck.yaml:\d+:\d+")


main()
