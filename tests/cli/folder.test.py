"""A results folder belongs to one run: a second one is refused, and what a run or a user wrote is not lost."""

import os
import re
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

from claims import claim, main
from folders import LONG, SHORT, contents, ended, gone_process, started


def lock_of(t, folder, **changes):
    """A lock that says it is of this machine and process, but for the changes."""
    values = {
        "host": os.uname().nodename,
        "pid": os.getpid(),
        "since": "2026-01-02 03:04:05 UTC",
        "process_start": Path(f"/proc/{os.getpid()}/stat").read_text().rsplit(")", 1)[1].split()[19],
        "pid_namespace": os.readlink("/proc/self/ns/pid"),
        "boot": Path("/proc/sys/kernel/random/boot_id").read_text().strip(),
        "machine": Path("/etc/machine-id").read_text().strip() if Path("/etc/machine-id").exists() else "",
        **changes,
    }
    (t.folder / folder).mkdir(exist_ok=True)
    (t.folder / folder / "run.lock").write_text("".join(f"{key}: {value}\n" for key, value in values.items()))


@claim("folder: of two runs into one folder the second is refused, with or without --resume and --force, and the first is undisturbed")
def _(t):
    first = started(t, t.deck(*LONG), "--out", "r")
    for more in [], ["--resume"], ["--force"]:
        if more == ["--resume"]:  # needs a checkpoint to get as far as the lock
            first.send_signal(signal.SIGUSR1)
            while not (t.folder / "r/checkpoint.h5").exists():
                t.assertIsNone(first.poll())
        done = t.run_program("run", "deck.yaml", "--out", "r", *more)
        t.expect_complaint(done, 2, f"another run is writing into the folder r: process {first.pid} on host {os.uname().nodename}, since 20", "choose another folder")
    code, out, err = ended(first)
    t.assertEqual((code, err), (143, ""))
    t.assertEqual(t.report("r")["outcome"], "interrupted")
    t.assertNotIn("run.lock", t.files("r"))
    t.assertEqual(t.history("r")["time [s]"][-1] <= t.report("r")["time [s]"], True)


@claim("folder: of many runs started at once into one folder, behind a stale lock, exactly one gets it")
def _(t):
    deck = t.deck(*LONG)
    for stale in False, True:
        shutil.rmtree(t.folder / "r", ignore_errors=True)
        if stale:
            lock_of(t, "r", pid=gone_process())
        runs = [t.start("run", deck, "--out", "r", "--threads", "1") for _ in range(5)]
        losers = []
        while len(losers) < 4:
            losers = [run for run in runs if run.poll() is not None]
        t.assertEqual([run.returncode for run in losers], [2] * 4)
        (winner,) = [run for run in runs if run not in losers]
        for run in losers:
            out, err = run.communicate()
            t.assertIn(f"process {winner.pid} on host", err)
        winner.kill()
        winner.communicate()


@claim("folder: the lock of a run that is gone is replaced and reported: killed, its number taken by another process, or before a restart of the machine")
def _(t):
    deck = t.deck()
    killed = started(t, t.deck(*LONG, name="long.yaml"), "--out", "r")
    killed.kill()
    killed.communicate()
    t.assertIn("run.lock", t.files("r"))
    out = t.expect_success("run", deck, "--out", "r", "--force").out
    t.assertIn(f"The lock of a run that has ended (process {killed.pid} on host {os.uname().nodename}, since 20", out)
    identity = Path("/etc/machine-id")
    knows_itself = identity.exists() and identity.read_text().strip()  # bare containers have none: a restart looks like another machine
    for changes in {"pid": gone_process()}, {"process_start": "1"}, {"boot": "another"}:
        lock_of(t, "r", **changes)
        if "boot" in changes and not knows_itself:
            done = t.run_program("run", deck, "--out", "r", "--force")
            t.assertEqual(done.code, 2)
            t.assertIn("Whether it still runs cannot be determined from here", done.err)
            continue
        t.assertIn("since 2026-01-02 03:04:05 UTC) was removed from the folder r.", t.expect_success("run", deck, "--out", "r", "--force").out, changes)
        t.assertNotIn("run.lock", t.files("r"))


@claim("folder: a lock whose run may still be going on is refused with the command that deletes it")
def _(t):
    deck = t.deck()
    for changes in {"host": "node17", "boot": "another"}, {"host": "node17", "boot": "another", "machine": "other"}, {"pid_namespace": "pid:[1]"}, {"boot": ""}:
        lock_of(t, "r", **changes)
        host = changes.get("host", os.uname().nodename)
        for more in [], ["--force"]:
            done = t.run_program("run", deck, "--out", "r", *more)
            t.expect_complaint(done, 2, f"another run has the folder r: process {os.getpid()} on host {host}, since 2026-01-02 03:04:05 UTC.", "rm 'r/run.lock'")
        t.assertEqual(t.files("r"), ["run.lock"])
    (t.folder / "r/run.lock").write_text("")
    t.expect_complaint(t.run_program("run", deck, "--out", "r"), 2, "r/run.lock does not say which run has the folder r.", "rm 'r/run.lock'")
    (t.folder / "r/run.lock").unlink()
    t.expect_success("run", deck, "--out", "r")


@claim("folder: an unfinished run is replaced with --force only; the refusal has the command that resumes it")
def _(t):
    deck, value = t.deck(*SHORT), "impactors.cylinder.velocity=[0, -30, 0]"
    process = started(t, deck, "--out", "it is here", "--set", value)
    code, out, err = ended(process, signal.SIGINT)
    t.assertEqual((code, err), (130, ""))
    before = contents(t, "it is here", ())
    done = t.run_program("run", deck, "--out", "it is here", "--set", value)
    command = "perimpact run deck.yaml --out 'it is here' --set 'impactors.cylinder.velocity=[0, -30, 0]' --resume"
    t.expect_complaint(done, 2, "the folder it is here contains an unfinished run (step ", f" of 600); resume it with {command} or replace it with --force, or choose")
    t.assertEqual(contents(t, "it is here", ()), before)
    t.expect_success("run", deck, "--out", "it is here", "--set", value, "--resume")
    t.expect_success("run", deck, "--out", "whole", "--set", value)
    t.assertEqual(contents(t, "it is here"), contents(t, "whole"))
    before = contents(t, "whole", ())
    done = t.run_program("run", deck, "--out", "whole")
    t.expect_complaint(done, 2, "the folder whole contains a finished run; replace it with --force, or choose another folder with --out.")
    t.assertEqual(contents(t, "whole", ()), before)
    t.expect_success("run", deck, "--out", "whole", "--force", "--set", "output.frames=1")
    t.expect_success("run", deck, "--out", "fresh", "--set", "output.frames=1")
    t.assertEqual(contents(t, "whole"), contents(t, "fresh"))
    t.expect_complaint(t.run_program("run", deck, "--out", "whole", "--force", "--resume"), 2, "--resume excludes --force")


@claim("folder: a run that was killed before its first checkpoint is not replaced without --force either")
def _(t):
    killed = started(t, t.deck(*LONG), "--out", "r")
    killed.kill()
    killed.communicate()
    done = t.run_program("run", "deck.yaml", "--out", "r")
    t.expect_complaint(done, 2, "the folder r contains an unfinished run without a checkpoint, which cannot be resumed; replace it with --force")
    t.expect_complaint(t.run_program("run", "deck.yaml", "--out", "r", "--resume"), 2, "there is no checkpoint r/checkpoint.h5")
    t.expect_success("run", t.deck(name="small.yaml"), "--out", "r", "--force")
    t.expect_success("run", "small.yaml", "--out", "fresh")
    t.assertEqual(t.files("r"), t.files("fresh"))


@claim("folder: files that no run wrote survive a replaced run, and are never overwritten")
def _(t):
    deck = t.deck(("to: [0, 30 mm, 0]", "to: [0, 30 mm, 0], times: [10 us, 20 us]"))
    t.expect_success("run", deck, "--out", "r", "--set", "output.frames=9")
    t.expect_success("statistics", "r")
    foreign = ["notes.txt", "frames/hero.png", "frames/plate_00099.vtp", "frames/plate_3.vtp", "frames/other.pvd", "lines/reference.csv", "lines/along_y_t1.csv",
               "fragments/mine.csv", "pressure_area/measured.csv", "checkpoint_9.h5.bak", "windows.csv"]
    for name in foreign:
        (t.folder / "r" / name).write_text("kept")
    killed = started(t, t.deck(*LONG, name="long.yaml"), "--out", "r", "--force")
    killed.kill()
    killed.communicate()
    t.expect_success("run", t.deck(), "--out", "r", "--force", "--set", "output.frames=1")
    t.expect_success("run", t.deck(), "--out", "fresh", "--set", "output.frames=1")
    t.assertEqual(t.files("r"), sorted(t.files("fresh") + foreign))
    t.assertEqual({(t.folder / "r" / name).read_text() for name in foreign}, {"kept"})
    for name in "history.csv", "frames/plate_00001.vtp", "lines/along_y_t2e-05.csv":
        path = t.folder / "mine" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("measured")
        for more in [], ["--force"]:
            done = t.run_program("run", t.deck(), "--out", "mine", *more)
            t.assertEqual((done.code, path.read_text()), (2, "measured"))
            t.assertRegex(done.err, rf"mine/{name} would be replaced, but mine/files.txt does not list it|contains an unfinished run")
        path.unlink()


@claim("folder: files.txt lists what a run writes, before it is written")
def _(t):
    t.expect_success("run", t.deck(("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002")), "--out", "r", "--set", "output.checkpoints_kept=2")
    text = (t.folder / "r/files.txt").read_text()
    names = set(text.splitlines()[1:])
    t.assertIn("frames/plate_[00000-00005].vtp", names)
    for name in t.files("r"):
        series = re.sub(r"_0000[0-5]\.vtp$", "_[00000-00005].vtp", name)
        t.assertTrue(series in names or name == "files.txt", name)
    # a list cannot reach outside the folder
    (t.folder / "outside.txt").write_text("kept")
    (t.folder / "r/files.txt").write_text(text + f"../outside.txt\n{t.folder}/outside.txt\nframes/../../outside.txt\n")
    t.expect_success("run", "deck.yaml", "--out", "r", "--force")
    t.assertEqual((t.folder / "outside.txt").read_text(), "kept")


@claim("folder: ~ and $HOME are expanded in --out and in the paths of a deck, other variables and users are refused, and so is the root folder")
def _(t):
    t.environment["HOME"] = str(t.folder / "home")
    (t.folder / "home").mkdir()
    t.expect_success("shape", "sphere", "--diameter", "40 mm", "--edge-length", "8 mm", "--out", "home/ball.stl")
    ball = ("cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}", "file: ~/ball.stl")
    for k, (key, mark) in enumerate((("--out={}", "~"), ("--out={}", "$HOME"), ("--set=output.folder={}", "~"), ("--set=output.folder={}", "${HOME}"))):
        t.expect_success("run", t.deck(ball), key.format(f"{mark}/runs/{k}"))
        t.assertIn("run.json", t.files(f"home/runs/{k}"))
    t.assertEqual(t.report("home/runs/0")["setup"]["impactors"]["cylinder"]["surface"]["file"], str(t.folder / "home/ball.stl"))
    t.expect_complaint(t.run_program("run", t.deck(), "--out", "~nobody/x"), 2, "--out: ~nobody/x begins with ~nobody, which is not expanded; write the full path.")
    t.expect_complaint(t.run_program("run", t.deck(), "--out", "x/$JOB/y"), 2, "--out: x/$JOB/y contains $JOB, but no variable except HOME is expanded")
    t.expect_complaint(t.run_program("run", t.deck(("folder: results", "folder: $SCRATCH/r"))), 2, "deck.yaml:", "$SCRATCH/r contains $SCRATCH")
    for root in "/", "//", "/tmp/..":
        for command in "run", "check":
            t.expect_complaint(t.run_program(command, t.deck(), "--out", root), 2, "--out: the results folder is /, the root of the file system; give a folder below it.")
    t.assertEqual([name for name in os.listdir(t.folder) if name.startswith(("~", "$"))], [])


@claim("folder: a missing frames folder, frame, line or history.csv is reported at --resume, and nothing is changed")
def _(t):
    deck = t.deck(*SHORT, ("to: [0, 30 mm, 0]", "to: [0, 30 mm, 0], times: [1 us, 30 us]"))
    t.expect_success("run", deck, "--out", "r")
    (t.folder / "r/run.json").unlink()
    for name in "frames", "frames/plate_00001.vtp", "history.csv", "lines/along_y_t1e-06.csv":
        (t.folder / "r" / name).rename(t.folder / "away")
        before = contents(t, "r", ())
        done = t.run_program("run", deck, "--out", "r", "--resume")
        t.expect_complaint(done, 2, f"r/{name} is missing, so the run cannot be resumed; restore it, or replace the run by a new one.")
        t.assertEqual(contents(t, "r", ()), before)
        (t.folder / "away").rename(t.folder / "r" / name)
    t.expect_success("run", deck, "--out", "r", "--resume")


@claim("folder: Python claims a folder as the command line does, in both orders")
def _(t):
    build = Path(t.program).parent
    if not (build / "python/perimpact").exists():
        raise unittest.SkipTest("the Python package is not built")
    script = """
import sys, perimpact
simulation = perimpact.Simulation.from_deck("deck.yaml")
try:
    simulation.write_results("r", **eval(sys.argv[1]))
except perimpact.InputError as error:
    sys.exit(str(error))
if len(sys.argv) > 2:
    print("begun", flush=True)
    sys.stdin.readline()
simulation.run()
"""

    def python(keys, *more, **options):
        environment = {**t.environment, "PYTHONPATH": str(build / "python")}
        return subprocess.Popen(["/usr/bin/python3", "-c", script, keys, *more], cwd=t.folder, env=environment, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)

    def refused(keys):
        process = python(keys)
        _, err = process.communicate(timeout=60)
        t.assertEqual(process.returncode, 1)
        return err

    first = started(t, t.deck(*LONG), "--out", "r")
    t.assertIn(f"another run is writing into the folder r: process {first.pid}", refused("{}"))
    ended(first)
    t.assertIn('resume it with write_results("r", resume=True) or replace it with overwrite=True', refused("{}"))
    t.assertIn("given both resume and overwrite", refused("{'resume': True, 'overwrite': True}"))
    t.deck()
    second = python("{'overwrite': True}", "waits")
    second.stdout.readline()
    for more in [], ["--force"]:
        t.expect_complaint(t.run_program("run", "deck.yaml", "--out", "r", *more), 2, f"another run is writing into the folder r: process {second.pid}")
    second.communicate("\n", timeout=60)
    t.assertEqual((second.returncode, t.report("r")["outcome"]), (0, "finished"))
    t.assertNotIn("run.lock", t.files("r"))
    t.assertIn("contains a finished run; replace it with overwrite=True", refused("{}"))


main()
