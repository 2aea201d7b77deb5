"""All decks against the case's expected.csv."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/ice_specimens"
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "tests/cases"), str(CASE)]
from claims import claim, main  # noqa: E402
from expected import expect_rows  # noqa: E402
from measure import measure, output_setting  # noqa: E402


@claim("ice_specimens: the decks give every row of expected.csv")
def full(scene):
    for deck in sorted(path.stem for path in CASE.glob("*.yaml")):
        scene.expect_success("run", CASE / f"{deck}.yaml", "--out", f"specimens/{deck}", "--set", output_setting(deck))
    expect_rows(scene, CASE / "expected.csv", measure(scene.folder / "specimens"))


main()
