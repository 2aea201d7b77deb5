"""--quiet, --verbose, --log, and what programs read: check --json and run --progress json."""

import json
import resource
import signal

from claims import MOVES, claim, main
from folders import LONG, ended, started

AWAY = ("-32 m/s", "32 m/s")  # the impactor moves away: a warning at the end
SCHEMA = 1
SUMMARY = "body plate\n  particles         960 (20 x 12 x 4 cells of 0.005 m)\n"


def events(out):
    return [json.loads(line) for line in out.splitlines()]


@claim("messages: --quiet prints nothing but warnings, of run and of check; --verbose also the summary of check; not both")
def _(t):
    for command in "run", "check":
        t.assertEqual(t.expect_success(command, t.deck(), "--out", command, "--quiet").out, "")
    out = t.expect_success("run", t.deck(AWAY), "--out", "away", "--quiet").out
    t.assertEqual(len(out.splitlines()), 1)
    t.assertTrue(out.startswith("warning: Impactor cylinder had no contact with body plate"), out)
    t.assertNotIn(SUMMARY, t.expect_success("run", t.deck(), "--out", "plain").out)
    t.assertIn(SUMMARY, t.expect_success("run", "deck.yaml", "--out", "verbose", "--verbose").out)
    t.expect_complaint(t.run_program("run", "deck.yaml", "--quiet", "--verbose"), 2, "--quiet excludes --verbose")


@claim("messages: --log appends all messages to a file, also with --quiet, as JSON and on an error, and is refused where it cannot be written")
def _(t):
    out = t.expect_success("run", t.deck(AWAY), "--out", "r", "--log", "run.log").out
    t.assertEqual((t.folder / "run.log").read_text(), out)
    quiet = t.expect_success("run", t.deck(AWAY), "--out", "q", "--log", "run.log", "--quiet").out
    both = (t.folder / "run.log").read_text()
    t.assertTrue(both.startswith(out))
    for words in "Small plate\n", "results go to q", "100.0 %", quiet:
        t.assertIn(words, both[len(out) :])
    done = t.run_program("run", t.deck(AWAY), "--out", "r", "--log", "refused.log")
    t.assertEqual((t.folder / "refused.log").read_text(), done.err)
    t.assertTrue(done.err.startswith("error: the folder r contains a finished run"), done.err)
    t.expect_success("run", "deck.yaml", "--out", "j", "--log", "json.log", "--progress", "json")
    t.assertIn("results go to j", (t.folder / "json.log").read_text())
    for file, words in (".", "it is a folder. Append a file name."), ("no/run.log", "there is no folder no."):
        t.expect_complaint(t.run_program("run", "deck.yaml", "--out", "n", "--log", file), 2, f"{file} cannot be written: {words}")
    t.assertFalse((t.folder / "n").exists())


@claim("messages: a window that moves with a damaged front is reported at once, with the time, and once more at the end")
def _(t):
    hammer = ("  hammer:\n    surface: {cylinder: {diameter: 10 mm, height: 40 mm, axis: z, edge_length: 2 mm}}\n    mass: 1 kg\n"
              "    position: [25 mm, 35.05 mm, 0]\n    velocity: [0, -100 m/s, 0]\n")  # fmt: skip
    deck = t.deck(*MOVES, ("-100 m/s, 0]", "0, 0]"), ("density: 8000 kg/m3}", "density: 8000 kg/m3, critical_stretch: 1e-4}"), ("contact:\n", hammer + "contact:\n"))
    lines = [line for line in t.run_program("run", deck, "--quiet", "--out", "r").out.splitlines() if "moving window" in line]
    t.assertEqual(len(lines), 2, lines)
    t.assertRegex(lines[0], r"^warning: At t = [\d.e-]+ s: The moving window of body plate moved although the material at its front was damaged \(up to [\d.]+\)")
    t.assertTrue(lines[1].startswith("warning: The moving window of body plate"), lines[1])
    t.assertLess(float(lines[0].split()[4]), 1e-5)  # of 2e-5 s


@claim("messages: run --progress json prints one object a line, with the documented members, and the warnings of run.json")
def _(t):
    printed = events(t.expect_success("run", t.deck(AWAY), "--out", "r", "--progress", "json", "--threads", "2").out)
    t.assertEqual([each["event"] for each in printed], ["start", "progress", "warning", "end", "report"])
    start, progress, warning, end, report = printed
    steps = t.report("r")["steps"]
    t.assertEqual((start["schema"], start["title"], start["folder"], start["threads"], start["steps"]), (SCHEMA, "Small plate", "r", 2, steps))
    t.assertEqual(start["step [s]"], t.report("r")["stability"]["step [s]"])
    t.assertEqual(start["program"], t.report("r")["program"])
    t.assertEqual(set(progress), {"event", "share", "time [s]", "step", "steps", "steps_per_second", "contacts", "left [s]"})
    t.assertEqual((progress["share"], progress["step"], progress["steps"], progress["left [s]"]), (1, steps, steps, 0))
    t.assertEqual([warning["text"]], t.report("r")["warnings"])
    t.assertEqual({key: end[key] for key in ("outcome", "step")}, {"outcome": "finished", "step": steps})
    t.assertEqual(report["file"], "r/report.html")

    code, out, err = ended(started(t, t.deck(*LONG), "--out", "long", "--progress", "json"), signal.SIGTERM)
    t.assertEqual((code, err), (143, ""))
    t.assertEqual(events(out)[-1]["outcome"], "interrupted")
    t.assertEqual(events(out)[-1]["resume"], "perimpact run deck.yaml --out long --resume")

    limits = {resource.RLIMIT_FSIZE: 5000}  # as if the disk were full
    done = t.run_program("run", t.deck(("history_interval: 2 us", "history_interval: 0.1 us"), ("frames: 4", "frames: 0")), "--out", "failed", "--progress", "json",
                         "--no-report", limits=limits)
    t.assertEqual(done.code, 3)
    t.assertEqual({key: events(done.out)[-1][key] for key in ("event", "outcome")}, {"event": "end", "outcome": "failed"})
    t.assertEqual(f"error: {events(done.out)[-1]['text']}\n", done.err)


@claim("messages: run --progress json reports increments of relaxation")
def _(t):
    (t.folder / "relax.yaml").write_text("""\
time: {end: 1, relax: {increments: 2, tolerance: 1e-3, max_iterations: 10000}}
bodies:
  bar:
    shape: {box: {size: [60 mm, 20 mm, 20 mm]}}
    spacing: 5 mm
    material: {model: bond-based, youngs_modulus: 1 GPa, density: 1000}
    particle_sets: {left: {shape: {box: {size: [30 mm, 1, 1]}}, position: [-30 mm, 0, 0]}, right: {shape: {box: {size: [30 mm, 1, 1]}}, position: [30 mm, 0, 0]}}
    boundary_conditions: {clamp: {fixed: {particle_set: left}}, pull: {prescribed: {particle_set: right, x: {velocity: 0.1 mm/s}}}}
output: {folder: r}
""")
    printed = events(t.expect_success("run", "relax.yaml", "--progress", "json", "--no-report").out)
    start = printed[0]
    t.assertEqual((start["increments"], start["increment [s]"]), (2, 0.5))
    last = [each for each in printed if each["event"] == "progress"][-1]
    t.assertEqual(set(last), {"event", "share", "time [s]", "increment", "increments", "iterations", "residual", "left [s]"})
    t.assertEqual((last["increment"], last["share"]), (2, 1))


@claim("messages: check --json prints one object, with the numbers of the summary and of run.json; a refusal prints no JSON")
def _(t):
    deck = t.deck(("density: 8000 kg/m3", "density: 8"))
    out = t.expect_success("check", deck, "--out", "r", "--json", "--threads", "2").out
    check = json.loads(out)
    t.assertEqual(list(check), ["schema", "program", "title", "folder", "bodies", "impactors", "time", "memory", "duration [s]", "threads", "warnings"])
    t.assertEqual((check["schema"], check["title"], check["folder"], check["threads"]), (SCHEMA, "Small plate", "r/check", 2))
    t.assertEqual(len(check["warnings"]), 1)
    t.assertTrue(check["warnings"][0].startswith("The density of plate is 8 kg/m3"))
    t.expect_success("run", deck, "--out", "r")
    run = t.report("r")
    plate = check["bodies"]["plate"]
    for key in "particles", "bonds", "spacing [m]", "horizon [m]", "mass [kg]":
        t.assertEqual(plate[key], run["bodies"]["plate"][key], key)
    cylinder = check["impactors"]["cylinder"]
    for key in "surface", "mass [kg]", "inertia [kg m2]":
        t.assertEqual(cylinder[key], run["impactors"]["cylinder"][key], key)
    first = cylinder["first_contact"]["plate"]
    text = t.expect_success("check", deck, "--out", "r").out
    t.assertIn(f"with plate at {first['time [s]']:.4g} s (step {first['step']}), initial distance {first['distance [m]']:.4g} m", text)
    t.assertIn(f"({check['time']['estimate [s]']:.4g} s), ", text)
    t.assertIn(f"exact critical step ({check['time']['exact [s]']:.4g} s)", text)
    t.assertEqual((check["time"]["steps"], check["time"]["step [s]"]), (run["steps"], run["stability"]["step [s]"]))
    t.assertGreater(check["memory"]["peak [byte]"], 1e6)
    t.assertGreater(check["duration [s]"], 0)
    done = t.run_program("check", t.deck(("density: 8000 kg/m3", "density: -1")), "--json")
    t.expect_complaint(done, 2, "deck.yaml:", "density")
    t.assertEqual(done.out, "")


main()
