"""Thinned output frames: which particles and fields they have, by independent readers and from the full frames, and what reads them."""

import unittest

from claims import MOVES, claim, main
from folders import contents
from reports import ReportFile

try:
    import h5py  # noqa: F401
    import numpy as np
    from vtkhdf_reader import ByOffsets, expect_same
    from vtp_reader import pictures
except ImportError as missing:
    ByOffsets, reason = None, str(missing)

BREAKS = ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.0001")
FIELDS = ["displacement", "velocity", "damage", "fragment"]
CELLS = (20, 12, 4)  # of the plate, numbered x fastest
SPACING = 0.005


def need_reader():
    if ByOffsets is None:
        raise unittest.SkipTest(reason)


def output(**keys):
    return [word for key, value in keys.items() for word in ("--set", f"output.{key}={value}")]


def run(t, folder, *settings):
    t.expect_success("run", t.deck(BREAKS), "--out", folder, "--no-report", "--force", "--set", "contact.fragments.law=none", *settings)


def frames(t, folder, name="plate"):
    return [picture for _, picture in pictures(t.folder / folder, name)]


def cells():
    """Cell of each particle."""
    return np.array([(k % CELLS[0], k // CELLS[0] % CELLS[1], k // (CELLS[0] * CELLS[1])) for k in range(CELLS[0] * CELLS[1] * CELLS[2])])


def centres():
    """[m] reference position of each particle."""
    return SPACING * (cells() - (np.array(CELLS) - 1) / 2)


def at_surface():
    return ((cells() == 0) | (cells() == np.array(CELLS) - 1)).any(axis=1)


#              selection                                                                  particles of a full frame
SELECTIONS = [
    ("{surface: true}", lambda frame: at_surface()),
    ("{stride: 3}", lambda frame: (cells() % 3 == 0).all(axis=1)),
    ("{damage_above: 0.2}", lambda frame: frame.point["damage"] > 0.2),
    ("{detached: true}", lambda frame: frame.point["fragment"] > 0),
    ("{boxes: {a: {lower: [-1, 0, -1], upper: [1, 1, 1]}}}", lambda frame: centres()[:, 1] >= 0),
    ("{boxes: {a: {lower: [-1, -1, -1], upper: [-0.04, 1, 1]}, b: {lower: [0.04, -1, -1], upper: [1, 1, 1]}}}", lambda frame: abs(centres()[:, 0]) >= 0.04),
    ("{damage_above: 0.2, detached: true, stride: 4, boxes: {a: {lower: [-1, 0, -1], upper: [1, 1, 1]}}}",
     lambda frame: (centres()[:, 1] >= 0) & ((frame.point["damage"] > np.float32(0.2)) | (frame.point["fragment"] > 0) | (cells() % 4 == 0).all(axis=1))),
    ("{surface: true, damage_above: 0}", lambda frame: at_surface() | (frame.point["damage"] > 0)),
]  # fmt: skip


def expect_part(t, found, whole, members, fields=FIELDS):
    """The frame is that part of the full one, bit by bit, with the fields, and numbers its particles."""
    numbers = np.flatnonzero(members)
    t.assertEqual(set(found.point), {*fields, "particle"})
    t.assertEqual(found.point["particle"].tolist(), numbers.tolist())
    t.assertEqual((found.time, found.points.tobytes()), (whole.time, whole.points[numbers].tobytes()))
    for field in fields:
        t.assertEqual(found.point[field].dtype, whole.point[field].dtype)
        t.assertEqual(found.point[field].tobytes(), whole.point[field][numbers].tobytes(), field)


@claim("thinned frames: each selection has the particles that meet it, of the full frames of the same run, with all fields bit by bit")
def _(t):
    need_reader()
    run(t, "whole")
    whole = frames(t, "whole")
    t.assertGreater(whole[-1].point["fragment"].max(), 0, "nothing broke off: this run does not show what it should")
    for selection, members in SELECTIONS:
        run(t, "r", *output(frame_particles=selection))
        found = frames(t, "r")
        t.assertEqual(len(found), len(whole))
        t.assertLess(len(found[-1].points), len(whole[-1].points))
        for part, full in zip(found, whole):
            expect_part(t, part, full, members(full))
        t.assertEqual(t.report("r")["state_hash"], t.report("whole")["state_hash"])


@claim("thinned frames: as VTKHDF they are those of the .vtp files, bit by bit, for each selection")
def _(t):
    need_reader()
    for selection, _ in SELECTIONS:
        run(t, "whole", *output(frame_particles=selection))
        run(t, "r", *output(frame_particles=selection, frame_format="vtkhdf"))
        series = ByOffsets(t.folder / "r/frames/plate.vtkhdf")
        wanted = frames(t, "whole")
        t.assertEqual(series.steps, len(wanted))
        for step, picture in enumerate(wanted):
            expect_same(series.step(step), picture)


@claim("thinned frames: frame_fields leaves out all other fields, in both formats, and positions stay")
def _(t):
    need_reader()
    run(t, "whole")
    for fields in (["damage"], ["velocity", "fragment"], []):
        for form in "vtp", "vtkhdf":
            run(t, "r", *output(frame_fields="[" + ", ".join(fields) + "]", frame_format=form))
            series = ByOffsets(t.folder / "r/frames/plate.vtkhdf") if form == "vtkhdf" else None
            for step, full in enumerate(frames(t, "whole")):
                found = series.step(step) if series else frames(t, "r")[step]
                t.assertEqual(set(found.point), set(fields))
                t.assertEqual(found.points.tobytes(), full.points.tobytes())
                for field in fields:
                    t.assertEqual(found.point[field].tobytes(), full.point[field].tobytes())


@claim("thinned frames: of a body from a file of particles the stride writes as large a share, and the rows of the file are theirs")
def _(t):
    need_reader()
    rows = "".join(f"{5 * i + 2.5 - 50}, {5 * j + 2.5 - 30}, {5 * k + 2.5 - 10}, 0.125\n" for i in range(20) for j in range(12) for k in range(4))
    (t.folder / "cloud.csv").write_text("x [mm], y [mm], z [mm], volume [cm3]\n" + rows)
    deck = t.deck(("shape: {box: {size: [100 mm, 60 mm, 20 mm]}}", "shape: {points: {file: cloud.csv}}"), ("    spacing: 5 mm\n", ""))
    t.expect_success("run", deck, "--out", "whole", "--no-report")
    t.expect_success("run", deck, "--out", "r", "--no-report", *output(frame_particles="{stride: 2}"))
    for part, full in zip(frames(t, "r"), frames(t, "whole"), strict=True):
        expect_part(t, part, full, np.arange(960) % 8 == 0, ["displacement", "velocity", "damage", "original"])


@claim("thinned frames: a run that is prolonged from its checkpoint has the frames of an uninterrupted one, in both formats")
def _(t):
    time = "--set", "time.step=0.05 us"
    for form in "vtp", "vtkhdf":
        thinned = output(frame_particles="{damage_above: 0.1, stride: 4}", frame_fields="[damage]", frame_format=form)
        run(t, "whole", *thinned, *time)
        run(t, "r", *thinned, *time, "--set", "time.end=10 us", "--set", "output.frames=2")
        t.expect_success("run", t.deck(BREAKS), "--out", "r", "--no-report", "--resume", "--set", "contact.fragments.law=none", *thinned, *time)
        if form == "vtp":
            t.assertEqual({name: text for name, text in contents(t, "r").items() if name.startswith("frames/")},
                          {name: text for name, text in contents(t, "whole").items() if name.startswith("frames/")})  # fmt: skip
        else:
            need_reader()
            found, wanted = (ByOffsets(t.folder / folder / "frames/plate.vtkhdf") for folder in ("r", "whole"))
            t.assertEqual((found.steps, wanted.steps), (5, 5))
            for step in range(5):
                expect_same(found.step(step), wanted.step(step))


@claim("thinned frames: the report shows each particle in the frames that have it, and says that they are thinned")
def _(t):
    need_reader()
    for form in "vtp", "vtkhdf":
        run(t, "whole", *output(frame_particles="{damage_above: 0.2, stride: 4}"))
        run(t, "r", *output(frame_particles="{damage_above: 0.2, stride: 4}", frame_format=form))
        t.expect_success("report", "r")
        report = ReportFile(t.folder / "r/report.html")
        body, places, shown = report.body("plate")
        known = {}  # index in the report by particle
        for picture in frames(t, "whole"):
            for number in picture.point["particle"]:
                known.setdefault(int(number), len(known))
        t.assertEqual((body["particles"], body["shown"]), (len(known), len(known)))
        t.assertEqual(report.notes, [f"The frames of plate are thinned by output.frame_particles: up to {len(known)} of its 960 particles were written, each in the "
                                     "frames in which it meets the selection."])  # fmt: skip
        step = {array["name"]: array["step"] for array in body["arrays"]}
        for found, picture in zip(shown, frames(t, "whole"), strict=True):
            rows = [known[int(number)] for number in picture.point["particle"]]
            t.assertEqual(sorted(k for k, is_written in enumerate(found["is_written"]) if is_written), sorted(rows))
            for row, index in enumerate(rows):
                t.assertLessEqual(abs(found["damage"][index] - picture.point["damage"][row]), step["damage"])
                for axis in range(3):
                    # two quantised numbers, each within half a step
                    name = f"displacement_{'xyz'[axis]}"
                    t.assertLessEqual(abs(found[name][index] + places[axis][index] - picture.points[row][axis]), step[name] + body["undeformed"][axis]["step"])


@claim("thinned frames: without fields the report has the displacements all the same, and says in sentences what it lacks")
def _(t):
    need_reader()
    run(t, "whole")
    run(t, "r", *output(frame_fields="[]"))
    t.expect_success("report", "r")
    report = ReportFile(t.folder / "r/report.html")
    body, _, shown = report.body("plate")
    t.assertEqual([array["name"] for array in body["arrays"]], ["displacement_x", "displacement_y", "displacement_z"])
    t.assertEqual(report.notes, ["The frames of plate have no field displacement (output.frame_fields), so its displacements are from the first frame of each particle on.",
                                 "The frames of plate have no field velocity (output.frame_fields), so its speed is not shown.",
                                 "The frames of plate have no field damage (output.frame_fields), so its damage is not shown."])  # fmt: skip
    step = {array["name"]: array["step"] for array in body["arrays"]}
    rounding = 2 * 0.05 * 2**-23  # [m] two positions of up to 50 mm in single precision
    for found, picture in zip(shown, frames(t, "whole"), strict=True):
        for axis in range(3):
            name = f"displacement_{'xyz'[axis]}"
            t.assertLessEqual(np.abs(np.array(found[name]) - picture.point["displacement"][:, axis]).max(), step[name] + rounding)
    t.assertIn('("plate", ".pvd", 0.005, None)', (t.folder / "r/open_in_paraview.py").read_text())


@claim("thinned frames: the channel width is refused in a sentence where particles or fragments are missing")
def _(t):
    run(t, "r", *output(frame_particles="{stride: 2}"))
    t.expect_complaint(t.run_program("statistics", "r", "--channel", "plate:x"), 2, "r/frames/plate_00004.vtp has a part of the particles only", "without output.frame_particles")
    run(t, "r", *output(frame_fields="[damage]"))
    t.expect_complaint(t.run_program("statistics", "r", "--channel", "plate:x"), 2, "r/frames/plate_00004.vtp has no field fragment", "output.frame_fields")


@claim("thinned frames: unknown fields and selections without particles are refused at their position in the deck")
def _(t):
    def refused(line, *words, at):
        deck = t.deck(("  frames: 4", "  frames: 4\n  " + line))
        for command in "check", "run":
            t.expect_complaint(t.run_program(command, deck), 2, f"deck.yaml:20:{at}", *words)
        t.assertEqual(t.files("results"), [])

    refused("frame_fields: [damage, speed]", 'frame_fields contains "speed", which is not a field of the particles; known here:', at=17)
    refused("frame_fields: [damage, damage]", "frame_fields contains damage twice; keep one.", at=17)
    refused("frame_particles: {}", "frame_particles gives no selection; set surface, stride, damage_above, detached or boxes", at=3)
    refused("frame_particles: {boxes: {a: {lower: [0, 0, 0], upper: [1, 0, 1]}}}", "upper is 0 m along y, but lower is 0 m, so the box a is empty", at=58)
    refused("frame_particles: {boxes: {a: {lower: [1, 1, 1], upper: [2, 2, 2]}}}", "box a contains no particle of any body", at=29)
    refused("frame_particles: {stride: 1}", "stride is 1", at=29)


@claim("thinned frames: of a body with a moving window they are refused, as are frames without its displacement")
def _(t):
    deck = t.deck(*MOVES)
    t.expect_complaint(t.run_program("run", deck, *output(frame_particles="{stride: 2}")), 2, "--set output.frame_particles: frame_particles is given, but the particles of plate change with its moving window")
    t.expect_complaint(t.run_program("run", deck, *output(frame_fields="[damage]")), 2, "--set output.frame_fields: frame_fields lacks displacement, but plate has a moving window")
    t.assertEqual(t.files("results"), [])
    t.expect_success("run", deck, *output(frame_fields="[displacement]"))


main()
