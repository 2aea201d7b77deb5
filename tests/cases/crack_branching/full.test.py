"""The whole deck against the case's expected.csv."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/crack_branching"
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "tests/cases"), str(CASE)]
from claims import claim, main  # noqa: E402
from expected import expect_rows  # noqa: E402


@claim("crack_branching: the deck gives every row of expected.csv")
def full(scene):
    try:
        from measure import frames, measure
    except ImportError as reason:  # numpy is missing
        raise unittest.SkipTest(str(reason)) from reason
    scene.expect_success("run", CASE / "deck.yaml", "--out", "out", "--force")
    expect_rows(scene, CASE / "expected.csv", measure(frames(scene.folder / "out")))


main()
