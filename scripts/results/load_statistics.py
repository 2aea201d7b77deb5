"""Statistics of a load over part of a run, by `perimpact statistics`."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from results_folder import file_in, records, refuse

BUILT = Path(__file__).resolve().parents[2] / "build/release/perimpact"


def program():
    """perimpact: that of the variable PERIMPACT, else of PATH, else of this tree's build."""
    found = os.environ.get("PERIMPACT") or shutil.which("perimpact") or shutil.which(BUILT)
    return found or refuse("the program perimpact was not found; set the variable PERIMPACT to its path, or build it with ./run.sh.")


def load_statistics(folder, column, begin, end=None):
    """The row of statistics.csv of a column of history.csv from `begin` to `end` [s], or to the end of the run: texts by the names of its columns. The results folder
    remains as it is: the program works on a copy of the history."""
    until = [] if end is None else ["--to", str(end)]
    with tempfile.TemporaryDirectory(prefix="perimpact-") as copy:
        for name in ("history.csv", "history.json"):
            shutil.copy(file_in(folder, name), copy)
        done = subprocess.run([program(), "statistics", copy, "--from", str(begin), *until, "--columns", column], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            refuse(done.stderr.strip().removeprefix("error: ").replace(copy, str(folder)))
        (row,) = records(copy, "statistics.csv")
    return row
