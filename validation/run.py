"""Measures the named topics and writes the page: see run.sh."""

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True
from page import KEPT, TOPICS, all_numbers, failures, module, page  # noqa: E402
from rows import read_numbers, write_numbers  # noqa: E402
from runner import ROOT, Runner, processor_seconds  # noqa: E402

FIGURES, PAGE = ROOT / "validation/figures", ROOT / "docs/validation.md"


def fail(sentence):
    print(f"error: {sentence}", file=sys.stderr)
    sys.exit(2)


def measured(topic, runner):
    """Numbers of the topic; their processor time is recorded if this call made all runs."""
    fresh, begin = not (runner.results / topic).exists(), processor_seconds()
    numbers = module(topic).measure(runner)
    kept = runner.results / f"{topic}.csv"
    if fresh:
        numbers["takes"] = processor_seconds() - begin
    else:
        numbers |= {name: value for name, value in read_numbers(kept).items() if name == "takes"}
    write_numbers(kept, numbers)


def make_tables(topic, runner):
    """Tables of other pages that the topic reads: their programs write them into the tree."""
    for command in getattr(module(topic), "TABLES", ()):
        command = command.format(perimpact=runner.program, results=runner.results)
        print(f"  {command}", flush=True)
        if subprocess.run(command, shell=True, cwd=ROOT).returncode:
            fail(f"{topic}: this failed: {command}")


def main():
    arguments = argparse.ArgumentParser(prog="validation/run.sh", description="Measures topics of docs/validation.md and writes the page.")
    arguments.add_argument("topics", nargs="*", metavar="TOPIC", help=f"of {', '.join(TOPICS)}; all but the long ones if none is named")
    arguments.add_argument("--long", action="store_true", help="long topics too")
    arguments.add_argument("--results", type=Path, default=ROOT / "build/validation", help="folder of the results (build/validation); finished runs there are reused")
    arguments.add_argument("--perimpact", type=Path, default=ROOT / "build/release/perimpact", help="the program")
    arguments.add_argument("--update", action="store_true", help="write numbers, page and figures into the tree")
    given = arguments.parse_args()
    for topic in given.topics:
        if topic not in TOPICS:
            fail(f"there is no topic {topic}; the topics are: {', '.join(TOPICS)}")
    able = [topic for topic in TOPICS if hasattr(module(topic), "measure")]
    chosen = given.topics or [topic for topic in TOPICS if given.long or not module(topic).LONG]
    if not given.perimpact.exists():
        fail(f"{given.perimpact} is not there; ./run.sh or ./test.sh builds it, or give another with --perimpact")

    runner = Runner(given.perimpact, given.results)
    runner.results.mkdir(parents=True, exist_ok=True)
    for topic in chosen:
        if module(topic).LONG and not given.long:
            fail(f"{topic} takes long; give --long with it")
        print(topic, flush=True)
        if given.long and given.update:
            make_tables(topic, runner)
        if topic in able:
            measured(topic, runner)
        elif not (given.long and given.update):
            print("  its numbers are in the table of another page, which --long --update repeats")

    if given.update:
        for kept in runner.results.glob("*.csv"):
            shutil.copy(kept, KEPT)
        for figure in runner.results.glob("*/figures/*.png"):
            shutil.copy(figure, FIGURES)
        for table in (runner.results / "fem/out").glob("*.csv"):
            shutil.copy(table, ROOT / "validation/plate")
    numbers = all_numbers((KEPT,) if given.update else (KEPT, runner.results))
    (PAGE if given.update else runner.results / "validation.md").write_text(page(numbers), encoding="utf-8")
    print(f"wrote {PAGE if given.update else runner.results / 'validation.md'}")
    for sentence in failures(numbers):
        print(f"FAIL {sentence}")
    sys.exit(1 if failures(numbers) else 0)


main()
