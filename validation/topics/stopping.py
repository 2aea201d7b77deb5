"""Runs that are killed and restarted end bitwise identical."""

import re
import subprocess
import sys

from rows import AtLeast, Exactly, Row
from runner import ROOT

TITLE = "Restart after two hundred kills"
LONG = True


def measure(runner):
    print("  stopping: kills", flush=True)
    done = subprocess.run([sys.executable, ROOT / "tests/long/kills.test.py", runner.program], capture_output=True, text=True)
    said = re.search(r"(\d+) kills, (\d+) of them while a checkpoint was written; \d+ runs, gone on with (\d+) times", done.stdout)
    return {"different": float(done.returncode != 0), "kills": float(said[1]) if said else 0.0, "in writing": float(said[2]) if said else 0.0, "resumed": float(said[3]) if said else 0.0}


def text(n):
    return """A small run whose bonds break, with a checkpoint after every step, is killed at random times and restarted on one to four threads
([restart](guide/restart.md)). Tables, frames and state are compared byte by byte."""


def rows():
    return [
        Row("kills", "[kills.test.py](../tests/long/kills.test.py)", "kills", "count", AtLeast(200), "as requested"),
        Row("of them while a checkpoint was being written", "the same", "in writing", "count", AtLeast(11), "one in twenty: the critical moment is covered"),
        Row("restarts from a checkpoint", "the same", "resumed", "count", AtLeast(51), "one in four; otherwise kills came before the first checkpoint"),
        Row("runs with a different result", "uninterrupted run", "different", "count", Exactly(0), "bitwise comparison"),
    ]
