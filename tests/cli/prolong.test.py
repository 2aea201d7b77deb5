"""Longer than planned: a run resumed with a later time.end equals one that had this end from the start."""

import re
import shutil
import signal

from claims import claim, main
from folders import SHORT, contents, ended, started

TWICE = ["--set", "time.end=60 us", "--set", "output.frames=8"]
LINE = ("to: [0, 30 mm, 0]}", "to: [0, 30 mm, 0]}\n    early: {body: plate, from: [0, -30 mm, 0], to: [0, 30 mm, 0], times: [3 us, 17 us]}")


def expect_same(t, folder, whole):
    t.assertEqual(contents(t, folder), contents(t, whole))
    report, wanted = t.report(folder), t.report(whole)
    for key in "state_hash", "steps", "time [s]", "outcome", "setup", "bodies":
        t.assertEqual(report[key], wanted[key], key)


@claim("prolong: a finished run and an interrupted one, resumed with a later end, are bitwise identical to a run with this end from the start")
def _(t):
    deck = t.deck(*SHORT, LINE)
    t.expect_success("run", deck, "--out", "whole", *TWICE)
    t.expect_success("run", deck, "--out", "r")
    t.expect_success("statistics", "r")  # of the shorter run, hence gone afterwards
    at_end = [name for name in t.files("r") if name.startswith("lines/along_y")]
    t.assertEqual(len(at_end), 1)
    out = t.expect_success("run", deck, "--out", "r", "--resume", *TWICE).out
    t.assertIn("Resumed at step 599 (t = ", out)  # before the last step, whose row and frame the longer run need not have
    expect_same(t, "r", "whole")
    t.assertNotIn(at_end[0], t.files("r"))
    t.assertEqual(t.report("r")["resumed_at_steps"], [599])
    t.assertIn("nothing to resume", t.expect_success("run", deck, "--out", "r", "--resume", *TWICE).out)
    slow = ["--set", "output.checkpoint_interval=0"]
    code, _, err = ended(started(t, deck, "--out", "i", *slow), signal.SIGINT)
    t.assertEqual((code, err), (130, ""))
    t.expect_success("run", deck, "--out", "i", "--resume", *TWICE, *slow)
    t.assertEqual(t.report("i")["state_hash"], t.report("whole")["state_hash"])
    t.assertEqual(contents(t, "i"), contents(t, "whole"))


@claim("prolong: an automatic time step is kept with --set time.step, which the refusal states")
def _(t):
    deck = t.deck(("end: 20 us", "end: 10.3 us"), ("  history_interval: 2 us\n", ""))
    t.expect_success("run", deck, "--out", "r")
    longer = ["--set", "time.end=20.6 us", "--set", "output.frames=8"]
    before = contents(t, "r", ())
    done = t.run_program("run", deck, "--out", "r", "--resume", "--set", "time.end=23.1 us")
    step, steps = t.report("r")["stability"]["step [s]"], t.report("r")["steps"]
    t.expect_complaint(done, 2, "deck.yaml:2:", "the time step is ", f"resume with --set time.step={step!r}.")
    t.assertEqual(contents(t, "r", ()), before)
    longer += ["--set", f"time.step={step!r}"]
    done = t.run_program("run", deck, "--out", "r", "--resume", *longer)
    if done.code == 2:  # the default interval of history.csv, a hundredth of the run
        t.expect_complaint(done, 2, "", "resume with --set output.history_interval=")
        longer += ["--set", done.err.split("--set ")[-1].rstrip(".\n")]
        t.expect_success("run", deck, "--out", "r", "--resume", *longer)
    t.expect_success("run", deck, "--out", "whole", *longer)
    t.assertEqual(t.report("whole")["steps"], 2 * steps)
    expect_same(t, "r", "whole")


@claim("prolong: frames at other times follow those written so far, also where the run had none or no more are requested")
def _(t):
    deck = t.deck(*SHORT)  # 4 frames in 30 us, the last checkpoint before the last step
    folders = {"more": ["time.end=40 us", "output.frames=10"], "none": ["time.end=40 us", "output.frames=0"]}
    for folder, settings in folders.items():
        t.expect_success("run", deck, "--out", folder)
        t.expect_success("run", deck, "--out", folder, "--resume", *(word for setting in settings for word in ("--set", setting)))
    t.expect_success("run", deck, "--out", "first", "--set", "output.frames=0")
    t.expect_success("run", deck, "--out", "first", "--resume", "--set", "time.end=40 us", "--set", "output.frames=4")
    times = {folder: [round(1e6 * float(time), 6) for time in re.findall('timestep="([^"]*)"', (t.folder / folder / "frames/plate.pvd").read_text())]
             for folder in ("more", "none", "first")}
    t.assertEqual(times["more"], [0, 7.5, 15, 22.5, 32, 36, 40])  # 28 us is before step 599, that of 30 us is written after the checkpoint
    t.assertEqual(times["none"], [0, 7.5, 15, 22.5])
    t.assertEqual(times["first"], [30, 40])
    for folder in times:
        t.assertEqual(len([name for name in t.files(folder) if re.fullmatch(r"frames/plate_\d+.vtp", name)]), len(times[folder]))


@claim("prolong: a shorter run is refused")
def _(t):
    deck = t.deck(*SHORT)
    t.expect_success("run", deck, "--out", "r")
    before = contents(t, "r", ())
    done = t.run_program("run", deck, "--out", "r", "--resume", "--set", "time.end=20 us")
    t.expect_complaint(done, 2, "--set time.end: time.end is 2e-05 here, but 3e-05 in the run of the checkpoint r/checkpoint.h5; a run can be prolonged, but not shortened.")
    t.assertEqual(contents(t, "r", ()), before)


@claim("prolong: a relaxed state is continued with more increments")
def _(t):
    (t.folder / "bar.yaml").write_text("""\
time: {end: 1, relax: {increments: 4, tolerance: 1e-5}}
bodies:
  bar:
    shape: {box: {size: [30 mm, 10 mm, 10 mm]}}
    spacing: 2 mm
    material: {model: bond-based, youngs_modulus: 1 GPa, density: 1000}
    particle_sets: {left: {shape: {box: {size: [6 mm, 1, 1]}}, position: [-15 mm, 0, 0]}, right: {shape: {box: {size: [6 mm, 1, 1]}}, position: [15 mm, 0, 0]}}
    boundary_conditions: {clamp: {fixed: {particle_set: left}}, pull: {prescribed: {particle_set: right, x: {velocity: 0.01 mm/s}}}}
output: {frames: 2}
""")
    longer = ["--set", "time.end=2", "--set", "time.relax.increments=8", "--set", "output.frames=4"]
    t.expect_success("run", "bar.yaml", "--out", "whole", *longer)
    t.expect_success("run", "bar.yaml", "--out", "r")
    done = t.run_program("run", "bar.yaml", "--out", "r", "--resume", "--set", "time.end=2")
    t.expect_complaint(done, 2, "bar.yaml:", "an increment is 0.5 s here, but 0.25 s in the run", "--set time.relax.increments=8.")
    t.expect_success("run", "bar.yaml", "--out", "r", "--resume", *longer)
    expect_same(t, "r", "whole")


@claim("prolong: the last checkpoints are kept, and --resume takes the newest that is readable and reports an older one")
def _(t):
    deck = t.deck(*SHORT)
    keep = ["--set", "output.checkpoints_kept=3", "--set", "output.checkpoint_interval=1 ns", "--set", "time.end=3 us"]  # 60 steps
    t.expect_success("run", deck, "--out", "whole", *keep)
    names = [name for name in t.files("whole") if name.startswith("checkpoint")]
    t.assertEqual(names, ["checkpoint.h5", "checkpoint_1.h5", "checkpoint_2.h5"])
    for damaged, step in ([], 59), (["checkpoint.h5"], 58), (["checkpoint.h5", "checkpoint_1.h5"], 57):
        shutil.copytree(t.folder / "whole", t.folder / "r")
        (t.folder / "r/run.json").unlink()
        for name in damaged:
            content = (t.folder / "r" / name).read_bytes()
            (t.folder / "r" / name).write_bytes(content[: len(content) // 2])
        out = t.expect_success("run", deck, "--out", "r", "--resume", *keep).out
        t.assertIn(f"Resumed at step {step} (t = ", out)
        if damaged:
            t.assertIn(f"The run resumes from the older checkpoint r/checkpoint_{len(damaged)}.h5 (step {step}).", out)
            t.assertIn("r/checkpoint.h5 is damaged", out)
        else:
            t.assertNotIn("older checkpoint", out)
        t.assertEqual(t.report("r")["state_hash"], t.report("whole")["state_hash"])
        t.assertEqual({name: data for name, data in contents(t, "r").items() if not name.startswith("checkpoint")},
                      {name: data for name, data in contents(t, "whole").items() if not name.startswith("checkpoint")})
        t.assertEqual([name for name in t.files("r") if name.startswith("checkpoint")], names)
        shutil.rmtree(t.folder / "r")


@claim("prolong: files.txt lists the frames of both parts, so that the run can be resumed with more of them and replaced wholly")
def _(t):
    deck = t.deck(*SHORT)
    t.expect_success("run", deck, "--out", "r", "--set", "output.frames=10")
    t.expect_success("run", deck, "--out", "r", "--resume", "--set", "time.end=60 us", "--set", "output.frames=10")
    t.assertIn("frames/plate_00013.vtp", t.files("r"))
    t.expect_success("run", deck, "--out", "r", "--resume", "--set", "time.end=90 us", "--set", "output.frames=40")
    t.expect_success("run", deck, "--out", "r", "--force", "--set", "output.frames=2")
    t.assertEqual([name for name in t.files("r") if name.startswith("frames/plate_")], [f"frames/plate_{k:05}.vtp" for k in range(3)])


main()
