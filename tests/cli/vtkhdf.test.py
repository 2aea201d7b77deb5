"""Output frames as VTKHDF: the same numbers as in .vtp files, read by h5py and, from version 9.3 on, by VTK."""

import random
import re
import resource
import shutil
import signal
import time
import unittest

from claims import claim, main
from folders import SHORT, ended, started
from reports import ReportFile

try:
    import h5py  # noqa: F401
    from vtkhdf_reader import ByOffsets, WithVtk, expect_same
    from vtp_reader import pictures
except ImportError as missing:
    ByOffsets, reason = None, str(missing)

VTKHDF = "--set", "output.frame_format=vtkhdf"
BREAKS = ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002")
NAMES = "plate", "cylinder"


def need_reader():
    if ByOffsets is None:
        raise unittest.SkipTest(reason)


def vtk_reads_series():
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
        from vtkmodules.vtkIOHDF import vtkHDFReader  # noqa: F401
    except ImportError:
        return False
    return (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) >= (9, 3)


def expect_frames(t, folder, whole, most=None):
    """The steps of both series are the .vtp frames of the run `whole`, all of them or the first ones; their number."""
    counts = []
    for name in NAMES:
        wanted = [picture for _, picture in pictures(t.folder / whole, name)]
        for reader in [ByOffsets] + [WithVtk] * vtk_reads_series():
            series = reader(t.folder / folder / f"frames/{name}.vtkhdf")
            t.assertLessEqual(series.steps, len(wanted))
            for step in range(series.steps):
                expect_same(series.step(step), wanted[step])
        counts.append(series.steps)
        if most is None:
            t.assertEqual(series.steps, len(wanted))
    return counts


@claim("vtkhdf: every number of every frame is that of the .vtp files of the same run, bit by bit, by h5py and by VTK from 9.3 on")
def _(t):
    need_reader()
    for changes in ((), (BREAKS,), (("detector: swept", "detector: analytic"),)):
        deck = t.deck(*changes)
        t.expect_success("run", deck, "--out", "whole", "--force")
        t.expect_success("run", deck, "--out", "r", "--force", *VTKHDF)
        t.assertEqual(expect_frames(t, "r", "whole"), [5, 5])
        t.assertEqual(t.report("r")["state_hash"], t.report("whole")["state_hash"])
        t.assertEqual(t.report("r")["setup"]["output"]["frame_format"], "vtkhdf")


@claim("vtkhdf: the rows of a body from a file of particles are stored once and are those of the .vtp files")
def _(t):
    need_reader()
    rows = "".join(f"{5 * i + 2.5 - 50}, {5 * j + 2.5 - 30}, {5 * k + 2.5 - 10}, 0.125\n" for i in range(20) for j in range(12) for k in range(4))
    (t.folder / "cloud.csv").write_text("x [mm], y [mm], z [mm], volume [cm3]\n" + rows)
    deck = t.deck(("shape: {box: {size: [100 mm, 60 mm, 20 mm]}}", "shape: {points: {file: cloud.csv}}"), ("    spacing: 5 mm\n", ""))
    t.expect_success("run", deck, "--out", "whole")
    t.expect_success("run", deck, "--out", "r", *VTKHDF)
    expect_frames(t, "r", "whole")
    series = ByOffsets(t.folder / "r/frames/plate.vtkhdf")
    t.assertIn("original", series.step(4).point)
    t.assertEqual(len(series.root["PointData/original"]), 960)
    t.assertEqual(len(series.root["PointData/damage"]), 5 * 960)


@claim("vtkhdf: files.txt lists a file for each series, and a run that replaces it in the other format leaves none of them")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r", *VTKHDF)
    t.assertEqual([name for name in t.files("r") if name.startswith("frames/")], ["frames/cylinder.vtkhdf", "frames/plate.vtkhdf"])
    listed = (t.folder / "r/files.txt").read_text().splitlines()
    t.assertTrue({"frames/cylinder.vtkhdf", "frames/plate.vtkhdf"} <= set(listed))
    t.assertNotIn(".vtp", "".join(listed))
    t.expect_success("run", "deck.yaml", "--out", "r", "--force")
    t.assertNotIn(".vtkhdf", "".join(t.files("r")))
    t.expect_success("run", "deck.yaml", "--out", "r", "--force", *VTKHDF)
    t.assertFalse(re.search(r"\.(vtp|pvd)", "".join(t.files("r"))))
    (t.folder / "mine/frames").mkdir(parents=True)
    (t.folder / "mine/frames/plate.vtkhdf").write_text("of another program")
    done = t.run_program("run", "deck.yaml", "--out", "mine", *VTKHDF)
    t.expect_complaint(done, 2, "mine/frames/plate.vtkhdf would be replaced, but ", "does not list it")


@claim("vtkhdf: report, statistics and open_in_paraview.py are those of the .vtp frames of the same run")
def _(t):
    deck = t.deck(BREAKS)
    t.expect_success("run", deck, "--out", "whole")
    t.expect_success("run", deck, "--out", "r", *VTKHDF)
    seen = []
    for folder in "whole", "r":
        t.expect_success("report", folder)
        report = ReportFile(t.folder / folder / "report.html")
        t.assertEqual(report.notes, [])
        seen.append(({name: text for name, text in report.scripts.items() if name not in ("description", "run")},
                     [report.description[key] for key in ("times [s]", "bodies", "impactors")]))
    t.assertGreater(len(seen[0][0]), 10)
    t.assertEqual(seen[0], seen[1])
    scripts = [(t.folder / folder / "open_in_paraview.py").read_text() for folder in ("whole", "r")]
    t.assertEqual(scripts[0].replace('", ".pvd"', '", ".vtkhdf"'), scripts[1])
    t.assertIn('("plate", ".vtkhdf", 0.005, "damage")', scripts[1])
    t.assertIn('("cylinder", ".vtkhdf")', scripts[1])
    said = [t.expect_success("statistics", folder, "--channel", "plate:x").out for folder in ("whole", "r")]
    t.assertIn("(whole/frames/plate_00004.vtp)", said[0])
    t.assertEqual(said[0].replace("whole/frames/plate_00004.vtp", "r/frames/plate.vtkhdf, step 4").replace("whole", "r"), said[1])
    (t.folder / "r/frames/plate.vtkhdf").write_text("nothing")
    t.run_program("report", "r")
    t.assertEqual(ReportFile(t.folder / "r/report.html").notes, ["frames/plate.vtkhdf is damaged: it is not a complete HDF5 file; use the file as written by the run."])


@claim("vtkhdf: interrupted at any time and resumed, a run has the frames of an uninterrupted one")
def _(t):
    need_reader()
    deck, chance = t.deck(*SHORT), random.Random(2)
    frames = "--set", "output.frames=60"
    t.expect_success("run", deck, "--out", "whole", *frames)
    resumed = 0
    for which in (signal.SIGINT, signal.SIGTERM) * 5:
        shutil.rmtree(t.folder / "r", ignore_errors=True)
        process = started(t, deck, "--out", "r", *frames, *VTKHDF)
        time.sleep(chance.uniform(0, 0.1))
        code, _, err = ended(process, which)
        if code <= 0:  # it had ended, and wrote its report
            continue
        t.assertEqual((code, err), (128 + which, ""))
        t.expect_success("run", deck, "--out", "r", *frames, *VTKHDF, "--resume")
        expect_frames(t, "r", "whole")
        resumed += 1
        if resumed == 3:
            break
    t.assertGreater(resumed, 0)


@claim("vtkhdf: a run killed at any time leaves whole frames from which it resumes")
def _(t):
    need_reader()
    deck, chance = t.deck(*SHORT), random.Random(4)
    frames = "--set", "output.frames=150"  # one in four steps: a good part of the time a frame is being written
    t.expect_success("run", deck, "--out", "whole", *frames)
    killed = 0
    for _ in range(20):
        shutil.rmtree(t.folder / "r", ignore_errors=True)
        process = t.start("run", deck, "--out", "r", *frames, *VTKHDF)
        while process.poll() is None and not (t.folder / "r/frames/cylinder.vtkhdf").exists():
            time.sleep(0.001)
        time.sleep(chance.uniform(0, 0.3))
        process.kill()
        process.communicate()
        if process.returncode == 0:
            continue
        killed += 1
        counts = expect_frames(t, "r", "whole", most="some")
        t.assertIn(counts[0] - counts[1], (0, 1))  # bodies first
        if (t.folder / "r/checkpoint.h5").exists():
            t.expect_success("run", deck, "--out", "r", *frames, *VTKHDF, "--resume")
            expect_frames(t, "r", "whole")
        if killed == 4:
            break
    t.assertGreater(killed, 2)


@claim("vtkhdf: a run is prolonged in the same file, and a file that is missing, damaged or too short for it is refused in a sentence")
def _(t):
    need_reader()
    step = ("time: {end: 20 us}", "time: {end: 20 us, step: 0.1 us}")
    t.expect_success("run", t.deck(step), "--out", "r", *VTKHDF)
    longer = "--set", "time.end=40 us", "--set", "output.frames=8"
    t.expect_success("run", t.deck(step), "--out", "whole", *longer)
    file = t.folder / "r/frames/plate.vtkhdf"
    whole = file.read_bytes()
    shutil.copytree(t.folder / "r", t.folder / "short")
    t.expect_success("run", t.deck(step, ("frames: 4", "frames: 1")), "--out", "fewer", *VTKHDF)
    for content, fault in ((None, "is missing, so the run cannot be resumed"), (b"nothing", "is damaged: it is not a complete HDF5 file"),
                           ((t.folder / "fewer/frames/plate.vtkhdf").read_bytes(), "has fewer frames than when the checkpoint was written, so the run cannot be resumed")):
        file.unlink()
        if content is not None:
            file.write_bytes(content)
        done = t.run_program("run", t.deck(step), "--out", "r", *VTKHDF, *longer, "--resume")
        t.expect_complaint(done, 2, f"r/frames/plate.vtkhdf {fault}")
        t.assertEqual(file.read_bytes() if file.exists() else None, content)
        file.write_bytes(whole)
    t.expect_success("run", t.deck(step), "--out", "r", *VTKHDF, *longer, "--resume")
    t.assertEqual(expect_frames(t, "r", "whole"), [9, 9])
    done = t.run_program("run", t.deck(step), "--out", "short", *longer, "--resume")
    t.expect_complaint(done, 2, "deck.yaml", "output.frame_format is vtp here, but vtkhdf in the run of the checkpoint")


@claim("vtkhdf: a frame that does not fit on the disk ends the run with a sentence, and all earlier frames are intact")
def _(t):
    need_reader()
    deck = t.deck()
    t.expect_success("run", deck, "--out", "whole")
    t.expect_success("run", deck, "--out", "r", *VTKHDF, "--set", "output.frames=2")
    size = (t.folder / "r/frames/plate.vtkhdf").stat().st_size
    done = t.run_program("run", deck, "--out", "r", "--force", *VTKHDF, limits={resource.RLIMIT_FSIZE: size})
    t.expect_complaint(done, 3, "r/frames/plate.vtkhdf cannot be written: File too large.", "ulimit -f", "intact")
    t.assertEqual(t.report("r")["outcome"], "failed")
    counts = expect_frames(t, "r", "whole", most="some")
    t.assertGreater(counts[0], 1)


@claim("vtkhdf: another word is refused with the words that there are")
def _(t):
    done = t.run_program("run", t.deck(("  frames: 4", "  frames: 4\n  frame_format: hdf5")), "--out", "r")
    t.expect_complaint(done, 2, "deck.yaml", "frame_format", "vtp", "vtkhdf")


main()
