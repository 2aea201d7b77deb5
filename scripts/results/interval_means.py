"""Means over time of columns of history.csv that are means over intervals: row k is the mean from the time of row k - 1 to that of row k. The first row has no interval."""

import numpy as np


def impulses(time, values):
    """Their integral from the first row to each row."""
    return np.concatenate([[0], np.cumsum(values[1:] * np.diff(time))])


def mean(time, values):
    """From the first row to the last."""
    return impulses(time, values)[-1] / np.ptp(time)


def window_means(time, values, width, is_zero_before=False):
    """Means over windows of that width [s] that end at rows, and the middle [s] of each window. Windows begin at the first row or later; where the values are zero
    before it, as the force of an impact, earlier too."""
    sums = impulses(time, values)
    ends = time[1:] if is_zero_before else time[time >= time[0] + width * (1 - 1e-9)]
    return ends - width / 2, (np.interp(ends, time, sums) - np.interp(ends - width, time, sums)) / width
