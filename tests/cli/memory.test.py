"""perimpact check: the memory that it names is what a run then takes."""

import os
import random
import re
import subprocess

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


def expect_near(t, name):
    said = re.search(r"\n  peak +about ([\d.]+) (MB|GB): ", t.expect_success("check", name).out)
    estimate, peak = float(said[1]) * {"MB": 1e6, "GB": 1e9}[said[2]], measured(t, name)
    t.assertLess(abs(estimate / peak - 1), 0.2, f"said {estimate / 1e6:.0f} MB, taken {peak / 1e6:.0f} MB")


@claim("memory: check estimates the peak of a run on a lattice within 20 %, thick and thin")
def _(t):
    expect_near(t, deck(t, box(60, 50, 34), "elastic"))
    expect_near(t, deck(t, box(160, 160, 5), "state"))


@claim("memory: check estimates the peak of a body that fills a surface within 20 %")
def _(t):
    t.expect_success("shape", "sphere", "--diameter", "0.5", "--edge-length", "0.02", "--out", "ball.stl")
    expect_near(t, deck(t, "shape: {file: ball.stl}, spacing: 0.01", "brittle"))


@claim("memory: check estimates the peak of a run with fragments within 20 %, as long as few bonds break")
def _(t):
    expect_near(t, deck(t, box(60, 50, 34), "brittle", "contact: {fragments: {law: repulsive}}\n"))


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


main()
