"""The page docs/validation.md, from the numbers of all topics."""

import re
from importlib import import_module

from rows import read_numbers
from runner import ROOT
from topics.paper import conclusions

TOPICS = ("plate", "fem", "panels", "detection", "convergence", "fracture", "floating_strip", "ice_sphere", "ship", "propeller", "energy", "stopping", "coupling")
KEPT = ROOT / "validation/measured"
HEAD = """# Validation: what is claimed, what we found

<!-- written by validation/run.sh --update from validation/measured and the tables it names; do not edit -->

    validation/run.sh                        measures the topics that take minutes, and writes this page anew under build/validation
    validation/run.sh plate ice_sphere       these topics only
    validation/run.sh --long                 all of them; those marked *long* take more
    validation/run.sh --update               the same, and puts numbers, page and figures into the tree
    validation/run.sh --long --update        everything anew, with the tables of other pages that topics read: hours

Each row has a claim, the source of what is wanted, our number, how far it may be off and why, and whether it is. A row
that cannot fail is no row: a test moves every number out of its tolerance and sees the row fail. How the program is tested
otherwise: [testing](developer/testing.md). Where the paper contradicts itself or leaves things open: [readings](theory/fccda_variants.md).
"""


def module(topic):
    return import_module(f"topics.{topic}")


def all_numbers(folders=(KEPT,)):
    """"topic.quantity" → value: what the topics gather from the tables of other pages, and what was measured (the last folder that has it counts)."""
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
    """(conclusion, verdict): what a conclusion stands on may have failed."""
    failed = {f"{topic}.{row.number}" for topic in TOPICS for row in module(topic).rows() if not row.passes(of_topic(topic, numbers))}
    return [(one, "**FAIL**" if failed & set(one.stands_on) else one.verdict) for one in conclusions(numbers)]


def summary(numbers):
    lines = ["| | rows | passed | takes |", "|---|---|---|---|"]
    for topic in TOPICS:
        own, rows = of_topic(topic, numbers), module(topic).rows()
        passed = sum(row.passes(own) for row in rows)
        untimed = "minutes" if hasattr(module(topic), "measure") else "from the tables of another page"
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
    lines += ["| claim | source | ours | wanted | reason of the tolerance | |", "|---|---|---|---|---|---|"]
    return lines + [row.line(own) for row in of.rows()]


def page(numbers):
    lines = [HEAD, *summary(numbers), "", "## The paper's conclusions", "", "| the paper says | verdict | what we found |", "|---|---|---|"]
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
