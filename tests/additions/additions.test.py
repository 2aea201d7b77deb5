"""What the developer guide says about adding things, done: the program that results runs decks that use all of them. Compiles the solver once more.

    additions.test.py REPOSITORY ["the sentence"]

PERIMPACT_ADDITIONS names a folder that is kept: a second run then compiles what has changed alone.
"""

import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402
from steps import grown_tree  # noqa: E402


def build(folder):
    tree, binary = grown_tree(folder), folder / "build"
    cache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    # not optimised: what counts is that it compiles, and what it computes
    options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG", "-DPERIMPACT_TESTS=OFF", "-DPERIMPACT_GROUPED=ON"]
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
    for command in (["cmake", "-S", tree, "-B", binary, *options, *cache], ["cmake", "--build", binary, "--target", "perimpact", "-j", jobs]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert done.returncode == 0, done.stdout[-8000:]
    return binary / "perimpact"


def run(program, deck, folder):
    (folder / "deck.yaml").write_text(deck)
    return subprocess.run([program, "run", "deck.yaml", "--out", "results", "--force", "--no-report", "--threads", "1"], cwd=folder, capture_output=True, text=True)


def results(program, deck, folder):
    done = run(program, deck, folder)
    assert done.returncode == 0, done.stdout + done.stderr
    with open(folder / "results/history.csv", newline="") as file:
        rows = [{key.strip(): float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    return rows, json.loads((folder / "results/run.json").read_text())


def expect(value, wanted, tolerance, what):
    assert abs(value - wanted) <= tolerance * abs(wanted), f"{what} is {value}, not {wanted} within {tolerance}"


E_MODULUS, DENSITY, SPACING = 2e9, 1000.0, 0.01
BAR = f"""\
  bar:
    shape: {{box: {{size: [30 cm, 6 cm, 6 cm]}}}}
    spacing: {SPACING} m
    material: {{model: gaussian-bond, youngs_modulus: {E_MODULUS} Pa, density: {DENSITY} kg/m3}}
"""

# two cubes approach the long sides of the bar, whose contact bounds contain the one, and all but the struck side of the other
STRUCK = f"""\
time: {{end: 0.4 ms}}
bodies:
{BAR}    boundary_conditions:
      push: {{ramp: {{force_density: [1e6, 0, 0], duration: 0.2 ms}}}}
impactors:
  felt:
    surface: {{file: cube.tri}}
    density: 3000 kg/m3
    position: [0, 5.6 cm, 0]
    velocity: [0, -4 m/s, 0]
    contact_bounds: {{ball: {{radius: 5 cm}}}}
  ignored:
    surface: {{file: cube.tri}}
    density: 3000 kg/m3
    position: [0, -5.6 cm, 0]
    velocity: [0, 4 m/s, 0]
    contact_bounds: {{ball: {{centre: [0, -10 cm, 0], radius: 9 cm}}, on_exceed: clip}}
output: {{frames: 0, history_interval: 0.1 ms}}
"""

STRESS = 1e5
PULLED = f"""\
time: {{end: 1, relax: {{tolerance: 1e-8}}}}
bodies:
{BAR}    particle_sets:
      left: {{shape: {{box: {{size: [3 cm, 7 cm, 7 cm]}}}}, position: [-13.5 cm, 0, 0]}}
    boundary_conditions:
      grip: {{fixed: {{particle_set: left}}}}
      pull: {{pressure: {{face: +x, value: {-STRESS}}}}}
output:
  frames: 0
  probes:
    near: {{body: bar, at: [-2 cm, 0, 0]}}
    far: {{body: bar, at: [8 cm, 0, 0]}}
"""


def cube(side):
    """Twelve triangles, outward."""
    triangles = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (1, -1):
            corners = []
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = [0.0] * 3
                corner[axis], corner[u], corner[v] = sign * side / 2, a * side / 2, b * side / 2
                corners.append(corner)
            corners = corners if sign > 0 else corners[::-1]
            triangles += [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]
    return "\n".join(" ".join(f"{x!r}" for corner in triangle for x in corner) for triangle in triangles) + "\n"


def check_struck(program, folder):
    side = 0.05
    (folder / "cube.tri").write_text(cube(side))
    rows, report = results(program, STRUCK, folder)
    volume = 0.3 * 0.06 * 0.06
    # reader: mass from the enclosed volume; column: particles of the lattice; both to rounding
    expect(report["impactors"]["felt"]["mass [kg]"], 3000 * side**3, 1e-12, "mass of the cube")
    expect(rows[-1]["bar.particles [-]"], volume / SPACING**3, 1e-12, "number of particles")
    # boundary condition: each step takes the force at its beginning, so that the mean of N steps on the ramp is that of the arithmetic series
    dt = rows[-1]["time [s]"] / report["steps"]
    count = round(rows[1]["time [s]"] / dt)
    expect(rows[1]["bar.push.force_x [N]"], 1e6 * volume * (count - 1) / 2 * dt / 2e-4, 1e-9, "force on the ramp")
    expect(rows[-1]["bar.push.force_x [N]"], 1e6 * volume, 1e-12, "force after the ramp")
    # contact bounds: the volume, widened by 1e-8 of the size of the surface; contact inside alone
    bounds = report["impactors"]["felt"]["contact_bounds"]
    assert bounds["kind"] == "ball" and not bounds["clips"], bounds
    expect(bounds["volume [m3]"], 4 * math.pi / 3 * 0.05**3, 1e-6, "volume of the ball")
    expect(bounds["radius [m]"], 0.05, 1e-6, "radius in the report")
    assert report["impactors"]["ignored"]["contact_bounds"]["clips"]
    assert rows[-1]["felt.contacts [-]"] > 0 and rows[-1]["felt.contact_work [J]"] < -1, "the cube within its bounds met nothing"
    assert all(row["ignored.contacts [-]"] == 0 for row in rows), "the cube whose struck side lies outside its bounds met something"


def check_pulled(program, folder):
    rows, _ = results(program, PULLED, folder)
    strain = (rows[-1]["far.displacement_x [m]"] - rows[-1]["near.displacement_x [m]"]) / 0.1
    # the surface correction of a bar of six particles leaves it up to 2 % too stiff or soft
    expect(strain, STRESS / E_MODULUS, 0.02, "strain of the bar in uniaxial tension")
    expect(rows[-1]["bar.grip.force_x [N]"], -STRESS * 0.06**2, 1e-6, "reaction")  # the relaxation stops at 1e-8


def check_refusals(program, folder):
    for old, new, sentence in (
        ("    spacing: 0.01 m\n", "    spacing: 0.01 m\n    horizon_ratio: 2.5\n", "horizon_ratio is below 3"),
        ("force_density: [1e6, 0, 0]", "force_density: [0, 0, 0]", "force_density is [0, 0, 0]"),
        ("{ball: {radius: 5 cm}}", "{ball: {radius: 2000 km}}", "radius is above 1e6 m"),
        ("{ball: {radius: 5 cm}}", "{ball: {radius: 1 cm}}", "extend beyond the ball"),
        ("gaussian-bond", "gaussian-bnd", "gaussian-bond"),
    ):
        assert STRUCK.count(old) == 1, old
        done = run(program, STRUCK.replace(old, new), folder)
        assert done.returncode == 2 and sentence in done.stderr and re.search(r"deck\.yaml:\d+:\d+: ", done.stderr), (done.returncode, done.stderr)
    damaged = folder / "cube.tri"
    damaged.write_text(damaged.read_text().replace("0.025", "x", 1))
    done = run(program, STRUCK, folder)
    assert done.returncode == 2 and "cube.tri:1: " in done.stderr, done.stderr


@claim("a material, a boundary condition, contact bounds, a reader and a column, added as the guide says, build, run and give exact results")
def additions(t):
    folder = Path(os.environ.get("PERIMPACT_ADDITIONS", t.folder))
    folder.mkdir(parents=True, exist_ok=True)
    program = build(folder)
    check_struck(program, t.folder)
    check_pulled(program, t.folder)
    check_refusals(program, t.folder)


main()
