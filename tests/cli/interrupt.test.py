"""Ctrl-C and SIGTERM: the step is finished, what is pending is written, and the exit code is what shells expect."""

import shutil
import signal
import time
import xml.etree.ElementTree as xml

from claims import claim, main

LONG = ("end: 20 us", "end: 100 s")  # would take hours


def interrupted(t, which):
    """Starts a long run, sends it the signal while it is running; returns exit code and output."""
    shutil.rmtree(t.folder / "r", ignore_errors=True)
    process = t.start("run", t.deck(LONG), "--out", "r", "--set", "output.frames=100000")
    history = t.folder / "r/history.csv"
    deadline = time.monotonic() + 60
    while not history.exists() or history.read_bytes().count(b"\n") < 20:
        t.assertIsNone(process.poll(), "it ended by itself")
        t.assertLess(time.monotonic(), deadline, "no rows appear")
        time.sleep(0.02)
    asked = time.monotonic()
    process.send_signal(which)
    out, err = process.communicate(timeout=60)
    t.assertLess(time.monotonic() - asked, 20, "a step takes less than a millisecond")
    t.assertEqual(err, "")
    return process.returncode, out


@claim("interrupt: Ctrl-C ends a run after its step with 130, and SIGTERM with 143, without partial files")
def _(t):
    for which, code in (signal.SIGINT, 130), (signal.SIGTERM, 143):
        returned, out = interrupted(t, which)
        t.assertEqual(returned, code)
        report = t.report("r")
        t.assertEqual(report["outcome"], "interrupted")
        t.assertNotIn("failure", report)
        t.assertIn(f"Interrupted at t = {report['time [s]']:.4g} s (step {report['steps']} of ", out)
        t.assertFalse([name for name in t.files("r") if name.endswith(".part")])
        rows = t.history("r")["time [s]"]
        t.assertLessEqual(rows[-1], report["time [s]"])
        for name in ("plate", "cylinder"):
            entries = xml.parse(t.folder / f"r/frames/{name}.pvd").findall("./Collection/DataSet")
            t.assertEqual({entry.get("file") for entry in entries}, {path.name for path in (t.folder / "r/frames").glob(f"{name}_*.vtp")})
            t.assertEqual(float(entries[-1].get("timestep")), report["time [s]"])  # the last frame is that of the final state


@claim("interrupt: the output of an interrupted run equals that of the full run up to then")
def _(t):
    interrupted(t, signal.SIGINT)
    report, rows = t.report("r"), t.history("r")
    dt = report["stability"]["step [s]"]
    # the same steps, ended at the one where it was interrupted
    t.expect_success("run", "deck.yaml", "--out", "whole", "--set", f"time.end={report['time [s]']!r}", "--set", f"time.step={dt!r}", "--set", "output.frames=0")
    t.assertEqual(t.report("whole")["state_hash"], report["state_hash"])
    whole = t.history("whole")
    for column in rows:
        t.assertEqual(rows[column], whole[column][: len(rows[column])])


main()
