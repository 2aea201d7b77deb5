"""The tutorials do what they say: each command of a page runs, and each row of its tables of values holds (docs/guide/tutorials)."""

import csv
import json
import re
import shlex
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PAGES = ROOT / "docs/guide/tutorials"
sys.path.insert(0, str(ROOT / "tests/cli"))
from claims import claim, main  # noqa: E402

COLUMN = re.compile(r"(first|last|largest|smallest|sum of) `([^`]+)` in `([^`]+\.csv)`")
RATIO = re.compile(r"sum of `([^`]+)` over sum of `([^`]+)` in `([^`]+\.csv)`")
REPORT = re.compile(r"`([^`]+)` in `([^`]*run\.json)`")
PICK = {"first": lambda values: values[0], "last": lambda values: values[-1], "largest": max, "smallest": min, "sum of": sum}


def commands_of(page):
    """The lines of indented blocks that call the program, as lists of words."""
    return [shlex.split(line)[1:] for line in page.splitlines() if line.startswith("    perimpact ")]


def rows_of(page):
    """Of the tables "| quantity | where | value | within |": where, value, tolerance."""
    rows, is_inside = [], False
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if cells == ["quantity", "where", "value", "within"]:
            is_inside = True
        elif not line.startswith("|"):
            is_inside = False
        elif is_inside and not set(line) <= set("|-"):
            rows.append((cells[1], float(cells[2]), float(cells[3])))
    return rows


def column(path, name):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return [float(row[name]) for row in rows]


def look_up(scene, folder, where):
    """The number that a row names. Files count from the folder of the results, or name their own."""

    def path(name):
        return scene.folder / (name if name.startswith("results/") else f"{folder}/{name}")

    if found := COLUMN.fullmatch(where):
        return PICK[found[1]](column(path(found[3]), found[2]))
    if found := RATIO.fullmatch(where):
        return sum(column(path(found[3]), found[1])) / sum(column(path(found[3]), found[2]))
    found = REPORT.fullmatch(where)
    scene.assertIsNotNone(found, f"a row of the page names no number: {where}")
    value = json.loads(path(found[2]).read_text())
    for key in found[1].split("."):
        value = value[key]
    return value


def follow(scene, name):
    """Runs the page's commands in a folder that holds the decks, then compares its values."""
    page = (PAGES / f"{name}.md").read_text()
    for deck in PAGES.glob("*.yaml"):
        shutil.copy(deck, scene.folder)
    commands = commands_of(page)
    scene.assertIn(["run", f"{name}.yaml"], commands)
    for words in commands:
        scene.expect_success(*words)
    rows = rows_of(page)
    scene.assertGreater(len(rows), 5)
    for where, value, within in rows:
        scene.assertAlmostEqual(look_up(scene, f"results/{name}", where), value, delta=within, msg=where)
    # what the page shows of the deck is the deck, but for comments
    lines = {re.sub(r"\s+#.*", "", line) for line in (PAGES / f"{name}.yaml").read_text().splitlines()}
    for block in re.findall(r"^```yaml\n(.*?)^```", page, re.MULTILINE | re.DOTALL):
        for line in block.splitlines():
            scene.assertIn(re.sub(r"\s+#.*", "", line), lines)


@claim("tutorials: the plate gives the values of its page")
def plate(scene):
    follow(scene, "1_plate")


@claim("tutorials: the part from a file and its material give the values of their page")
def part(scene):
    follow(scene, "2_your_part")


@claim("tutorials: the ice sheet and the hull give the values of their page")
def ice(scene):
    follow(scene, "3_ice_and_hull")


main()
