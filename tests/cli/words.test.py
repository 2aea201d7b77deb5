"""describe, mesh, version, help: what the program says about itself and about surfaces."""

from claims import claim, main

TETRAHEDRON = "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"  # 10 mm, volume 1000/6 mm3


@claim("words: describe prints the whole deck reference, or one key with unit, range, default and meaning")
def _(t):
    whole = t.expect_success("describe").out
    for key in ("time", "bodies", "impactors", "contact", "output", "poissons_ratio", "radius_ratio", "contact_bounds", "probes"):
        t.assertIn(key, whole)
    one = t.expect_success("describe", "poissons_ratio").out
    t.assertTrue(one.startswith("bodies.<name>.material.poissons_ratio: number, above -1 and below 0.5, default 0.25"), one)
    t.assertIn("youngs_modulus: number [Pa], above 0, optional", t.expect_success("describe", "bodies.material").out)


@claim("words: describe suggests a key for an unknown one")
def _(t):
    t.expect_complaint(t.run_program("describe", "poisson_ratio"), 2, "poisson_ratio: ", "did you mean poissons_ratio?")


@claim("words: describe writes the pages of the deck reference to a folder, which it creates, and refuses a path that is a file")
def _(t):
    t.assertIn("pages/deck/index.md", t.expect_success("describe", "--markdown", "pages/deck").out)
    index = (t.folder / "pages/deck/index.md").read_text()
    t.assertIn("[Materials](materials.md)", index)
    t.assertIn("youngs_modulus", (t.folder / "pages/deck/materials.md").read_text())
    (t.folder / "taken").write_text("mine")
    t.expect_complaint(t.run_program("describe", "--markdown", "taken"), 2, "taken", "folder")
    t.assertEqual((t.folder / "taken").read_text(), "mine")
    t.expect_complaint(t.run_program("describe", "--markdown"), 2, "--markdown")
    t.expect_complaint(t.run_program("describe", "time", "--markdown", "pages"), 2, "key excludes --markdown")


@claim("words: version and --version print program and version")
def _(t):
    for arguments in (["version"], ["--version"]):
        t.assertRegex(t.expect_success(*arguments).out, r"^perimpact \d+\.\d+\.\d+\n$")


@claim("words: --help lists the commands, and that of each command its options")
def _(t):
    for command in ("run", "check", "describe", "new", "mesh", "statistics", "version"):
        t.assertIn(command, t.expect_success("--help").out)
        t.assertIn("Usage:", t.expect_success(command, "--help").out)
    for option in ("--set", "--out", "--threads"):
        t.assertIn(option, t.expect_success("run", "--help").out)


@claim("words: mesh reports on a closed file, in metres by --scale")
def _(t):
    (t.folder / "rock.obj").write_text(TETRAHEDRON)
    rows = t.expect_success("mesh", "rock.obj", "--scale", "0.001").out
    for row in ("4 (4 triangles, 4 vertices)", "0.01 x 0.01 x 0.01 m", "closed", "1.6667e-07 m3", "(0.0025, 0.0025, 0.0025) m"):
        t.assertIn(row, rows)


@claim("words: mesh reports on an open file too, with the required declaration in the deck")
def _(t):
    (t.folder / "half.obj").write_text(TETRAHEDRON.rsplit("f", 1)[0])
    out = t.expect_success("mesh", "half.obj").out
    t.assertIn("open, 3 boundary edges", out)
    t.assertIn("orientation: normals", out)


main()
