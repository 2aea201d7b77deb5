"""perimpact check: the memory that it names is what a run then takes."""

import contextlib
import json
import os
import random
import re
import resource
import shutil
import subprocess
import time
from pathlib import Path

from claims import claim, main

MATERIAL = {
    "elastic": "model: bond-based, youngs_modulus: 1 GPa, density: 1000",
    "brittle": "model: bond-based, youngs_modulus: 1 GPa, density: 1000, critical_stretch: 0.01",
    "state": "model: ordinary-state, youngs_modulus: 1 GPa, poissons_ratio: 0.3, density: 1000",
    "correspondence": "model: correspondence, youngs_modulus: 1 GPa, poissons_ratio: 0.3, density: 1000",
}


def deck(t, shape, material, contact=""):
    text = (f"title: Memory\ntime: {{end: 1 us, step: 0.5 us}}\noutput: {{frames: 1, folder: r}}\n"
            f"bodies: {{b: {{{shape}, material: {{{MATERIAL[material]}}}}}}}\n"
            "impactors: {s: {surface: {box: {size: [0.1, 0.1, 0.1], edge_length: 0.02}}, mass: 1, position: [0, 0, 100]}}\n" + contact)
    (t.folder / "deck.yaml").write_text(text)
    return "deck.yaml"


def box(x, y, z):
    return f"shape: {{box: {{size: [{x / 100}, {y / 100}, {z / 100}]}}}}, spacing: 0.01"


def points(t, x, y, z):
    """A cubic grid with every point moved by up to a fifth of its spacing."""
    chance = random.Random(1)
    with open(t.folder / "points.csv", "w") as file:
        file.write("x [m],y [m],z [m],volume [m3]\n")
        for k in range(x * y * z):
            cell = (k % x, k // x % y, k // (x * y))
            file.write(",".join(f"{0.01 * (c + chance.uniform(-0.2, 0.2)):.6g}" for c in cell) + ",1e-6\n")
    return "shape: {points: {file: points.csv}}"


def measured(t, name):
    """[byte] VmHWM of a run"""
    with subprocess.Popen([t.program, "run", name, "--threads", "2", "--force"], cwd=t.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        said = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    t.assertEqual((process.returncode, said), (0, b""))
    return 1024 * usage.ru_maxrss


def windowed(t):
    """The body of the deck is a window that follows the impactor, by eight spacings in a step."""
    text = (t.folder / "deck.yaml").read_text()
    changed = text.replace("material:", "moving_window: {follow: s, start_after: 0 m}, material:", 1).replace("mass: 1,", "mass: 1, velocity: [1.7e5, 0, 0],", 1)
    (t.folder / "deck.yaml").write_text(changed)
    return "deck.yaml"


def expect_near(t, name):
    said = re.search(r"\n  peak +about ([\d.]+) (MB|GB): ", t.expect_success("check", name).out)
    estimate, peak = float(said[1]) * {"MB": 1e6, "GB": 1e9}[said[2]], measured(t, name)
    t.assertLess(abs(estimate / peak - 1), 0.2, f"said {estimate / 1e6:.0f} MB, taken {peak / 1e6:.0f} MB")


@claim("memory: check estimates the peak of a run on a lattice within 20 %, thick and thin")
def _(t):
    expect_near(t, deck(t, box(60, 50, 34), "elastic"))
    expect_near(t, deck(t, box(160, 160, 5), "state"))


@claim("memory: check estimates the peak of a run whose window moves within 20 %")
def _(t):
    deck(t, box(160, 160, 8), "brittle")
    still = measured(t, "deck.yaml")
    expect_near(t, windowed(t))
    t.assertGreater(measured(t, "deck.yaml"), 1.3 * still)  # it has moved


@claim("memory: check estimates the peak of a body that fills a surface within 20 %")
def _(t):
    t.expect_success("shape", "sphere", "--diameter", "0.5", "--edge-length", "0.02", "--out", "ball.stl")
    expect_near(t, deck(t, "shape: {file: ball.stl}, spacing: 0.01", "brittle"))


@claim("memory: check estimates the peak of a run with fragments within 20 %, as long as few bonds break")
def _(t):
    fragments = "contact: {fragments: {law: repulsive}}\n"
    expect_near(t, deck(t, box(60, 50, 34), "brittle", fragments))
    expect_near(t, deck(t, box(240, 200, 3) + ", horizon_ratio: 2.015", "brittle", fragments))  # a sheet of ice has half of its memory in them


def expect_rubble_near(t, friction):
    """A stretch below rounding breaks the bonds of a body that flies; the impactor causes the list to be rebuilt while all are loose."""
    (t.folder / "deck.yaml").write_text(f"""title: Rubble
time: {{end: 10 us, step: 0.5 us}}
output: {{frames: 1, folder: r}}
bodies: {{b: {{{box(40, 40, 40)}, velocity: [1, 2, 3], material: {{{MATERIAL["elastic"]}, critical_stretch: 1e-18}}, failure: {{compression: symmetric}}}}}}
impactors: {{s: {{surface: {{box: {{size: [0.1, 0.1, 0.1], edge_length: 0.02}}}}, mass: 1, position: [0, 0, 0.2501], velocity: [0, 0, -1000]}}}}
contact: {{fragments: {{law: repulsive, friction: {friction}}}}}
""")
    said = t.expect_success("check", "deck.yaml").out
    peak, rubble = (float(value) * {"MB": 1e6, "GB": 1e9}[unit]
                    for value, unit in (re.search(words, said).groups() for words in (r"peak +about ([\d.]+) (MB|GB)", r"fragments +up to ([\d.]+) (MB|GB) more")))
    taken = measured(t, "deck.yaml")
    t.assertLess(abs((peak + rubble) / taken - 1), 0.2, f"said {peak / 1e6:.0f} and {rubble / 1e6:.0f} MB more, taken {taken / 1e6:.0f} MB")


@claim("memory: check estimates the additional memory of rubble within 20 %, with and without friction")
def _(t):
    expect_rubble_near(t, 0)
    expect_rubble_near(t, 0.1)


@claim("memory: check estimates the peak of a correspondence material within 20 %")
def _(t):
    expect_near(t, deck(t, box(40, 30, 16), "correspondence"))


@claim("memory: check estimates the peak of a point cloud within 20 %, at rest and during set-up")
def _(t):
    expect_near(t, deck(t, points(t, 30, 25, 16), "brittle"))
    expect_near(t, deck(t, points(t, 30, 25, 16), "state"))
    expect_near(t, deck(t, points(t, 30, 25, 16), "correspondence"))


PLATE = "shape: {box: {size: [1, 1, 1]}}, spacing: 0.01"


@claim("memory: a limit of ulimit is respected: the run is refused in a sentence that names it, before memory is allocated and a folder is made")
def _(t):
    deck(t, PLATE, "state")
    for limit, option in (resource.RLIMIT_AS, "-v"), (resource.RLIMIT_DATA, "-d"):
        done = t.run_program("run", "deck.yaml", "--threads", "2", limits={limit: 200_000_000})
        t.expect_complaint(done, 2, "deck.yaml:4:", "the run needs 0.2", f"ulimit {option} allows 0.2 GB", "use a spacing of at least", "a smaller body, or a higher limit")
        t.assertEqual(t.files("r"), [])


@claim("memory: a surface of a million panels counts towards a limit of ulimit, which refuses it before its searches are built, and the bodies beside it")
def _(t):
    deck(t, box(20, 20, 20), "state")
    text = (t.folder / "deck.yaml").read_text()
    (t.folder / "deck.yaml").write_text(text.replace("surface: {box: {size: [0.1, 0.1, 0.1], edge_length: 0.02}}", "surface: {sphere: {diameter: 0.2, edge_length: 0.0006}}"))
    done = t.run_program("run", "deck.yaml", "--threads", "2", "--no-report", limits={resource.RLIMIT_AS: 600_000_000})
    t.expect_complaint(done, 2, "deck.yaml:5:", "impactor s", "the run needs 0.8", "ulimit -v allows 0.6 GB", "use larger panels, or a higher limit")
    t.assertEqual(t.files("r"), [])


@claim("memory: a run below the limit of ulimit finishes")
def _(t):
    deck(t, box(20, 20, 20), "state")
    done = t.run_program("run", "deck.yaml", "--threads", "2", "--no-report", limits={resource.RLIMIT_AS: 1_000_000_000})
    t.assertEqual((done.code, done.err), (0, ""))


def root_of_groups():
    """Folder of the control groups of memory and its file of limits, or neither where they cannot be made: for root alone, unless they are delegated."""
    version_1, version_2 = Path("/sys/fs/cgroup/memory"), Path("/sys/fs/cgroup")
    if os.access(version_1, os.W_OK) and (version_1 / "memory.limit_in_bytes").exists():
        return version_1, "memory.limit_in_bytes"
    controllers = version_2 / "cgroup.subtree_control"
    if os.access(version_2, os.W_OK) and controllers.exists() and "memory" in controllers.read_text().split():
        return version_2, "memory.max"
    return None, None


@contextlib.contextmanager
def control_group(t, limit):
    """The words before a command that start it in a control group of this limit [byte]: one of systemd, or else one made by hand."""
    of_systemd = ["systemd-run", "--user", "--scope", "--quiet", "-p", f"MemoryMax={limit}"]
    if shutil.which(of_systemd[0]) and subprocess.run([*of_systemd, "true"], capture_output=True).returncode == 0:
        yield of_systemd
        return
    root, limit_file = root_of_groups()
    group = root and root / f"perimpact_test_{os.getpid()}"
    try:
        if not group:
            raise OSError
        group.mkdir()
    except OSError:
        t.skipTest("control groups cannot be made here")
    try:
        (group / limit_file).write_text(str(limit))
        yield ["sh", "-c", 'echo $$ > "$0" && exec "$@"', str(group / "cgroup.procs")]
    finally:
        wait_until(lambda: not (group / "cgroup.procs").read_text())
        group.rmdir()


def wait_until(is_so):
    """A control group is empty shortly after its last process has been waited for."""
    for _ in range(100):
        if is_so():
            return
        time.sleep(0.05)


@claim("memory: a run whose rubble does not fit below the limit of ulimit ends with a sentence that names the step, wherever memory lacks")
def _(t):
    text = (f"title: Rubble\ntime: {{end: 60 us, step: 0.5 us}}\noutput: {{frames: 1, folder: r}}\nbodies: {{b: {{{box(40, 40, 40)}, "
            f"material: {{{MATERIAL['elastic']}, critical_stretch: 1e-8}}, failure: {{compression: symmetric}}}}}}\n"
            "impactors: {s: {surface: {box: {size: [0.1, 0.1, 0.1], edge_length: 0.02}}, mass: 1, position: [0, 0, 0.2501], velocity: [0, 0, -1000]}}\n"
            "contact: {fragments: {law: repulsive, friction: 0.1}}\n")  # fmt: skip
    (t.folder / "deck.yaml").write_text(text)
    failed = 0
    for limit in range(170, 300, 20):
        done = t.run_program("run", "deck.yaml", "--threads", "2", "--no-report", "--force", limits={resource.RLIMIT_AS: limit * 10**6})
        if done.code != 0:
            t.expect_complaint(done, 3, "After step ", "there is not enough memory; use a machine with more of it, or a larger spacing.")
            failed += 1
    t.assertGreater(failed, 2)


@claim("memory: a run that needs 500 MB in a control group of 300 MB is refused in a sentence")
def _(t):
    with control_group(t, 300 * 2**20) as group:
        deck(t, box(112, 112, 112), "state", "contact: {fragments: {law: repulsive}}\n")
        done = subprocess.run([*group, t.program, "run", "deck.yaml", "--threads", "2"], cwd=t.folder, capture_output=True, text=True)
        t.assertEqual(done.returncode, 2, done.stdout)
        needed = re.search(r"the run needs ([\d.]+) GB", done.stderr)
        t.assertIsNotNone(needed, done.stderr)
        t.assertAlmostEqual(float(needed[1]), 0.5, delta=0.1, msg="the size of the box belongs to the title")
        t.assertIn("the control group of this process allows 0.315 GB", done.stderr)
        t.assertEqual(t.files("r"), [])


@claim("memory: a run that its control group of 300 MB has room for finishes in it")
def _(t):
    with control_group(t, 300 * 2**20) as group:
        deck(t, box(20, 20, 20), "state")
        done = subprocess.run([*group, t.program, "run", "deck.yaml", "--threads", "2"], cwd=t.folder, capture_output=True, text=True)
        t.assertEqual((done.returncode, done.stderr), (0, ""))


@claim("memory: check of a hundred million particles answers within 10 s, in less memory than a hundredth of the body")
def _(t):
    deck(t, "shape: {box: {size: [4.64, 4.64, 4.64]}}, spacing: 0.01", "elastic")
    begin = time.monotonic()
    with subprocess.Popen([t.program, "check", "deck.yaml", "--threads", "2"], cwd=t.folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        said = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    t.assertIn("  particles         99897344 (464 x 464 x 464 cells of 0.01 m)\n", said)
    t.assertIn("The bodies are not built", said)
    t.assertIn(process.returncode, (0, 2))  # the machine may be too small for it
    t.assertLess(usage.ru_utime + usage.ru_stime, 2 * 10)  # of two threads: the machine may be busy
    t.assertLess(time.monotonic() - begin, 60)
    t.assertLess(1024 * usage.ru_maxrss, 200e6)  # mostly the block of its material


@claim("memory: check --json of a large body has the counts of the text, and says that they are estimates")
def _(t):
    deck(t, "shape: {box: {size: [4.64, 4.64, 4.64]}}, spacing: 0.01", "elastic")
    said, as_json = t.run_program("check", "deck.yaml").out, json.loads(t.run_program("check", "deck.yaml", "--json").out)
    (body,) = as_json["bodies"].values()
    t.assertEqual((as_json["is_estimate"], body["particles"], body["spacing [m]"]), (True, 464**3, 0.01))
    t.assertEqual(f"{body['mass [kg]']:.5g}", re.search(r"\n  mass +(\S+) kg", said)[1])
    t.assertAlmostEqual(as_json["memory"]["peak [byte]"] / 1e9, float(re.search(r"\n  peak +about ([\d.]+) GB", said)[1]), delta=0.05)  # one digit


@claim("memory: the step that check reports for a large body is that of the body, within 2 %")
def _(t):
    def step(shape):
        deck(t, shape, "state")
        text = (t.folder / "deck.yaml").read_text().replace(", step: 0.5 us", "").replace("1 us", "1 ms")
        (t.folder / "deck.yaml").write_text(text)
        return float(re.search(r"\n  step +(?:about )?([\d.e-]+) s", t.run_program("check", "deck.yaml").out)[1])

    t.assertLess(abs(step(box(300, 200, 200)) / step(box(40, 60, 50)) - 1), 0.02)


@claim("memory: the step that check forecasts for several ranks is that of the body, within 5 %, also of calibrated layers in a moving window")
def _(t):
    deck(t, box(80, 60, 4) + ", bending_calibration: z", "brittle")
    windowed(t)
    text = (t.folder / "deck.yaml").read_text().replace(", step: 0.5 us", "").replace("1 us", "1 ms")
    (t.folder / "deck.yaml").write_text(text)
    one, many = (float(re.search(r"\n  step +(?:about )?([\d.e-]+) s", t.expect_success("check", "deck.yaml", *ranks).out)[1]) for ranks in ((), ("--ranks", "2")))
    t.assertLess(abs(many / one - 1), 0.05)  # of a block: layers near a surface are softer. Without the calibration it would be 8 % longer


main()
