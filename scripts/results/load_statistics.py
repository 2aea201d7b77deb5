"""Statistics of a load over part of a run, by `perimpact statistics`."""

import csv
import subprocess
from pathlib import Path

PERIMPACT = Path(__file__).resolve().parents[2] / "build/release/perimpact"


def load_statistics(folder, column, begin, end=None):
    """The row of statistics.csv of a column of history.csv from `begin` to `end` [s], or to the end of the run: texts by the names of its columns."""
    until = [] if end is None else ["--to", str(end)]
    subprocess.run([PERIMPACT, "statistics", folder, "--from", str(begin), *until, "--columns", column], check=True, stdout=subprocess.DEVNULL)
    with open(Path(folder) / "statistics.csv", newline="", encoding="utf-8") as lines:
        (row,) = csv.DictReader(lines)
    return row
