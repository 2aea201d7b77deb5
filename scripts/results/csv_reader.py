"""Reads tables of numbers of a results folder with numpy."""

import csv
from pathlib import Path

import numpy as np


def read_columns(path):
    """Columns of a CSV by the names in its first line, which have their units: columns["time [s]"]."""
    with open(path, newline="", encoding="utf-8") as lines:
        names, *rows = csv.reader(lines)
    return dict(zip(names, np.array(rows, dtype=float).reshape(-1, len(names)).T))


def history(folder):
    """Columns of history.csv."""
    return read_columns(Path(folder) / "history.csv")
