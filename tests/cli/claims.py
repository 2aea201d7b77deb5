"""What the tests of the command line share. A claim is a function with a sentence; ctest runs it by that sentence:

    python3 results.test.py BINARY ["the sentence"]
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import NamedTuple

SKIPPED = 77
CLAIMS = {}
MPIRUN_AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}  # Open MPI refuses root

# 960 particles, in contact with a meshed cylinder after 7 microseconds; runs in a few hundredths of a second
DECK = """\
title: Small plate
time: {end: 20 us}
bodies:
  plate:
    shape: {box: {size: [100 mm, 60 mm, 20 mm]}}
    spacing: 5 mm
    material: {model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000 kg/m3}
impactors:
  cylinder:
    surface: {cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}
    mass: 1 kg
    position: [0, 50 mm, 0]
    velocity: [0, -32 m/s, 0]
    free_dofs: [y]
contact:
  impactors: {detector: swept}
output:
  folder: results
  frames: 4
  history_interval: 2 us
  probes:
    centre: {body: plate, at: [0, 0, 0]}
  lines:
    along_y: {body: plate, from: [0, -30 mm, 0], to: [0, 30 mm, 0]}
"""

# the plate is a moving window that follows the cylinder, which deforms it
MOVES = (
    ("[100 mm, 60 mm, 20 mm]}}", "[80 mm, 60 mm, 20 mm]}}\n    moving_window: {follow: cylinder, axis: x, start_after: 0 m}"),
    ("[0, 50 mm, 0]", "[0, 50.5 mm, 0]"),
    ("[0, -32 m/s, 0]", "[6000 m/s, -100 m/s, 0]"),
    ("free_dofs: [y]", "free_dofs: []"),
    ("  probes:\n    centre: {body: plate, at: [0, 0, 0]}\n  lines:\n    along_y: {body: plate, from: [0, -30 mm, 0], to: [0, 30 mm, 0]}\n", ""),
)


def claim(sentence):
    def add(function):
        assert sentence not in CLAIMS, f"two claims say: {sentence}"
        CLAIMS[sentence] = function
        return function

    return add


def changed(text, *changes):
    """The text with each (old, new) replaced; each old must stand there once."""
    for old, new in changes:
        assert text.count(old) == 1, f"the deck holds {old!r} {text.count(old)} times"
        text = text.replace(old, new)
    return text


def place_of(text, needle):
    """"line:column" where the needle begins, counted here by hand; it must stand there once."""
    assert text.count(needle) == 1, f"the deck holds {needle!r} {text.count(needle)} times"
    before = text[: text.index(needle)]
    return f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"


class Done(NamedTuple):
    code: int
    out: str
    err: str


class Scene(unittest.TestCase):
    """A folder of its own, the program, and unittest's comparisons."""

    maxDiff = None
    longMessage = True

    def __init__(self, program, folder):
        super().__init__()
        self.program, self.folder = program, folder
        # threads that wait must not keep the processors busy: tests run side by side
        self.environment = {**os.environ, "LC_ALL": "C.UTF-8", "OMP_WAIT_POLICY": "passive"}

    def deck(self, *changes, name="deck.yaml"):
        """Writes the deck with the changes; its name, from the folder."""
        (self.folder / name).write_text(changed(DECK, *changes))
        return name

    def start(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.Popen([self.program, *map(str, arguments)], cwd=self.folder, env=self.environment, text=True, stdin=subprocess.DEVNULL, **options)

    def run_program(self, *arguments, limits={}, **options):
        """`limits`: of the program's resources, by the names of setrlimit."""

        def limit():
            for which, value in limits.items():
                resource.setrlimit(which, (value, value))

        process = self.start(*arguments, preexec_fn=limit, **options)
        out, err = process.communicate(timeout=300)
        return Done(process.returncode, out, err)

    def expect_success(self, *arguments, **options):
        done = self.run_program(*arguments, **options)
        self.assertEqual((done.code, done.err), (0, ""), done)
        return done

    def expect_no_warning(self, *arguments):
        """Success, and no line that is a warning; progress of a long set-up is none."""
        done = self.expect_success(*arguments)
        self.assertEqual([line for line in done.out.splitlines() if line.startswith("warning:")], [])
        return done

    def expect_complaint(self, done, code, begins, *words):
        """One line on stderr: error: <begins> … with each of the words, ending in a full stop or a question mark."""
        self.assertEqual(done.code, code, done)
        lines = done.err.splitlines()
        self.assertEqual(len(lines), 1, done.err)
        self.assertTrue(lines[0].startswith(f"error: {begins}"), f"\n{lines[0]}\ndoes not begin with\nerror: {begins}")
        for word in words:
            self.assertIn(word, lines[0])
        self.assertTrue(lines[0][-1] in ".?" or lines[0].endswith("--resume"), lines[0])  # a command to copy has no full stop

    def report(self, folder):
        """run.json"""
        return json.loads((self.folder / folder / "run.json").read_text())

    def write_kinds(self, folder, loads=(), **kinds):
        """history.json for a history.csv that no run has written: `loads` are interval means, all else is instantaneous but for `kinds`."""
        with open(self.folder / folder / "history.csv") as file:
            headings = file.readline().rstrip("\n").split(",")
        columns = []
        for heading in headings:
            name, unit = heading[:-1].split(" [")
            kind = "interval mean" if name in loads else kinds.get(name.replace(".", "_"), "instantaneous")
            columns.append({"name": name, "unit": unit, "kind": kind, "meaning": "", **({"is_load": True} if name in loads else {})})
        (self.folder / folder / "history.json").write_text(json.dumps({"format": 1, "columns": columns}))

    def history(self, folder):
        """Columns of history.csv by name; every row must be whole."""
        return table(self.folder / folder / "history.csv")

    def files(self, folder):
        root = self.folder / folder
        return sorted(str(path.relative_to(root)) for path in root.rglob("*") if path.is_file())


def table(path):
    text = path.read_text()
    assert text.endswith("\n"), f"{path} ends in the middle of a row"
    names, *rows = (line.split(",") for line in text.splitlines())
    assert all(len(row) == len(names) for row in rows), f"{path} has rows of different lengths"
    return {name: [float(row[i]) for row in rows] for i, name in enumerate(names)}


def variants(case):
    """(deck, name, settings) of each run of the case's variants.sh, in its order; nothing is run."""
    script = "".join(line for line in open(case / "variants.sh", encoding="utf-8") if not line.startswith("source"))  # which defines `variant` and its variables
    stands_for = f'case={case} results=results\nvariant() {{ printf "%s\\0" "${{deck:-$case/deck.yaml}}" "$@"; echo; }}\n'
    listed = subprocess.run(["bash", "-c", stands_for + script], capture_output=True, text=True, check=True).stdout
    return [(deck, name, settings) for deck, name, *settings in (line.removesuffix("\0").split("\0") for line in listed.splitlines())]


def main():
    program = str(Path(sys.argv[1]).resolve())
    for sentence in sys.argv[2:] or CLAIMS:
        with tempfile.TemporaryDirectory(prefix="perimpact-") as folder:
            try:
                CLAIMS[sentence](Scene(program, Path(folder)))
            except unittest.SkipTest as reason:
                print(f"skipped: {reason}")
                sys.exit(SKIPPED)
