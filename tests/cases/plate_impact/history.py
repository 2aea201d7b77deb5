"""What the claims about the plate read from a run: history.csv, with Python's standard library."""

import csv
from pathlib import Path


class History:
    """Columns by quantity ("cylinder.velocity_y"), each with its unit."""

    def __init__(self, folder):
        with open(Path(folder) / "history.csv", newline="") as file:
            names, *rows = csv.reader(file)
        self.unit, self.column = {}, {}
        for k, name in enumerate(names):
            quantity, unit = name.removesuffix("]").split(" [")
            self.unit[quantity], self.column[quantity] = unit, [float(row[k]) for row in rows]
        self.time = self.column["time"]

    def interval(self):
        """Time between rows [s]; all are equally far apart."""
        interval = self.time[1] - self.time[0]
        assert all(abs(b - a - interval) < 1e-6 * interval for a, b in zip(self.time, self.time[1:])), "rows are not equally far apart"
        return interval

    def at(self, quantity, time):
        """The value in the row at that time [s]."""
        nearest = min(range(len(self.time)), key=lambda k: abs(self.time[k] - time))
        assert abs(self.time[nearest] - time) < 1e-9 * time, f"no row at {time} s"
        return self.column[quantity][nearest]

    def moved(self, quantity, time):
        """How far a position is then from where it was at first."""
        return self.at(quantity, time) - self.column[quantity][0]

    def largest_mean(self, quantity, interval):
        """A row's force is the mean since the row before, so rows that far apart are wanted."""
        assert abs(self.interval() - interval) < 1e-6 * interval, f"rows are {self.interval()} s apart, not {interval} s"
        return max(self.column[quantity])

    def end_of_contact(self):
        """End of the last interval with an impulse on the cylinder [s]."""
        return max(time for time, force in zip(self.time, self.column["cylinder.force_y"]) if force != 0)
