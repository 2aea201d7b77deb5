"""docs/validation.md: it says what the numbers kept say, every row can fail, and its verdicts stand on rows. Python's standard library alone."""

import re
import shutil
import subprocess
import sys
import unittest
from dataclasses import replace
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "validation")]
from claims import claim, main  # noqa: E402
from page import KEPT, TOPICS, all_numbers, failures, module, of_topic, page, verdicts  # noqa: E402
from predictions import predictions  # noqa: E402
from rows import read_records  # noqa: E402

RUN = "/usr/bin/python3", ROOT / "validation/run.py"


def rows():
    return [(topic, row) for topic in TOPICS for row in module(topic).rows()]



@claim("the page is what the committed numbers give, and every row of it passes")
def page_is_up_to_date(t):
    numbers = all_numbers()
    t.assertEqual((ROOT / "docs/validation.md").read_text(encoding="utf-8"), page(numbers), "validation/run.sh --update writes it anew")
    t.assertEqual(failures(numbers), [])
    t.assertGreater(len(rows()), 60)


@claim("a row fails on the page as soon as its number is outside of its tolerance, on either side that is wrong")
def rows_can_fail(t):
    numbers = all_numbers()
    for topic, row in rows():
        for value in row.bound.outside():
            moved = {**of_topic(topic, numbers), row.number: value}
            t.assertFalse(row.passes(moved), f"{topic}: {row.claim}: {value} passes, wanted {row.bound}")
            t.assertIn("**FAIL**", row.line(moved))


@claim("a number that is moved in the file where it is kept makes the page fail, and with it the verdict that stands on it")
def moved_in_its_file(t):
    kept = t.folder / "measured"
    shutil.copytree(KEPT, kept)
    lines = (kept / "plate.csv").read_text().splitlines()
    (at,) = [i for i, line in enumerate(lines) if line.startswith("centre,")]
    value = float(lines[at].split(",")[1])
    lines[at] = f"centre,{1.02 * value}"  # 1.5 % is allowed
    (kept / "plate.csv").write_text("\n".join(lines) + "\n")
    numbers = all_numbers((kept,))
    t.assertEqual([sentence.split(":")[0] for sentence in failures(numbers)], ["plate"])
    first, *others = [verdict for _, verdict in verdicts(numbers)]
    t.assertEqual(first, "**FAIL**")
    t.assertNotIn("**FAIL**", others)


@claim("a prediction is met within its target and not met beyond it, and every test of MT Uikku that was run is among them")
def predictions_may_miss(t):
    numbers = all_numbers()
    found = predictions(numbers)
    run = {row["test"] for row in read_records(ROOT / "cases/uikku_ice/results.csv")}
    of_tests = {one.subject.split()[4].rstrip(","): one for one in found if "Uikku, model test" in one.subject}
    t.assertEqual(set(of_tests), run)
    t.assertEqual({test for test, one in of_tests.items() if not one.has_target}, run & {"403"})
    (mean,) = [one for one in found if "Uikku, mean" in one.subject]
    deviations = [one.value / one.target.wanted for one in of_tests.values() if one.has_target]
    t.assertAlmostEqual(mean.value, sum(deviations) / len(deviations), delta=1e-12)
    for one in found:
        if not one.has_target:
            t.assertIn("| no target |", one.line())
            continue
        for value in one.target.outside():
            t.assertIn("**not met**", replace(one, value=value).line())
        t.assertIn("| met |", replace(one, value=one.target.wanted).line())
        t.assertIn(one.line(), page(numbers))


@claim("what a verdict on the paper stands on are numbers of rows")
def verdicts_stand_on_rows(t):
    named = {f"{topic}.{row.number}" for topic, row in rows()}
    found = verdicts(all_numbers())
    t.assertEqual(len(found), 6)
    for conclusion, verdict in found:
        t.assertNotEqual(verdict, "**FAIL**", conclusion.claim)
        t.assertTrue(conclusion.stands_on)
        t.assertLessEqual(set(conclusion.stands_on), named, conclusion.claim)


@claim("every figure and page that the page links to is there")
def links(t):
    text = (ROOT / "docs/validation.md").read_text(encoding="utf-8")
    targets = re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text)
    t.assertGreater(len(targets), 20)
    for target in targets:
        if not target.startswith("http"):
            t.assertTrue((ROOT / "docs" / target).exists(), target)


@claim("a topic that does not exist, one that is long, and a program that is missing are reported in a sentence")
def mistakes(t):
    def reported(*arguments):
        printed = subprocess.run([*RUN, "--results", t.folder / "results", *arguments], capture_output=True, text=True)
        t.assertEqual(printed.returncode, 2, printed)
        t.assertEqual(len(printed.stderr.splitlines()), 1, printed.stderr)
        return printed.stderr

    t.assertIn("error: there is no topic plates; the topics are: plate, ", reported("plates"))
    t.assertIn("error: panels takes long; give --long with it", reported("panels", "--perimpact", t.program))
    t.assertIn("nowhere is not there; ./run.sh or ./test.sh builds it", reported("plate", "--perimpact", t.folder / "nowhere"))


@claim("a topic that is measured anew writes its numbers and the page into the folder of the results, and nothing into the tree")
def measured_anew(t):
    before = {path: path.stat().st_mtime_ns for path in [ROOT / "docs/validation.md", *sorted(KEPT.iterdir())]}
    try:
        import numpy  # noqa: F401  only whether it is there
    except ImportError as missing:
        raise unittest.SkipTest(str(missing)) from missing
    printed = subprocess.run([*RUN, "--results", t.folder / "results", "--perimpact", t.program, "convergence"], capture_output=True, text=True)
    t.assertEqual((printed.returncode, printed.stderr), (0, ""), printed)
    t.assertTrue((t.folder / "results/convergence.csv").exists())
    t.assertIn("Convergence to exact solutions", (t.folder / "results/validation.md").read_text(encoding="utf-8"))
    t.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)


main()
