"""The page docs/validation.md, from the numbers of all topics."""

import re
from importlib import import_module

import predictions
from rows import read_numbers
from runner import ROOT
from topics.paper import conclusions

TOPICS = ("plate", "fem", "panels", "detection", "convergence", "fracture", "floating_strip", "ice_sphere", "ice_specimens", "ship", "propeller", "submarine", "energy", "stopping", "coupling", "structures")
KEPT = ROOT / "validation/measured"
HEAD = """# Validation: claims and results

<!-- written by validation/run.sh --update from validation/measured and the tables it names; do not edit -->

    validation/run.sh                        measures the topics that take minutes, and writes this page to build/validation
    validation/run.sh plate ice_sphere       these topics only
    validation/run.sh --long                 all of them; those marked *long* take more
    validation/run.sh --update               also writes numbers, page and figures into the tree
    validation/run.sh --long --update        everything, with the tables of other pages that topics read: hours

Each row has a claim, the source of the expected value, our result, the expected value with its tolerance, the reason of the tolerance, and the verdict. Every row
can fail: a test moves each number out of its tolerance and verifies that the row fails. "The paper" is that of Zhang et al., which introduced the FCCDA; where
it contradicts itself or is ambiguous see [variants](theory/fccda_variants.md). Other tests of the program: [testing](developer/testing.md).
"""

PREDICTIONS = """What rows test can be computed otherwise. These values cannot: they were measured by others, or follow from formulas that were fitted to measurements. Each target was stated before the run. Strengths, stiffness and friction
were not changed after it. Horizon, contact and edges of the ships' decks were, for reasons other than a resistance: [what was changed, and what was then known](../cases/uikku_ice/README.md#what-was-changed-after-the-first-run).
Cases: [icebreaker](../cases/ship_ice/README.md#against-formulas), [specimens](../cases/ice_specimens/README.md), [MT Uikku](../cases/uikku_ice/README.md).
"""


def module(topic):
    return import_module(f"topics.{topic}")


def all_numbers(folders=(KEPT,)):
    """"topic.quantity" → value: from the tables of other pages, and as measured (the last folder that has a number takes precedence)."""
    numbers = {}
    for topic in TOPICS:
        found = module(topic).gathered() if hasattr(module(topic), "gathered") else {}
        for folder in folders:
            found |= read_numbers(folder / f"{topic}.csv")
        numbers |= {f"{topic}.{name}": value for name, value in found.items()}
    return numbers


def of_topic(topic, numbers):
    return {name.split(".", 1)[1]: value for name, value in numbers.items() if name.startswith(f"{topic}.")}


def verdicts(numbers):
    """(conclusion, verdict): a row behind a conclusion may have failed."""
    failed = {f"{topic}.{row.number}" for topic in TOPICS for row in module(topic).rows() if not row.passes(of_topic(topic, numbers))}
    return [(one, "**FAIL**" if failed & set(one.stands_on) else one.verdict) for one in conclusions(numbers)]


def summary(numbers):
    lines = ["| topic | rows | passed | time |", "|---|---|---|---|"]
    for topic in TOPICS:
        own, rows = of_topic(topic, numbers), module(topic).rows()
        passed = sum(row.passes(own) for row in rows)
        untimed = "minutes" if hasattr(module(topic), "measure") else "from tables of another page"
        takes = untimed if "takes" not in own else f"{own['takes'] / 60:.1f} min of one processor" if own["takes"] > 60 else f"{own['takes']:.0f} s of one processor"
        title = module(topic).TITLE
        lines.append(f"| [{title}](#{anchor(title)}) | {len(rows)} | {passed} | {takes}{', *long*' if module(topic).LONG else ''} |")
    return lines


def anchor(title):
    return "".join(c for c in title.lower().replace(" ", "-") if c.isalnum() or c == "-")


def section(topic, numbers):
    own, of = of_topic(topic, numbers), module(topic)
    options = "--long --update " if hasattr(of, "TABLES") and not hasattr(of, "measure") else "--long " if of.LONG else ""
    command = f"validation/run.sh {options}{topic}"
    text = re.sub(r"(?<=[\s|(])-(?=\d)", "−", of.text(own))
    lines = ["", f"## {of.TITLE}", "", f"    {command}", "", *text.splitlines(), ""]
    lines += ["| claim | source | result | expected | reason of the tolerance | |", "|---|---|---|---|---|---|"]
    return lines + [row.line(own) for row in of.rows()]


def page(numbers):
    lines = [HEAD, *summary(numbers), "", "## Predictions and their targets", "", PREDICTIONS, *predictions.table(numbers), "", "## The paper's conclusions", "", "| the paper | verdict | our finding |", "|---|---|---|"]
    lines += [f"| {one.claim} | {verdict} | {one.found} |" for one, verdict in verdicts(numbers)]
    for topic in TOPICS:
        lines += section(topic, numbers)
    return "\n".join(lines) + "\n"


def failures(numbers):
    """Sentences, one for each row that fails."""
    found = []
    for topic in TOPICS:
        own = of_topic(topic, numbers)
        found += [f"{topic}: {row.claim}: {own[row.number]:.6g}, wanted {row.bound}" for row in module(topic).rows() if not row.passes(own)]
    return found
