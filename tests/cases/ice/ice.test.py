"""Properties of ice: numbers done by hand, and a page that says what its script computes."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "docs/theory")]
from claims import claim, main  # noqa: E402
from ice import PAGE, brine_volume, compressive_strength, critical_stretch, flexural_strength, page, youngs_modulus  # noqa: E402


@claim("ice: five parts per thousand of salt at minus ten degrees make 2.7 % of brine, 0.67 MPa and 8.0 GPa")
def by_hand(scene):
    brine = brine_volume(-10, 5)  # 5 · (4.9185 + 0.532)/1000
    scene.assertAlmostEqual(brine, 0.0272525, delta=1e-12)
    scene.assertAlmostEqual(flexural_strength(brine), 0.6667e6, delta=50)  # 1.76 · exp(−5.88 · 0.165083), by a table of exp to four digits
    scene.assertAlmostEqual(youngs_modulus(brine), 8.0434e9, delta=1e5)  # 10 · (1 − 0.0956563) − 1
    scene.assertEqual((flexural_strength(0), youngs_modulus(0)), (1.76e6, 9e9))
    scene.assertAlmostEqual(critical_stretch(0.5e6, 1.8e9, 6), 0.5 / 1800 * 5 / 6, delta=1e-15)


@claim("ice: with 30 parts per thousand of pores columnar ice carries 5.40 MPa along the sheet at a strain rate of 1e-3 1/s, and a tenth of the rate costs 40 %")
def compression(scene):
    # 1e-3^0.22 = 10^-0.66 = 0.218776; √(30/270) = 1/3: 37 · 0.218776 · 2/3
    scene.assertAlmostEqual(compressive_strength(0.03, 1e-3), 5.39648e6, delta=50)
    scene.assertAlmostEqual(compressive_strength(0.03, 1e-4) / compressive_strength(0.03, 1e-3), 0.602560, delta=1e-6)  # 10^-0.22
    scene.assertAlmostEqual(compressive_strength(0.05, 1e-3, "columnar, across the sheet"), 17.5021e6, delta=50)  # 160 · 0.218776 · (1 − 1/2)
    scene.assertAlmostEqual(compressive_strength(0.07, 1e-3, "granular"), 5.36001e6, delta=50)  # 49 · 0.218776 · (1 − 1/2)


@claim("ice: the tables of the page are what its script computes")
def tables(scene):
    text = PAGE.read_text()
    scene.assertEqual(page(text), text)
    scene.assertGreater(text.count("| −"), 12)


main()
