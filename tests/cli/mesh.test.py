"""What `perimpact mesh` leaves behind."""

from claims import claim, main

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


@claim("mesh: the picture of defects has the file's whole name, but for its format, so that pictures of wall-0.25 and wall-0.5 are two")
def _(t):
    for name in ("wall-0.25.obj", "wall-0.5.obj"):
        (t.folder / name).write_text(TRIANGLE)
        t.expect_success("mesh", name)
    t.assertEqual(t.files("."), ["wall-0.25.obj", "wall-0.25_defects.vtp", "wall-0.5.obj", "wall-0.5_defects.vtp"])


main()
