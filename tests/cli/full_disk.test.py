"""No room: the run ends with 3 and a sentence, and what was written before is whole."""

import resource
import subprocess
import unittest
import xml.etree.ElementTree as xml

from claims import claim, main

BEGINNING_ONLY = ("history.csv", ".pvd", "run.json", "_at_peak.csv", "open_in_paraview.py")  # grow during a run, or record its outcome


def expect_intact(t, folder, whole):
    """Each file is the same in the undisturbed run, or the beginning of it in whole records."""
    for name in t.files(folder):
        content = (t.folder / folder / name).read_bytes()
        t.assertFalse(name.endswith(".part"), name)
        if name == "pressure_area/cylinder.csv":
            t.assertTrue((t.folder / whole / name).read_bytes().startswith(content) and content.endswith(b"\n"), name)
        elif not name.endswith(BEGINNING_ONLY):
            t.assertEqual(content, (t.folder / whole / name).read_bytes(), name)
    full = t.history(whole)
    for column, values in t.history(folder).items():
        t.assertEqual(values, full[column][: len(values)], column)
    for series in (t.folder / folder / "frames").glob("*.pvd"):
        listed = [entry.get("file") for entry in xml.parse(series).findall("./Collection/DataSet")]
        t.assertEqual(listed, sorted(path.name for path in series.parent.glob(f"{series.stem}_*.vtp")))
    if (t.folder / folder / "run.json").exists():
        t.assertEqual(t.report(folder)["outcome"], "failed")
        t.assertIn("cannot be written", t.report(folder)["failure"])


def run_with_files_up_to(t, size, *settings):
    """A limit on the size of files is a full disk that needs no administrator. The signal that comes with it would kill the program."""
    return t.run_program("run", t.deck(), "--out", "r", *settings, limits={resource.RLIMIT_FSIZE: size})


@claim("full disk: an output frame that does not fit ends the run, and all earlier output is intact")
def _(t):
    t.expect_success("run", t.deck(), "--out", "whole")
    size = (t.folder / "whole/frames/plate_00001.vtp").stat().st_size
    t.assertGreater(size, (t.folder / "whole/frames/plate_00000.vtp").stat().st_size)
    done = run_with_files_up_to(t, size - 1)
    t.expect_complaint(done, 3, "r/frames/plate_00001.vtp cannot be written", "ulimit -f", "intact")
    t.assertIn("frames/plate_00000.vtp", t.files("r"))
    t.assertNotIn("frames/plate_00001.vtp", t.files("r"))
    t.assertEqual(t.report("r")["outcome"], "failed")
    expect_intact(t, "r", "whole")


@claim("full disk: an incomplete row of history is removed")
def _(t):
    settings = ["--set", "output.frames=0", "--set", "output.history_interval=0.1 us"]
    t.expect_success("run", t.deck(), "--out", "whole", *settings)
    lengths = [len(row) for row in (t.folder / "whole/history.csv").read_bytes().splitlines(keepends=True)]
    t.assertGreater(sum(lengths), 5000)
    done = run_with_files_up_to(t, 5000, *settings)
    t.expect_complaint(done, 3, "r/history.csv cannot be written", "ulimit -f", "intact")
    rows = next(k for k in range(len(lengths)) if sum(lengths[: k + 1]) > 5000)
    t.assertEqual(len(t.history("r")["time [s]"]), rows - 1)  # one line is the header
    expect_intact(t, "r", "whole")


@claim("full disk: if only the trial file fits, the folder is refused, and if only the lock and the list of files fit, the first file is named")
def _(t):
    t.expect_complaint(run_with_files_up_to(t, 100), 2, "results cannot be written to the folder r: File too large.")
    t.assertEqual(t.files("r"), [])
    t.expect_complaint(run_with_files_up_to(t, 500), 3, "r/history.csv cannot be written", "ulimit -f")
    t.assertEqual(t.files("r"), ["files.txt", "history.csv"])
    t.assertEqual((t.folder / "r/history.csv").read_bytes(), b"")


@claim("full disk: the same on a small file system that runs full")
def _(t):
    t.expect_success("run", t.deck(), "--out", "whole")
    (t.folder / "small").mkdir()
    # A private mount that ends with the shell; results are copied out before.
    script = 'mount -t tmpfs -o size=72k none small && { "$0" run deck.yaml --out small/r; code=$?; cp -r small/r r; exit $code; }; exit 77'
    shell = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script, t.program], cwd=t.folder, env=t.environment, text=True,
                           capture_output=True, timeout=60)
    if shell.returncode not in (0, 2, 3):
        raise unittest.SkipTest(f"no mount for ordinary users here: {shell.stderr}")
    t.assertEqual(shell.returncode, 3, shell.stderr)
    t.assertRegex(shell.stderr, r"^error: small/r/\S+ cannot be written: No space left on device\. Free disk space and run again; everything written before is intact\.\n$")
    t.assertIn("frames/plate_00001.vtp", t.files("r"))
    expect_intact(t, "r", "whole")


@claim("full disk: output that cannot be printed is an error too")
def _(t):
    deck = t.deck()
    with open("/dev/full", "w") as full:
        for arguments in (["describe"], ["version"], ["run", deck, "--out", "r"]):
            process = subprocess.run([t.program, *arguments], cwd=t.folder, env=t.environment, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
            t.assertEqual(process.returncode, 3, arguments)
            t.assertRegex(process.stderr, r"^error: the output cannot be printed: No space left on device\. .*\.\n$")
    t.assertEqual(t.report("r")["outcome"], "finished")  # progress output is lost, but not the run


main()
