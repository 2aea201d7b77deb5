"""What the tests of results folders share."""

import signal
import subprocess
import time

# 600 steps of 384 particles whose bonds break, some tenths of a second; the step is given, so that the run can be prolonged
SHORT = (
    ("time: {end: 20 us}", "time: {end: 30 us, step: 0.05 us}"),
    ("[100 mm, 60 mm, 20 mm]", "[40 mm, 60 mm, 20 mm]"),
    ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002"),
    ("  history_interval: 2 us", "  history_interval: 0.7 us\n  checkpoint_interval: 40 ms"),
)
LONG = (("end: 20 us", "end: 100 s"), ("frames: 4", "frames: 0"))  # would take hours
OF_TIMES = ("run.json", "report.html", "checkpoint.h5", "files.txt")  # contain wall-clock times, restarts and checkpoints


def contents(t, folder, without=OF_TIMES):
    return {name: (t.folder / folder / name).read_bytes() for name in t.files(folder) if name not in without}


def started(t, *arguments, rows=3, **options):
    """A run that has begun its history; the caller ends it."""
    process = t.start("run", *arguments, **options)
    history = t.folder / arguments[arguments.index("--out") + 1] / "history.csv"
    before = history.stat().st_mtime_ns if history.exists() else 0
    deadline = time.monotonic() + 60
    while not (history.exists() and history.stat().st_mtime_ns != before and history.read_bytes().count(b"\n") > rows):
        t.assertIsNone(process.poll(), "it ended by itself")
        t.assertLess(time.monotonic(), deadline, "no rows appear")
        time.sleep(0.005)
    return process


def ended(process, by=signal.SIGTERM):
    """Ends the run by a signal. Exit code, output and errors."""
    process.send_signal(by)
    out, err = process.communicate(timeout=60)
    return process.returncode, out, err


def gone_process():
    """The number of a process that has ended."""
    process = subprocess.Popen(["true"])
    process.wait()
    return process.pid
