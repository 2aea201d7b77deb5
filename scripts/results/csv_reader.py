"""Reads tables of numbers of a results folder with numpy."""

import csv

import numpy as np
from results_folder import Named, file_in, refuse


def read_columns(path):
    """Columns of a CSV by the names in its first line, which have their units: columns["time [s]"]."""
    with open(path, newline="", encoding="utf-8") as lines:
        names, *rows = csv.reader(lines)
    return Named(zip(names, np.array(rows, dtype=float).reshape(-1, len(names)).T), path)


def history(folder):
    """Columns of history.csv, which has at least two rows."""
    path = file_in(folder, "history.csv")
    columns = read_columns(path)
    if len(columns["time [s]"]) < 2:
        refuse(f"{path} has fewer than two rows; give a results folder of a run that has begun.")
    return columns
