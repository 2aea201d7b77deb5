"""Reads a results folder with numpy alone."""

import re
import sys
from functools import cached_property
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/results"))
from csv_reader import history, read_columns  # noqa: E402
from results_folder import file_in, refuse  # noqa: E402
from vtp_reader import picture_at, read_vtp  # noqa: E402


class Results:
    """A results folder. Panel sizes are part of the folder's name: panel_0.5mm; analytic is the original method without panels."""

    def __init__(self, folder):
        self.folder = Path(folder)
        size = re.fullmatch(r"panel_([0-9.]+)mm", self.folder.name)
        self.panel = float(size[1]) if size else None  # [mm]
        self.is_original = self.folder.name == "analytic"
        self.label = f"$\\Delta_m$ = {size[1]} mm" if size else "original method" if self.is_original else self.folder.name

    @cached_property
    def history(self):
        return history(self.folder)

    def line(self, name, time):
        """The profile written nearest to that time [s]."""
        files = {float(file.stem.rsplit("_t", 1)[1]): file for file in (self.folder / "lines").glob(f"{name}_t*.csv")}
        if not files:
            refuse(f"{self.folder} has no lines/{name}_t*.csv; run the deck with the line {name}.")
        return read_columns(files[min(files, key=lambda t: abs(t - time))])

    def frame(self, name, time):
        """The frame nearest to that time [s]."""
        return picture_at(self.folder, name, time)[1]

    def checked(self, name):
        """A frame of the set-up, written by `perimpact check`."""
        return read_vtp(file_in(self.folder, f"check/{name}.vtp"))


def middle_layer(picture):
    """Positions, displacements [m] of the lattice's middle layer in z as arrays (y, x, component)."""
    displacement = picture.point["displacement"].astype(float)
    reference = np.round(picture.points - displacement, 7)  # to a ten-thousandth of a spacing, beyond the rounding of float
    heights = np.unique(reference[:, 2])
    layer = np.flatnonzero(reference[:, 2] == heights[len(heights) // 2])
    layer = layer[np.lexsort((reference[layer, 0], reference[layer, 1]))]
    shape = (len(np.unique(reference[layer, 1])), len(np.unique(reference[layer, 0])), 3)
    return picture.points[layer].reshape(shape), displacement[layer].reshape(shape)
