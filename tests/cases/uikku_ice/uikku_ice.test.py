"""Claims about the decks of MT Uikku. The run is on a coarse, small sheet."""

import json
import math
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/uikku_ice"
sys.path[:0] = [str(ROOT / "tests/cli"), str(CASE)]
from claims import claim, main  # noqa: E402
from decks import FREE, deck, free_deck, name_of, ship_in, tests  # noqa: E402
from direction import hull, loads_of, sheet, strip  # noqa: E402
from level_ice import deflection_at_breaking  # noqa: E402
from resistance import ShipInIce, lindqvist  # noqa: E402


@claim("uikku_ice: the decks are those that follow from the measured ice")
def written(t):
    t.assertEqual(sorted(tests()), [103, 104, 205, 302, 403])
    for number, test in tests().items():
        text = (CASE / name_of(number)).read_text(encoding="utf-8")
        t.assertEqual(text, deck(number, test), number)
        t.assertIn(f"time: {{end: {ship_in(test).ends:.5g} s,", text)  # of the sample that compare.py measures
    for name in FREE:
        t.assertEqual((CASE / name).read_text(encoding="utf-8"), free_deck(name), name)


@claim("uikku_ice: no deck of the case gives a warning, and each has the strengths that were measured")
def checked(t):
    for number, test in tests().items():
        said = t.expect_no_warning("check", CASE / name_of(number), "--out", "checked")
        t.assertIn(f"yields            at {1e6 * test['compressive strength']:.4g} Pa in uniaxial compression\n", said.out)
        # a wide sheet carries 1/(1 - ν²) times the strength of the deck, with ν = 1/4 of bond-based peridynamics
        t.assertIn(f"flexural strength {1e3 * test['flexural strength'] * 15 / 16:.4g} Pa with 3 layers\n", said.out)


@claim("uikku_ice: the page has the table that compare.py prints")
def page(t):
    cells = lambda text: [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if re.match(r"\| \d+ \| [\d.]+ \|", line)]  # noqa: E731
    printed = cells(subprocess.run([sys.executable, CASE / "compare.py"], capture_output=True, text=True, check=True).stdout)
    t.assertEqual(len(printed), 5)
    t.assertEqual(cells((CASE / "README.md").read_text(encoding="utf-8")), printed)


@claim("uikku_ice: the page has the speeds of the driven ship that speeds.py prints, and the table has the thrust that its ships have")
def speeds(t):
    printed = subprocess.run([sys.executable, CASE / "speeds.py"], capture_output=True, text=True, check=True).stdout
    text = (CASE / "README.md").read_text(encoding="utf-8")
    rows = [line for line in printed.splitlines() if re.match(r"\| \d", line)]
    t.assertEqual(len(rows), len(FREE))
    for line in rows:
        t.assertIn(line + "\n", text)
        speed, thrust = float(line.split("|")[2]), float(line.split("|")[5])
        t.assertAlmostEqual(thrust / (1245.9 * (1 - speed / 8.75 / 3 - 2 / 3 * (speed / 8.75) ** 2)), 1, delta=2e-3)  # speeds are rounded to 0.01 m/s


@claim("uikku_ice: the page has what the published predictions imply, and predictions made with a known friction return it")
def published(t):
    import published as script

    printed = subprocess.run([sys.executable, CASE / "published.py"], capture_output=True, text=True, check=True).stdout
    text = (CASE / "README.md").read_text(encoding="utf-8")
    for line in (line for line in printed.splitlines() if line.startswith("| ")):
        t.assertIn(line, text)
    friction, error = script.implied_friction()
    t.assertIn(f"a friction of {friction:.3f} ± {error:.3f}", text)
    # predictions by the whole formula, with another friction: its crushing term is found, whatever the other terms
    ship = ship_in(tests()[302])
    made = [(replace(row_ship, friction=0.12), row) for row_ship, row in script.ships()]
    script.ships, original = lambda: iter([(one, {**row, "Lindqvist [kN]": str(lindqvist(one)["total"] / 1e3)}) for one, row in made]), script.ships
    try:
        parts, wanted = script.parts_of_lindqvist()
        t.assertAlmostEqual(max(abs(parts.sum(axis=1) / wanted - 1)), 0, delta=1e-12)  # the terms add up to the formula
        script.ships = lambda: iter([(replace(one, friction=ship.friction), {**row, "Lindqvist [kN]": str(lindqvist(one)["total"] / 1e3)}) for one, row in made])
        t.assertAlmostEqual(script.implied_friction()[0], 0.12, delta=1e-6)
    finally:
        script.ships = original


@claim("uikku_ice: the ship that is free floats at its draft, and no warning is given for it in ice of any thickness")
def free(t):
    for name, (thickness, _) in FREE.items():
        said = t.expect_no_warning("check", CASE / name, "--out", "checked")
        t.assertAlmostEqual(float(re.search(r"in this attitude it floats at a draft of (\S+) m", said.out)[1]), 9.5, delta=0.01)
        t.assertIn(f"{thickness:g} m of ice, starting at", said.out)


@claim("uikku_ice: strips and sheets in any direction of the lattice have the ice of test 302, a hull in front of it, and a stable step")
def direction(t):
    hull(t.program, t.folder / "hull.obj")
    for degrees in (0.0, 22.5):
        for name, made in (("strip", strip(degrees)), ("sheet", sheet(degrees))):
            folder = t.folder / f"{name}_{degrees:g}"
            folder.mkdir()
            (folder / "deck.yaml").write_text(json.dumps(made), encoding="utf-8")
            said = t.expect_success("check", folder / "deck.yaml", "--out", folder / "checked").out
            t.assertIn("flexural strength 6.272e+05 Pa with 3 layers", said)
            t.assertLess(float(re.search(r"([\d.]+) of the exact critical step", said)[1]), 0.62 if name == "sheet" else 0.9)  # fragments in contact need less
    # without a broken bond there is no load
    early = strip(0.0)
    early["time"]["end"], early["output"]["frames"] = 0.02, 2
    (t.folder / "early.yaml").write_text(json.dumps(early), encoding="utf-8")
    t.expect_success("run", "early.yaml", "--out", "early")
    t.assertTrue(all(math.isnan(number) for number in loads_of(t.folder / "early", 0.0)))


@claim("uikku_ice: the edge of a floating strip is as deep at breaking as the theory of the strip has it")
def deflection(t):
    # 0.288 m and 26.71 m for the plate of docs/theory/floating_strip.md
    strip = ShipInIce(thickness=2, strength=0.5e6, young=1.8e9)
    t.assertAlmostEqual(math.sqrt(2) * strip.characteristic_length, 26.71, delta=0.01)
    t.assertAlmostEqual(deflection_at_breaking(strip), 0.288, delta=0.001)
    # w = σ_f H² λ²/(3 · 0.3224 ρ_w g), and λ² is proportional to 1/√E
    soft = replace(strip, young=0.9e9)
    t.assertAlmostEqual(deflection_at_breaking(soft) / deflection_at_breaking(strip), math.sqrt(2), delta=1e-12)


@claim("uikku_ice: the window follows the ship, where F_z on the bow is cot 30 deg times F_x, and the energy balance closes")
def run(t):
    sheet, spacing = "bodies.sheet", 0.52  # two layers
    long, wide = 40 * spacing, 40 * spacing
    strip = lambda y: f"{{shape: {{box: {{size: [{long - 3 * spacing} m, {3 * spacing} m, 4 m]}}}}, position: [{1.5 * spacing} m, {y} m, 0]}}"  # noqa: E731
    settings = [
        f"{sheet}.spacing={spacing} m", f"{sheet}.shape.box.size=[{long} m, {wide} m, 1.04 m]", f"{sheet}.position=[{-long / 2} m, 0, -0.3932 m]",
        f"{sheet}.bending_calibration=none", f"{sheet}.moving_window.start_after=1 m",
        f"{sheet}.particle_sets.far_end={{shape: {{box: {{size: [{3 * spacing} m, {wide} m, 4 m]}}}}, position: [{(3 * spacing - long) / 2} m, 0, 0]}}",
        f"{sheet}.particle_sets.port={strip((3 * spacing - wide) / 2)}", f"{sheet}.particle_sets.starboard={strip((wide - 3 * spacing) / 2)}",
        f"{sheet}.particle_sets.far_rim={{shape: {{box: {{size: [2 m, {wide} m, 4 m]}}}}, position: [{(2 - long) / 2} m, 0, 0]}}",
        *(f"{sheet}.particle_sets.{side}_rim={{shape: {{box: {{size: [{long} m, 2 m, 4 m]}}}}, position: [0, {sign * (wide - 2) / 2} m, 0]}}"
          for side, sign in (("port", -1), ("starboard", 1))),
        "impactors.ship.motion={}", "impactors.ship.velocity=[-4 m/s, 0, 0]", "impactors.ship.surface.hull.edge_length=3 m", "impactors.ship.surface.hull.bow_edge_length=1.5 m",
        "contact.impactors.friction=0", "time={end: 1.5 s, step: 0.19 ms}", "output.frames=0", "output.history_interval=20 ms",
    ]  # fmt: skip
    t.expect_success("run", CASE / "deck.yaml", "--out", "r", *[word for setting in settings for word in ("--set", setting)])
    rows = t.history("r")
    back, up = (sum(rows[f"ship.bow.force_{axis} [N]"]) for axis in "xz")
    t.assertGreater(back, 1e5)
    t.assertAlmostEqual(up / back, 1 / math.tan(math.radians(30)), delta=1e-6)  # the geometry of every panel of the bow, to rounding
    # from 1 m on the window falls behind by less than eight spacings and the travel between two rows
    travel, window = 4 * 1.5, -rows["sheet.window_travel [m]"][-1]
    t.assertGreater(window, 0)
    t.assertLess(travel - 1 - window, 8 * spacing + 4 * 0.02 + 1e-9)
    work = -rows["ship.contact_work [J]"][-1]
    t.assertGreater(work, 1e5)
    t.assertLess(max(map(abs, rows["total.energy_balance_error [J]"])), 0.01 * work)


if __name__ == "__main__":
    main()
