"""Runs that are killed and go on end with the same bits."""

import re
import subprocess
import sys

from rows import AtLeast, Exactly, Row
from runner import ROOT

TITLE = "Killed two hundred times"
LONG = True


def measure(runner):
    print("  stopping: kills", flush=True)
    done = subprocess.run([sys.executable, ROOT / "tests/long/kills.test.py", runner.program], capture_output=True, text=True)
    said = re.search(r"(\d+) kills, (\d+) of them while a checkpoint was written; \d+ runs, gone on with (\d+) times", done.stdout)
    return {"different": float(done.returncode != 0), "kills": float(said[1]) if said else 0.0, "in writing": float(said[2]) if said else 0.0, "resumed": float(said[3]) if said else 0.0}


def text(n):
    return """A small run whose bonds break, with a checkpoint after every step, is killed at random moments and resumed on one to four threads
([resume](guide/restart.md)); tables, pictures and state are compared byte by byte."""


def rows():
    return [
        Row("kills", "[kills.test.py](../tests/long/kills.test.py)", "kills", "count", AtLeast(200), "that many were asked for"),
        Row("of them while a checkpoint was being written", "the same", "in writing", "count", AtLeast(11), "one in twenty: the moment that matters is met"),
        Row("runs gone on with", "the same", "resumed", "count", AtLeast(51), "one in four, else kills came before anything was kept"),
        Row("runs that ended with another bit", "the run in one fragment", "different", "count", Exactly(0), "bits"),
    ]
