"""Signals: those that end a run leave a checkpoint from which it resumes bitwise, SIGUSR1 writes one and the run continues."""

import json
import random
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

from claims import claim, main
from folders import LONG, SHORT, contents, ended, started

# a hundred times as many steps as SHORT, so that the run does not end before the signal
STEPS = (SHORT[0], SHORT[1], SHORT[2], ("  history_interval: 2 us", "  history_interval: 0.7 us\n  checkpoint_interval: 0"))


@claim("signals: SIGINT, SIGTERM, SIGHUP and SIGXCPU end a run after its step with 128 + number, and it resumes to the state of an uninterrupted run")
def _(t):
    deck = t.deck(*STEPS)
    t.expect_success("run", deck, "--out", "whole")
    for which in signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU:
        shutil.rmtree(t.folder / "r", ignore_errors=True)
        code, out, err = ended(started(t, deck, "--out", "r"), which)
        t.assertEqual((code, err), (128 + which, ""), which)
        t.assertIn("resume with perimpact run deck.yaml --out r --resume\n", out)
        t.assertEqual(t.report("r")["outcome"], "interrupted")
        t.assertNotIn("run.lock", t.files("r"))
        t.expect_success("run", deck, "--out", "r", "--resume")
        t.assertEqual(t.report("r")["state_hash"], t.report("whole")["state_hash"])
        t.assertEqual(contents(t, "r"), contents(t, "whole"))


@claim("signals: SIGUSR1 writes a checkpoint and the run continues; killed then, it resumes to the state of an uninterrupted run")
def _(t):
    deck = t.deck(*STEPS)
    t.expect_success("run", deck, "--out", "whole")
    for _ in range(10):  # on a busy machine the run may reach its last checkpoint before this is noticed
        shutil.rmtree(t.folder / "r", ignore_errors=True)
        process = started(t, deck, "--out", "r")
        process.send_signal(signal.SIGUSR1)
        while process.poll() is None and not (t.folder / "r/checkpoint.h5").exists():
            time.sleep(0.001)
        rows = len((t.folder / "r/history.csv").read_text().splitlines())
        if rows < 40:  # of 45
            break
        ended(process, signal.SIGKILL)
    t.assertLess(rows, 40, "no checkpoint was written")
    while process.poll() is None and len((t.folder / "r/history.csv").read_text().splitlines()) <= rows:
        time.sleep(0.001)
    t.assertIn(process.poll(), (None, 0))
    process.kill()
    process.communicate()
    (t.folder / "r/run.json").unlink(missing_ok=True)
    t.assertIn("Resumed at step ", t.expect_success("run", deck, "--out", "r", "--resume").out)
    t.assertEqual(contents(t, "r"), contents(t, "whole"))


def wait_for_handler(process, which):
    """Until the program catches the signal (Linux: the mask SigCgt)."""
    caught = 0
    while process.poll() is None and not caught >> (which - 1) & 1:
        status = Path(f"/proc/{process.pid}/status").read_text()
        caught = int(re.search(r"^SigCgt:\s*(\w+)", status, re.MULTILINE)[1], 16)
        time.sleep(0.001)


@claim("signals: during the set-up they end run and check with 128 + number and a sentence, unlock the folder, and leave an earlier run as it was")
def _(t):
    large = ("spacing: 5 mm", "spacing: 1 mm")  # 120 000 particles, whose set-up takes tenths of a second
    t.expect_success("run", t.deck(*SHORT), "--out", "r")
    before = contents(t, "r", without=())
    sentence = "Interrupted during the set-up; no results were written.\n"
    deck = t.deck(large, name="large.yaml")
    for which in signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU:
        for arguments in ["run", "--out", "r", "--force"], ["run", "--out", "new"], ["check", "--out", "new"], ["run", "--out", "r", "--force", "--progress", "json"]:
            process = t.start(arguments[0], deck, *arguments[1:], "--threads", "1")
            if "json" in arguments:
                wait_for_handler(process, which)  # it prints nothing before the set-up
            else:
                t.assertEqual(process.stdout.readline(), "Small plate\n")
            time.sleep(0.02)
            code, rest, err = ended(process, which)
            t.assertEqual((code, err), (128 + which, ""), arguments)
            if "json" in arguments:
                events = [json.loads(line) for line in rest.splitlines()]
                t.assertEqual([event for event in events if "stage" not in event], [{"event": "end", "outcome": "interrupted", "text": sentence.strip()}])
            else:
                t.assertEqual("".join(line for line in rest.splitlines(keepends=True) if not line.startswith("set-up:")), sentence)  # of a slow machine
            t.assertEqual(contents(t, "r", without=()), before)
            t.assertNotIn("run.lock", t.files("new") if (t.folder / "new").exists() else [])


@claim("signals: a second SIGINT ends the program at once, and a run started with nohup ignores SIGHUP")
def _(t):
    relax = """\
time: {end: 1, relax: {increments: 1, tolerance: 1e-12, max_iterations: 1000000}}
bodies:
  bar:
    shape: {box: {size: [60 mm, 20 mm, 20 mm]}}
    spacing: 1 mm
    material: {model: bond-based, youngs_modulus: 1 GPa, density: 1000}
    particle_sets: {left: {shape: {box: {size: [6 mm, 1, 1]}}, position: [-30 mm, 0, 0]}, right: {shape: {box: {size: [6 mm, 1, 1]}}, position: [30 mm, 0, 0]}}
    boundary_conditions: {clamp: {fixed: {particle_set: left}}, pull: {prescribed: {particle_set: right, x: {velocity: 0.1 mm/s}}}}
output: {folder: r, frames: 2000}
"""
    (t.folder / "relax.yaml").write_text(relax)
    for _ in range(20):  # the second one must arrive before the first is acted upon, within an iteration
        shutil.rmtree(t.folder / "r", ignore_errors=True)
        process = started(t, "relax.yaml", "--out", "r", "--threads", "1", rows=0)
        time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        time.sleep(0.0005)
        code, _, _ = ended(process, signal.SIGINT)
        t.assertIn(code, (-signal.SIGINT, 130))
        if code == -signal.SIGINT:
            break
    t.assertEqual(code, -signal.SIGINT)

    shielded = subprocess.Popen(["nohup", t.program, "run", t.deck(*LONG), "--out", "h"], cwd=t.folder, env=t.environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not (t.folder / "h/history.csv").exists():
        t.assertIsNone(shielded.poll())
        time.sleep(0.005)
    time.sleep(0.1)
    shielded.send_signal(signal.SIGHUP)
    time.sleep(0.1)
    t.assertIsNone(shielded.poll())
    t.assertEqual(ended(shielded)[0], 143)


@claim("signals: killed at random moments, a folder resumes to the same state, or the refusal says what to do")
def _(t):
    deck, chance = t.deck(*SHORT), random.Random(18)
    begin = time.monotonic()
    t.expect_success("run", deck, "--out", "whole")
    duration = time.monotonic() - begin
    for attempt in range(4):
        folder, resume = f"r{attempt}", []
        for _ in range(3):
            process = t.start("run", deck, "--out", folder, *resume)
            try:
                _, err = process.communicate(timeout=chance.uniform(0, 0.8 * duration))
            except subprocess.TimeoutExpired:
                process.kill()
                _, err = process.communicate()
            if process.returncode == 0 or (t.folder / folder / "run.json").exists():  # or killed during the report
                break
            t.assertIn((process.returncode, err), ((-9, ""),))
            has_begun, has_checkpoint = ((t.folder / folder / name).exists() for name in ("history.csv", "checkpoint.h5"))
            done = t.run_program("run", deck, "--out", folder)  # the same command again
            if not has_begun:  # it was killed before it wrote anything
                t.assertEqual((done.code, done.err), (0, ""))
                break
            if has_checkpoint:
                t.expect_complaint(done, 2, f"the folder {folder} contains an unfinished run (step ", f"resume it with perimpact run deck.yaml --out {folder} --resume")
                resume = ["--resume"]
            else:
                t.expect_complaint(done, 2, f"the folder {folder} contains an unfinished run without a checkpoint, which cannot be resumed; replace it with --force")
                resume = ["--force"]
        if process.returncode != 0:
            has_finished = (t.folder / folder / "run.json").exists()  # the report may be missing, which --resume writes
            t.expect_success("run", deck, "--out", folder, *(["--resume"] if has_finished else resume))
        for draft in (t.folder / folder).glob(".run.lock.*"):  # of a process that was killed within the microseconds in which it exists
            draft.unlink()
        t.assertEqual(contents(t, folder), contents(t, "whole"))
        t.assertEqual(t.report(folder)["state_hash"], t.report("whole")["state_hash"])


main()
