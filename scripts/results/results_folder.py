"""A results folder, as scripts read it. What is missing ends a script with exit code 2 and a sentence."""

import argparse
import csv
import json
import sys
from pathlib import Path


class Missing(Exception):
    """Something that a script needs, in a sentence."""


def refuse(sentence):
    raise Missing(sentence)


def run(main):
    """A script."""
    try:
        return main()
    except Missing as lacking:
        print(f"error: {lacking}", file=sys.stderr)
        sys.exit(2)


def options(text, **results):
    """Parser of a script that `text` describes; `results`: settings of its argument RESULTS, one folder where nothing is given."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS", type=Path, help="folder", **results)
    return parser


class Named(dict):
    """Values by name; `owner` is what has them."""

    def __init__(self, values, owner):
        super().__init__(values)
        self.owner = owner

    def __missing__(self, name):
        refuse(f"{self.owner} has no {name}; give the results of a deck that this script is for.")


def file_in(folder, name, writer="perimpact run"):
    """Path of a file of a results folder."""
    path = Path(folder) / name
    if not path.is_file():
        refuse(f"{folder} has no {name}; give a results folder written by {writer}.")
    return path


def report_of(folder):
    """run.json."""
    path = file_in(folder, "run.json")
    return json.loads(path.read_text(encoding="utf-8"), object_hook=lambda members: Named(members, path))


def records(folder, name):
    """Rows of a table of a results folder as texts by the names of its columns."""
    path = file_in(folder, name)
    with open(path, newline="", encoding="utf-8") as lines:
        return [Named(row, path) for row in csv.DictReader(lines)]
