"""A restart from a checkpoint at any step is bitwise exact."""

import random
import re
import resource
import shutil
import signal
import time

from claims import claim, main

# 600 steps of 960 particles, whose bonds break; some tenths of a second
STEPS = ("time: {end: 20 us}", "time: {end: 30 us, step: 0.05 us}")
BREAKS = ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002")
MORE = ("  history_interval: 2 us", "  history_interval: 0.7 us\n  checkpoint_interval: 10 ms")
LINE = ("to: [0, 30 mm, 0]}", "to: [0, 30 mm, 0], times: [3 us, 17 us, 30 us]}")
TIME_DEPENDENT = ("run.json", "report.html", "checkpoint.h5")  # contain wall-clock times and restarts


def deck(t, *changes):
    return t.deck(STEPS, BREAKS, MORE, LINE, *changes)


def run(t, *arguments, threads=2):
    t.environment["OMP_NUM_THREADS"] = str(threads)
    return t.run_program("run", *arguments)


def expect_same(t, folder, whole):
    """All files without wall-clock times are identical byte for byte, and run.json describes the same run."""
    t.assertEqual(t.files(folder), t.files(whole))
    for name in t.files(whole):
        if name not in TIME_DEPENDENT:
            t.assertEqual((t.folder / folder / name).read_bytes(), (t.folder / whole / name).read_bytes(), name)
    report, wanted = t.report(folder), t.report(whole)
    for each in report, wanted:
        for key in ("wall_time [s]", "timers [s]", "set_up [s]", "threads", "resumed_at_steps"):
            each.pop(key, None)
        for impactor in each["impactors"].values():  # cached distances of detectors are searched again
            for detection in impactor["detection"].values():
                for key in ("points_in_bounds", "points_tested", "panels_tested"):
                    del detection[key]
    t.assertEqual(report, wanted)


def stop(t, which, seconds, *arguments, threads):
    """Starts the run and sends it the signal that time after its first checkpoint. Exit code and output."""
    t.environment["OMP_NUM_THREADS"] = str(threads)
    checkpoint = t.folder / "r/checkpoint.h5"
    before = checkpoint.stat().st_mtime_ns if checkpoint.exists() else 0
    process = t.start("run", *arguments)
    while process.poll() is None and not (checkpoint.exists() and checkpoint.stat().st_mtime_ns != before):
        time.sleep(0.002)
    time.sleep(seconds)
    process.send_signal(which)
    out, err = process.communicate(timeout=60)
    t.assertEqual(err, "")
    return process.returncode, out


def stopped_twice_and_resumed(t, name, which, chance):
    """How often the run went on; on a busy machine it may have ended before anybody could stop it."""
    shutil.rmtree(t.folder / "r", ignore_errors=True)
    resume = []
    for threads in chance.sample((1, 2, 3, 4), 2):
        code, out = stop(t, which, chance.uniform(0, 0.1), name, "--out", "r", *resume, threads=threads)
        is_finished = "\nResults: " in out  # signals are default again when the lock of the folder is released
        t.assertIn(code, (0, -which) if is_finished or which == signal.SIGKILL else (128 + which,), out)
        if code > 0:
            t.assertIn("resume with perimpact run deck.yaml --out r --resume", out)
        resume = ["--resume"]
    done = run(t, name, "--out", "r", *resume, threads=1)
    t.assertEqual(done.code, 0, done)
    return len(t.report("r").get("resumed_at_steps", []))


@claim("resume: interrupted by Ctrl-C, SIGTERM or SIGKILL, then restarted with other numbers of threads, a run is bitwise identical to an uninterrupted one")
def _(t):
    name, chance = deck(t), random.Random(1)
    t.assertEqual(run(t, name, "--out", "whole").code, 0)
    for which in signal.SIGINT, signal.SIGTERM, signal.SIGKILL:
        for _ in range(10):
            resumed = stopped_twice_and_resumed(t, name, which, chance)
            expect_same(t, "r", "whole")
            if resumed > 0:
                break
        t.assertGreater(resumed, 0)


@claim("resume: an interrupted run prints the command to resume, and run.json records the steps of restarts")
def _(t):
    changes = ["--set", "impactors.cylinder.velocity=[0, -30, 0]", "--set", "output.checkpoint_interval=0"]
    name = deck(t)
    ways = ["--threads", "2", "--device", "cpu-scalar", "--log", "its log", "--no-report"]
    t.assertEqual(run(t, name, "--out", "whole", *changes, *ways[2:]).code, 0)
    process = t.start("run", name, "--out", "it is here", *changes, *ways)
    history = t.folder / "it is here/history.csv"
    while not history.exists() or history.read_bytes().count(b"\n") < 3:
        t.assertIsNone(process.poll())
        time.sleep(0.005)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    t.assertEqual((process.returncode, err), (130, ""))
    step = int(re.search(r"\(step (\d+) of 600\)", out)[1])
    command = re.search(r"; resume with perimpact (run .*)", out)[1]
    t.assertEqual(command, f"run deck.yaml --out 'it is here' --set 'impactors.cylinder.velocity=[0, -30, 0]' --set output.checkpoint_interval=0 --threads 2 --device cpu-scalar --log 'its log' --no-report --resume")
    done = run(t, name, "--out", "it is here", *changes, *ways, "--resume")
    t.assertEqual((done.code, done.err), (0, ""))
    t.assertIn(f"Resumed at step {step} (t = ", done.out)
    t.assertEqual(t.report("it is here")["resumed_at_steps"], [step])
    t.assertNotIn("resumed_at_steps", t.report("whole"))
    expect_same(t, "it is here", "whole")


@claim("resume: a finished run is unchanged, a missing run.json is written, and so are report and ParaView script that a kill prevented")
def _(t):
    name = deck(t)
    t.assertEqual(run(t, name, "--out", "r").code, 0)
    before = {file: (t.folder / "r" / file).read_bytes() for file in t.files("r")}
    done = run(t, name, "--out", "r", "--resume")
    t.assertEqual((done.code, done.out), (0, "The run in r is finished (step 600 of 600); there is nothing to resume.\n"))
    t.assertEqual({file: (t.folder / "r" / file).read_bytes() for file in t.files("r")}, before)
    shutil.copytree(t.folder / "r", t.folder / "whole")
    (t.folder / "r/run.json").unlink()
    t.assertEqual(run(t, name, "--out", "r", "--resume").code, 0)
    expect_same(t, "r", "whole")
    for file in "report.html", "open_in_paraview.py":
        (t.folder / "r" / file).unlink()
    t.assertEqual(run(t, name, "--out", "r", "--resume", "--no-report").code, 0)
    t.assertNotIn("report.html", t.files("r"))
    t.assertEqual(run(t, name, "--out", "r", "--resume").code, 0)
    expect_same(t, "r", "whole")


@claim("resume: an impossible restart is refused with 2 and a sentence, without loss of data")
def _(t):
    name = deck(t)
    t.expect_complaint(run(t, name, "--out", "r", "--resume"), 2, "there is no checkpoint r/checkpoint.h5", "run without --resume")
    t.assertFalse((t.folder / "r").exists())
    (t.folder / "file").write_text("kept")
    t.expect_complaint(run(t, name, "--out", "file", "--resume"), 2, "file is a file, but the folder of a run is needed to resume it")
    t.assertEqual((t.folder / "file").read_text(), "kept")
    t.assertEqual(run(t, name, "--out", "r", "--set", "output.folder=other").code, 0)
    (t.folder / "r/run.json").unlink()
    before = {file: (t.folder / "r" / file).read_bytes() for file in t.files("r")}
    place = "deck.yaml:6:14: bodies.plate.spacing is 0.01 here, but 0.005 in the run of the checkpoint r/checkpoint.h5"
    t.expect_complaint(run(t, t.deck(STEPS, BREAKS, MORE, LINE, ("spacing: 5 mm", "spacing: 10 mm")), "--out", "r", "--resume"), 2, place, "same deck")
    deck(t)
    t.expect_complaint(run(t, name, "--out", "r", "--resume", "--set", "time.end=20 us"), 2, "deck.yaml:", "the run ends at")
    t.expect_complaint(run(t, name, "--out", "r", "--resume", "--set", "time.step=0.06 us"), 2, "", "the time step is 6e-08 s here", "--set time.step=5e-08.")
    t.assertEqual({file: (t.folder / "r" / file).read_bytes() for file in t.files("r")}, before)
    (t.folder / "r/checkpoint.h5").write_bytes(before["checkpoint.h5"][:-1])
    t.expect_complaint(run(t, name, "--out", "r", "--resume"), 2, "r/checkpoint.h5 is damaged", "start a new run without --resume")
    del before["checkpoint.h5"]
    t.assertEqual({file: (t.folder / "r" / file).read_bytes() for file in before}, before)


@claim("resume: an error names the last checkpoint, and after a full disk the run resumes from it")
def _(t):
    # history.csv outgrows the checkpoint, and the limit
    name = deck(t, ("[100 mm, 60 mm, 20 mm]", "[30 mm, 60 mm, 20 mm]"), ("history_interval: 0.7 us", "history_interval: 0.05 us"))
    t.assertEqual(run(t, name, "--out", "whole").code, 0)
    room = (t.folder / "whole/checkpoint.h5").stat().st_size + 20_000
    t.assertGreater((t.folder / "whole/history.csv").stat().st_size, room + 10_000)
    quick = ["--set", "output.checkpoint_interval=1 us"]
    done = t.run_program("run", name, "--out", "r", *quick, limits={resource.RLIMIT_FSIZE: room})
    t.expect_complaint(done, 3, "r/history.csv cannot be written", "ulimit -f")
    t.assertRegex(done.err, r"The last checkpoint is at step \d+; resume from it with perimpact run deck\.yaml --out r --set 'output.checkpoint_interval=1 us' --resume")
    t.expect_success("run", name, "--out", "r", "--resume")
    expect_same(t, "r", "whole")
    blows_up = t.deck(("end: 20 us", "end: 1 ms, step: 1.5 us"), ("-32 m/s", "-3200 m/s"), MORE, ("frames: 4", "frames: 0"))
    done = t.run_program("run", blows_up, "--out", "r2", *quick)
    t.expect_complaint(done, 3, "At step ", "The last checkpoint is at step ")
    t.assertNotIn("resume from it", done.err)


@claim("resume: results whose history has other columns, as of another version of the program, are refused unchanged")
def _(t):
    name = deck(t, ("frames: 4", "frames: 0"))
    process = t.start("run", name, "--out", "r", "--set", "output.checkpoint_interval=1 us", "--set", "time.end=100 s")
    deadline = time.monotonic() + 60
    while not (t.folder / "r/checkpoint.h5").exists():
        t.assertLess(time.monotonic(), deadline)
        time.sleep(0.01)
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=60)
    history = t.folder / "r/history.csv"
    header, rows = history.read_text().split("\n", 1)
    names = header.split(",")
    pad = "x" * (len(names[-1]) + 1)  # the file keeps its size
    for other, count in ([*names[:-2], f"x{names[-2]}{pad[1:]}"], len(names) - 1), ([*names[:-1], "y" * len(names[-1])], len(names)):
        history.write_text(",".join(other) + "\n" + rows)
        before = {file: (t.folder / "r" / file).read_bytes() for file in t.files("r")}
        done = run(t, name, "--out", "r", "--resume", "--set", "time.end=100 s")
        t.expect_complaint(done, 2, f"r/history.csv is of another version of the program: it has {count} columns and this one writes {len(names)}, different from column "
                           f"{count} on; resume the run with that version, or replace it by a new one.")
        t.assertEqual({file: (t.folder / "r" / file).read_bytes() for file in t.files("r")}, before)
    history.write_text(header + "\n" + rows)


main()
