"""Input errors end in one sentence that begins with error:, with the position in the deck if there is one, and in exit code 2.
Every mistake of the deck's own is in tests/io/deck; here are those that only the whole program can make or find."""

import os
import resource

from claims import DECK, changed, claim, main, place_of

CYLINDER = "{cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}"


def refused(t, change, at, *words):
    """The changed deck is refused at the position of `at`, alike by run and by check."""
    deck = t.deck(change)
    begins = f"deck.yaml:{place_of(changed(DECK, change), at)}: "
    for command in ("run", "check"):
        done = t.run_program(command, deck, "--out", "r")
        t.expect_complaint(done, 2, begins, *words)
        t.assertIn(done.out, ("", "Small plate\n"))  # the title, where the set-up has begun


def refused_surface(t, surface, at, *words):
    refused(t, (CYLINDER, surface), at, *words)


@claim("mistakes: errors in the deck are refused at their line and column")
def _(t):
    refused(t, ("poissons_ratio", "poisson_ratio"), "poisson_ratio", "did you mean poissons_ratio?")
    refused(t, ("mass: 1 kg", "mass: 1 kg\n    mass: 2 kg"), "mass: 2 kg", "mass is given twice", "deck.yaml:11:5")
    refused(t, ("spacing: 5 mm", "spacing: 5 kg"), "5 kg", "that is a mass", "9 mm")
    refused(t, ("0.25", "0.6"), "0.6", "poissons_ratio is 0.6", "below 0.5")
    refused(t, ("end: 20 us", "end: 20 us, step: 30 us"), "30 us", "longer than the whole run")


@claim("mistakes: errors found during set-up of the simulation also have line and column")
def _(t):
    refused(t, ("end: 20 us", "end: 20 us, step: 3 us"), "3 us", "times the critical time step", "omit time.step")
    refused(t, ("0, 50 mm, 0", "0, 40 mm, 0"), "[0, 40 mm, 0]", "cylinder starts inside body plate", "56 particles")
    region = "free_dofs: [y]\n    contact_bounds: {box: {size: [50 mm, 50 mm, 10 mm]%s}}"
    refused(t, ("free_dofs: [y]", region % ""), "contact_bounds:", "extend beyond the box by up to 0.015 m", "on_exceed: clip")
    refused(t, ("free_dofs: [y]", region % ", centre: [1, 0, 0]"), "contact_bounds:", "no panel of the surface reaches into the box")
    refused(t, ("at: [0, 0, 0]", "at: [0, 1 m, 0]"), "[0, 1 m, 0]", "probe centre lies 0.973 m from the nearest particle")
    refused(t, ("to: [0, 30 mm, 0]", "to: [0, 300 mm, 0]"), "along_y:", "runs outside body plate", "move its ends")
    refused(t, ("20 us", "1e30 s"), "1e30 s", "the run would take 1.4", "e+36 steps")
    refused(t, ("end: 20 us", "end: 20 us, step: 1e-30"), "20 us,", "the run would take 2e+25 steps of 1e-30 s")
    refused(t, ("spacing: 5 mm", "spacing: 5 nm"), "5 nm", "for body plate the run needs", "use a spacing of at least")
    refused(t, ("spacing: 5 mm", "spacing: 1e-300 m"), "1e-300 m", "gives body plate more cells than can be numbered", "increase it")


@claim("mistakes: a body of one particle needs a time step")
def _(t):
    alone = ["--set", "bodies.plate.shape.box.size=[5 mm, 5 mm, 5 mm]", "--set", "output.lines={}"]
    t.expect_complaint(t.run_program("run", t.deck(), *alone), 2, f"deck.yaml:{place_of(DECK, 'time:')}: ", "no body has bonds", "time.step")
    t.expect_success("run", t.deck(), *alone, "--set", "time.step=0.5 us")


@claim("mistakes: a missing, damaged or invalid surface file is refused with reason and position")
def _(t):
    (t.folder / "cut.stl").write_text("solid rock\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n")
    (t.folder / "noise.stl").write_bytes(bytes(range(256)))
    (t.folder / "sheet.obj").write_text("v 0 0 0\nv 0.1 0 0\nv 0 0 0.1\nf 1 2 3\n")
    (t.folder / "fin.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n")
    refused_surface(t, "{file: none.stl}", "none.stl", "there is no file", "deck's folder")
    refused_surface(t, "{file: cut.stl}", "surface:", "cut.stl:6: the file ends in triangle 1")
    refused_surface(t, "{file: noise.stl}", "surface:", "noise.stl")
    refused_surface(t, "{file: sheet.obj}", "surface:", "cylinder: the surface is open", "orientation: normals")
    refused_surface(t, "{file: fin.obj}", "surface:", "cylinder: ")
    for name in ("none.stl", "cut.stl", "noise.stl"):
        t.expect_complaint(t.run_program("mesh", name), 2, name)


@claim("mistakes: a missing or unreadable deck, or a folder, is named")
def _(t):
    t.expect_complaint(t.run_program("run", "none.yaml"), 2, "none.yaml: there is no such file")
    t.expect_complaint(t.run_program("run", "."), 2, ".: this is a folder", "deck.yaml")
    t.expect_complaint(t.run_program("run", "/dev/null"), 2, "/dev/null: the deck is empty")
    t.expect_complaint(t.run_program("run", "/proc/self/mem"), 2, "/proc/self/mem: this file cannot be read")  # reading fails, opening does not


@claim("mistakes: an unwritable results folder is reported before any computation")
def _(t):
    deck = t.deck()
    for command in ("run", "check"):
        t.expect_complaint(t.run_program(command, deck, "--out", "deck.yaml/below"), 2, "results cannot be written to the folder deck.yaml/below", "--out")
        t.expect_complaint(t.run_program(command, deck, "--out", "/proc/results"), 2, "results cannot be written to the folder /proc/results", "--out")


@claim("mistakes: errors in --set name the key")
def _(t):
    deck = t.deck()
    t.expect_complaint(t.run_program("run", deck, "--set", "time.end"), 2, "--set time.end: ", "output.frames=0")
    t.expect_complaint(t.run_program("run", deck, "--set", "time.endd=3"), 2, "--set time.endd: endd is not a key of time; did you mean end?")
    t.expect_complaint(t.run_program("run", deck, "--set", "time.end=3 kg"), 2, "--set time.end: ", "that is a mass")
    t.expect_complaint(t.run_program("run", deck, "--set", "time.step=3 us"), 2, "--set time.step: ", "times the critical time step")


@claim("mistakes: command-line errors are one sentence with a remedy")
def _(t):
    deck = t.deck()
    for arguments, *words in [
        ([], "command", "--help"),
        (["fly"], "fly", "--help"),
        (["run"], "deck", "--help"),
        (["run", deck, "--bogus"], "--bogus", "perimpact run --help"),
        (["run", deck, "more"], "more", "--help"),
        (["run", deck, "--threads", "0"], "--threads", "1 to 1024"),
        (["run", deck, "--threads", "two"], "--threads", "two"),
        (["run", deck, "--set"], "--set", "--help"),
        (["mesh"], "file", "--help"),
        (["mesh", "a.stl", "--scale", "0"], "--scale", "above 0"),
    ]:
        done = t.run_program(*arguments)
        t.expect_complaint(done, 2, "", *words)
        t.assertEqual(done.out, "")
        t.assertLess(len(done.err), 200, done.err)


@claim("mistakes: a set-up larger than the memory of the machine is refused before it is built, with a suitable spacing")
def _(t):
    for command in "check", "run":
        done = t.run_program(command, t.deck(), "--set", "bodies.plate.spacing=2 um")
        t.expect_complaint(done, 2, "--set bodies.plate.spacing: with a spacing of 2e-06 m for body plate the run needs ", "GB of this machine are available", "at least")


@claim("mistakes: an empty --out is refused")
def _(t):
    for command in "check", "run":
        t.expect_complaint(t.run_program(command, t.deck(), "--out", ""), 2, "--out is empty; use --out .")
    t.assertEqual(t.files("."), ["deck.yaml"])


@claim("mistakes: a failed allocation is an error, not an abort")
def _(t):
    # the memory of surfaces is not known before they are made, so this set-up is begun
    done = t.run_program("run", t.deck(), "--set", "impactors.cylinder.surface.cylinder.edge_length=20 um", limits={resource.RLIMIT_AS: 2**29})
    t.expect_complaint(done, 3, "there is not enough memory", "spacing")


@claim("mistakes: a position so far away that coordinates lose the spacing is refused, of bodies and impactors")
def _(t):
    for change, at in ((("position: [0, 50 mm, 0]", "position: [0, 1e200, 0]"), "[0, 1e200, 0]"), (("spacing: 5 mm", "spacing: 5 mm\n    position: [-1e12, 0, 0]"), "[-1e12, 0, 0]")):
        deck = t.deck(change)
        distance = "1e+200" if "1e200" in change[1] else "1e+12"
        for command in "run", "check":
            done = t.run_program(command, deck, "--out", "r")
            t.expect_complaint(done, 2, f"deck.yaml:{place_of(changed(DECK, change), at)}: position is {distance} m from the origin, where coordinates are rounded to ",
                               " m, more than a millionth of the spacing of 0.005 m; use positions within 2.3e+07 m of the origin, or check the unit.")
    t.expect_success("check", t.deck(("position: [0, 50 mm, 0]", "position: [0, 1e7, 0]")), "--out", "r")
    for text in "inf", "nan":
        done = t.run_program("check", t.deck(("position: [0, 50 mm, 0]", f"position: [0, {text}, 0]")), "--out", "r")
        t.expect_complaint(done, 2, "deck.yaml:", f"y of position is {text}, but that is not a number; write a length, for example 9 mm.")


@claim("mistakes: a deck or a changed value that is not UTF-8 is refused with line, column and byte")
def _(t):
    for text, place, byte in ((b"title: Small pl\xe4te", "1:16", "E4"), ("title: Größe ".encode() + b"\xe4", "1:14", "E4"), (b"title: \xed\xa0\x80", "1:8", "ED"),
                              (b"title: \xc0\x80", "1:8", "C0"), (b"title: \xe2\x82", "1:8", "E2")):
        (t.folder / "latin.yaml").write_bytes(DECK.encode().replace(b"title: Small plate", text))
        done = t.run_program("check", "latin.yaml", "--out", "r")
        t.expect_complaint(done, 2, f"latin.yaml:{place}: the character here, byte 0x{byte}, is not UTF-8, perhaps Latin-1; save the text as UTF-8, or convert it by iconv "
                           "-f latin1 -t utf8.")
    t.expect_success("check", t.deck(("Small plate", "Größe €  𝄞")), "--out", "r")
    done = t.run_program("check", "deck.yaml", "--out", "r", "--set", b"title=Gr\xf6\xdfe".decode("utf-8", "surrogateescape"))
    t.expect_complaint(done, 2, "--set title", "byte 0xF6, is not UTF-8")


@claim("mistakes: a pipe as deck, surface, table or output file is refused at once, instead of waiting for its other end")
def _(t):
    os.mkfifo(t.folder / "pipe.yaml")
    os.mkfifo(t.folder / "pipe.stl")
    os.mkfifo(t.folder / "pipe.csv")
    done = t.run_program("run", "pipe.yaml")
    t.expect_complaint(done, 2, "pipe.yaml: this is a pipe, not a file; write the deck to a file, since a run can be resumed with it only.")
    t.expect_complaint(t.run_program("mesh", "pipe.stl"), 2, "pipe.stl: this is a folder or a device, not a file; give the path of the surface file.")
    for arguments in (["shape", "sphere", "--diameter", "1", "--edge-length", "0.2", "-o", "pipe.stl"], ["new", "plate", "pipe.yaml", "--force"],
                      ["run", t.deck(), "--log", "pipe.csv"]):
        name = arguments[-1] if arguments[-1] != "--force" else "pipe.yaml"
        t.expect_complaint(t.run_program(*arguments), 2, f"{name} cannot be written: it is a pipe or a device, not a file. Choose another name.")
    t.expect_complaint(t.run_program("run", "deck.yaml", "--out", "pipe.csv"), 2, "results cannot be written to the folder pipe.csv: Not a directory.")
    (t.folder / "results").mkdir()
    os.mkfifo(t.folder / "results/history.csv")
    t.expect_complaint(t.run_program("statistics", "results"), 2, "results/history.csv: this is a folder or a device")
    t.expect_complaint(t.run_program("run", "deck.yaml", "--force"), 2, "results/history.csv would be replaced, but results/files.txt does not list it")


@claim("mistakes: names that are too long for files are refused before the set-up")
def _(t):
    name = "p" * 201
    done = t.run_program("run", t.deck(("  plate:\n", f"  {name}:\n")), "--out", "r")
    t.expect_complaint(done, 2, f"deck.yaml:{place_of(DECK, 'plate:' + chr(10))}: a name in bodies has 201 characters, but names become files; use at most 200.")
    t.assertEqual(done.out, "")
    t.assertFalse((t.folder / "r").exists())
    text = DECK.replace("plate:\n", f"{name[:200]}:\n").replace("body: plate", f"body: {name[:200]}")
    (t.folder / "long.yaml").write_text(text)
    t.expect_success("run", "long.yaml", "--out", "long")
    t.expect_complaint(t.run_program("run", t.deck(), "--out", "o" * 300), 2, "results cannot be written to the folder ooo", "File name too long")


@claim("mistakes: a refused angle in degrees has its range in degrees, one in radians in radians")
def _(t):
    arguments = ["shape", "hull", "--length", "10", "--breadth", "3", "--draft", "1", "--edge-length", "0.5", "--stem-angle", "30 deg", "--waterline-angle"]
    t.expect_complaint(t.run_program(*arguments, "95 deg"), 2, "--waterline-angle: waterline_angle is \"95 deg\", but it must be above 0 and below 89.95 deg.")
    t.expect_complaint(t.run_program(*arguments, "1.6"), 2, "--waterline-angle: waterline_angle is 1.6, but it must be above 0 and below 1.57 rad; write degrees with their unit, as in 30 deg.")
    t.expect_complaint(t.run_program(*arguments, "30 deg", "--flare", "70 degrees"), 2, "--flare: flare is \"70 degrees\", but it must be from -30 to 60 deg.")


main()
