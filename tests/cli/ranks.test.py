"""Runs of several processes under mpirun. Claims that need the library of ranks are skipped where it was not built."""

import itertools
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from claims import MOVES, MPIRUN_AS_ROOT, claim, main
from folders import LONG, SHORT, contents, ended, started


def launched(t, ranks, *options):
    """From here on, t's program is that many of its processes. Skipped without mpirun or the library."""
    build = Path(t.program).parent
    if not (shutil.which("mpirun") and (build / "libperimpact_ranks.so").exists()):
        raise unittest.SkipTest("the program was built without MPI")
    return script(t, f"ranks_{ranks}", f'exec mpirun --oversubscribe {" ".join(options)} -n {ranks} {t.program} "$@"')


def script(t, name, line):
    file = t.folder / name
    file.write_text("#!/bin/sh\n" + "".join(f"export {key}={value}\n" for key, value in MPIRUN_AS_ROOT.items()) + line + "\n")
    file.chmod(0o755)
    return str(file)


def with_program(t, program, use):
    before, t.program = t.program, program
    try:
        return use()
    finally:
        t.program = before


def errors(done):
    return [line for line in done.err.splitlines() if line.startswith("error:")]


def expect_one_error(t, done, code, begins, *words):
    """One sentence of the program on stderr, beside what mpirun says."""
    t.assertEqual(done.code, code, done)
    t.assertEqual(len(errors(done)), 1, done.err)
    t.assertTrue(errors(done)[0].startswith(f"error: {begins}"), done.err)
    for word in words:
        t.assertIn(word, errors(done)[0])


def processes_of(t, folder):
    """Numbers of the processes that run into this folder, without mpirun."""
    found = []
    for path in Path("/proc").glob("[0-9]*"):
        try:
            words = (path / "cmdline").read_bytes().split(b"\0")
            if words[0] == t.program.encode() and str(folder).encode() in words and (path / "cwd").resolve() == t.folder:
                found.append(int(path.name))
        except OSError:
            pass  # it has ended
    return sorted(found)


@claim("ranks: 2, 3 and 4 processes write the results of one, byte for byte, and the root alone prints")
def _(t):
    deck = t.deck(*SHORT)
    t.expect_success("run", deck, "--out", "1")
    for ranks in 2, 3, 4:
        done = with_program(t, launched(t, ranks), lambda: t.run_program("run", deck, "--out", str(ranks), "--threads", "1"))
        t.assertEqual(done.code, 0, done)
        t.assertEqual(done.out.count("Small plate\n"), 1, done.out)
        t.assertEqual(done.out.count(f"{ranks} ranks with 1 thread each, 600 steps of "), 1, done.out)
        t.assertEqual(contents(t, str(ranks)), contents(t, "1"))
        t.assertEqual(t.report(str(ranks))["state_hash"], t.report("1")["state_hash"])
        t.assertEqual(t.report(str(ranks))["ranks"], ranks)
        t.assertNotIn("run.lock", t.files(str(ranks)))


@claim("ranks: 3 processes write the results of one for a body with a moving window, byte for byte")
def _(t):
    deck = t.deck(*MOVES)
    apart = "--set", "contact.fragments.law=none"
    t.expect_success("run", deck, "--out", "1", *apart)
    done = with_program(t, launched(t, 3), lambda: t.run_program("run", deck, "--out", "3", "--threads", "1", *apart))
    t.assertEqual(done.code, 0, done)
    t.assertEqual(contents(t, "3"), contents(t, "1"))
    t.assertEqual(t.report("3")["state_hash"], t.report("1")["state_hash"])


@claim("ranks: a signal to one process ends all after the same step, and the run resumes on another number of ranks to the same state")
def _(t):
    deck = t.deck(*SHORT, ("30 us, step", "400 us, step"))
    t.expect_success("run", deck, "--out", "whole", "--no-report")
    two, three = launched(t, 2), launched(t, 3)
    process = with_program(t, two, lambda: started(t, deck, "--out", "r", "--threads", "1", "--no-report"))
    os.kill(processes_of(t, "r")[1], signal.SIGTERM)
    code, out, err = ended(process, 0)
    t.assertIn("Interrupted at ", out)
    t.assertEqual([line for line in err.splitlines() if line.startswith("error:")], [])
    t.assertEqual(code, 143)
    t.assertEqual(t.report("r")["outcome"], "interrupted")
    t.assertNotIn("run.lock", t.files("r"))
    done = with_program(t, three, lambda: t.run_program("run", deck, "--out", "r", "--threads", "1", "--no-report", "--resume"))
    t.assertEqual(done.code, 0, done)
    t.assertEqual(done.out.count("Resumed at step "), 1)
    t.assertEqual(contents(t, "r"), contents(t, "whole"))


@claim("ranks: SIGUSR1 to mpirun writes one checkpoint, and the run continues")
def _(t):
    deck = t.deck(*LONG, ("  history_interval: 2 us", "  history_interval: 2 us\n  checkpoint_interval: 0"))
    process = with_program(t, launched(t, 2), lambda: started(t, deck, "--out", "r", "--threads", "1"))
    t.assertFalse((t.folder / "r/checkpoint.h5").exists())
    process.send_signal(signal.SIGUSR1)
    deadline = time.monotonic() + 60
    while not (t.folder / "r/checkpoint.h5").exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    t.assertTrue((t.folder / "r/checkpoint.h5").exists())
    rows = len((t.folder / "r/history.csv").read_text().splitlines())
    while len((t.folder / "r/history.csv").read_text().splitlines()) <= rows:
        t.assertLess(time.monotonic(), deadline)
        t.assertIsNone(process.poll())
        time.sleep(0.01)
    ended(process)


@claim("ranks: a killed process ends all others within ten seconds, and one process resumes the run to the state of an uninterrupted run")
def _(t):
    deck = t.deck(*SHORT, ("30 us, step", "100 us, step"))
    t.expect_success("run", deck, "--out", "whole", "--no-report")
    three = launched(t, 3)
    process = with_program(t, three, lambda: started(t, deck, "--out", "r", "--threads", "1", "--no-report"))
    while process.poll() is None and not (t.folder / "r/checkpoint.h5").exists():
        time.sleep(0.005)
    ranks = processes_of(t, "r")
    t.assertEqual(len(ranks), 3)
    os.kill(ranks[1], signal.SIGKILL)
    process.communicate(timeout=10)
    t.assertNotEqual(process.returncode, 0)
    t.assertEqual(processes_of(t, "r"), [])
    t.assertIn("Resumed at step ", t.expect_success("run", deck, "--out", "r", "--no-report", "--resume").out)
    t.assertEqual(contents(t, "r"), contents(t, "whole"))


@claim("ranks: a body from a file of points has, byte for byte, the results of one process, also after a checkpoint of another number of processes")
def _(t):
    move = random.Random(3)
    rows = [[5 * (k + move.uniform(-0.2, 0.2)) for k in cell] for cell in itertools.product(range(8), range(12), range(4))]
    move.shuffle(rows)
    lines = [f"{x - 17.5},{y - 29},{z - 7.5},{move.uniform(100, 150)}\n" for x, y, z in rows]
    (t.folder / "points.csv").write_text("x [mm],y [mm],z [mm],volume [mm3]\n" + "".join(lines))
    points = ("shape: {box: {size: [40 mm, 60 mm, 20 mm]}}\n    spacing: 5 mm", "shape: {points: {file: points.csv}}")
    deck = t.deck(*SHORT, points)
    t.expect_success("run", deck, "--out", "1")
    for ranks in 2, 3:
        done = with_program(t, launched(t, ranks), lambda: t.run_program("run", deck, "--out", str(ranks), "--threads", "1"))
        t.assertEqual(done.code, 0, done)
        t.assertEqual(contents(t, str(ranks)), contents(t, "1"))
    first_half = "--set", "time.end=15 us", "--set", "output.frames=2"
    half = with_program(t, launched(t, 3), lambda: t.run_program("run", deck, "--out", "half", "--threads", "1", *first_half))
    t.assertEqual(half.code, 0, half)
    t.assertIn("Resumed at step 299", t.expect_success("run", deck, "--out", "half", "--resume").out)
    t.assertEqual(contents(t, "half"), contents(t, "1"))


@claim("ranks: an error of all processes is one sentence, with its exit status: of a missing deck, a value, a folder, and more ranks than parts of the bodies")
def _(t):
    two = launched(t, 2)
    deck = t.deck(*SHORT)
    t.expect_success("run", deck, "--out", "taken")
    (t.folder / "cloud.csv").write_text("x [mm], y [mm], z [mm], volume [mm3]\n0, 0, 0, 125\n5, 0, 0, 125\n")
    cloud = t.deck(("shape: {box: {size: [100 mm, 60 mm, 20 mm]}}", "shape: {points: {file: cloud.csv}}"), ("    spacing: 5 mm\n", ""), name="cloud.yaml")
    for arguments, begins in (
        (["none.yaml"], "none.yaml: there is no such file"),
        ([deck, "--set", "bodies.plate.spacing=0"], "--set bodies.plate.spacing"),
        ([deck, "--out", "taken"], "the folder taken contains a finished run"),
        ([cloud, "--out", "new"], "cloud.yaml:3:1: 2 ranks are too many: the bodies can be divided among at most 1, "),
        ([deck, "--bogus"], "The following argument was not expected: --bogus"),
    ):
        done = with_program(t, two, lambda: t.run_program("run", *arguments))
        expect_one_error(t, done, 2, begins)


@claim("ranks: an error of one process alone ends all within ten seconds with its sentence and exit status, be it the root or another one")
def _(t):
    launched(t, 2)
    deck = t.deck(*LONG)
    for first, second in (deck, "none.yaml"), ("none.yaml", deck):
        part = [f"-n 1 {t.program} run {name} --out r --force --threads 1" for name in (first, second)]
        program = script(t, "two_decks", f"exec mpirun --oversubscribe {part[0]} : {part[1]}")
        begin = time.monotonic()
        done = with_program(t, program, t.run_program)
        expect_one_error(t, done, 2, "none.yaml: there is no such file")
        t.assertLess(time.monotonic() - begin, 10)
        t.assertEqual(processes_of(t, "r"), [])


@claim("ranks: without their library several processes end with one sentence that names the package to install, and one process needs none")
def _(t):
    launched(t, 2)
    alone = t.folder / "bin" / "perimpact"
    alone.parent.mkdir()
    shutil.copy(t.program, alone)
    deck = t.deck(*SHORT)
    program = script(t, "without", f'exec mpirun --oversubscribe -n 3 {alone} "$@"')
    done = with_program(t, program, lambda: t.run_program("run", deck, "--out", "r"))
    expect_one_error(t, done, 2, "a run of 3 processes needs libperimpact_ranks.so, which is not installed; install the package perimpact-mpi, or ")
    t.assertFalse((t.folder / "r").exists())
    program = script(t, "one", f'exec mpirun -n 1 {alone} "$@"')
    t.assertEqual(with_program(t, program, lambda: t.run_program("run", deck, "--out", "r")).code, 0)
    linked = subprocess.run(["ldd", t.program], capture_output=True, text=True, check=True).stdout
    t.assertNotIn("libmpi", linked)


@claim("ranks: --ranks 1 runs alone within mpirun, and another number than was started is refused")
def _(t):
    two = launched(t, 2)
    deck = t.deck(*SHORT)
    program = script(t, "apart", f'exec mpirun --oversubscribe -n 2 sh -c \'exec {t.program} run {deck} --ranks 1 --out r$OMPI_COMM_WORLD_RANK\'')
    t.assertEqual(with_program(t, program, t.run_program).code, 0)
    t.assertEqual(contents(t, "r0"), contents(t, "r1"))
    t.assertNotIn("ranks", t.report("r0"))
    done = with_program(t, two, lambda: t.run_program("run", deck, "--ranks", "3"))
    expect_one_error(t, done, 2, "--ranks 3: the number of processes started together is 2; use mpirun -n 3 perimpact run")


@claim("ranks: the library passes messages, sums and tables of any length between 1, 2 and 4 processes")
def _(t):
    launched(t, 2)
    program = Path(t.program).parent / "tests/ranks_mpi/ranks_mpi_processes"
    for ranks in 1, 2, 4:
        done = with_program(t, script(t, "calls", f"exec mpirun --oversubscribe -n {ranks} {program}"), t.run_program)
        t.assertEqual((done.code, done.out), (0, f"{ranks} ranks\n"), done)



@claim("ranks: the steps of a run send exactly the messages and bytes that check --ranks states, and its end states them with the imbalance")
def _(t):
    three = launched(t, 3)
    for material in "poissons_ratio: 0.25", "poissons_ratio: 0.3":
        deck = t.deck(*SHORT, ("poissons_ratio: 0.25", material))
        told = json.loads(t.expect_success("check", deck, "--ranks", "3", "--json").out)["ranks"]
        done = with_program(t, three, lambda: t.run_program("run", deck, "--out", "r", "--force", "--threads", "1", "--no-report"))
        t.assertEqual(done.code, 0, done)
        sent = t.report("r")["communication"]
        exchanges = 1 if material.endswith("0.25") else 2  # of positions and velocities; of the dilatation
        t.assertEqual(told["bodies"]["plate"]["largest_neighbours"], 2)
        t.assertEqual(told["messages"], 2 * exchanges)
        t.assertEqual(sent["messages"], 600 * 4 * exchanges)  # three boxes in a row
        t.assertEqual(sent["largest_sent [byte]"], 600 * told["sent [byte]"])
        t.assertGreater(sent["reductions"], 0)
        t.assertGreater(sent["waiting [s]"], 0)
        t.assertAlmostEqual(sent["imbalance"], sent["forces_largest [s]"] / sent["forces_mean [s]"], delta=1e-9)
        t.assertGreaterEqual(sent["imbalance"], 1)
        t.assertIn(f"\n3 ranks: the slowest took {sent['imbalance']:.2f} times the mean time in the phases of force; ", done.out)
        t.assertIn(f" MB sent in {sent['messages']} messages, ", done.out)
    t.expect_success("run", deck, "--out", "one", "--no-report")
    t.assertNotIn("communication", t.report("one"))


@claim("ranks: over TCP between two network namespaces, state and results are those of one process")
def _(t):
    launched(t, 2)
    deck = t.deck(*SHORT)
    t.expect_success("run", deck, "--out", "1")
    one, hosts = t.program, Path(__file__).resolve().parents[1] / "ranks_mpi/two_hosts.sh"
    done = with_program(t, str(hosts), lambda: t.run_program(one, "run", deck, "--out", "2", "--threads", "1"))
    if done.code == 77:
        raise unittest.SkipTest(done.err)
    t.assertEqual(done.code, 0, done)
    t.assertEqual(contents(t, "2"), contents(t, "1"))
    t.assertEqual(t.report("2")["state_hash"], t.report("1")["state_hash"])
    t.assertEqual(t.report("2")["ranks"], 2)


LARGE = """\
title: A bar
time: {end: 1 us, step: 0.5 us}
output: {frames: 0, folder: r, checkpoint_interval: 0}
bodies:
  bar:
    shape: {box: {size: [12.8, 0.24, 0.24]}}
    spacing: 0.01
    horizon_ratio: 2
    material: {model: correspondence, youngs_modulus: 1 GPa, poissons_ratio: 0.3, density: 1000}
"""


@claim("ranks: with a third of the memory that one process needs, a body of 737 280 particles is refused on one and runs on four")
def _(t):
    launched(t, 4)
    (t.folder / "large.yaml").write_text(LARGE)
    needed = json.loads(t.expect_success("check", "large.yaml", "--ranks", "1", "--json").out)["ranks"]["memory"]["peak [byte]"]
    limits = {resource.RLIMIT_DATA: int(needed / 3)}
    refused = t.run_program("run", "large.yaml", "--out", "one", "--threads", "1", limits=limits)
    t.assertEqual(refused.code, 2, refused)
    t.assertRegex(refused.err, rf"^error: large.yaml:7:14: with a spacing of 0.01 m for body bar the run needs {needed / 1e9:.3g} GB of memory, but ulimit -d allows ")
    four = launched(t, 4, "--mca mpi_yield_when_idle 1")
    done = with_program(t, four, lambda: t.run_program("run", "large.yaml", "--out", "four", "--threads", "1", "--no-report", limits=limits))
    t.assertEqual(done.code, 0, done)
    t.assertEqual(t.report("four")["outcome"], "finished")
    t.assertEqual(t.report("four")["bodies"]["bar"]["particles"], 737280)


main()
