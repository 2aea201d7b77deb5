"""How a run says how far it is."""

import os
import pty
import unittest

from claims import claim, main

LINE = r"^ *100\.0 %  step \d+ of \d+  t = 2e-05 s  \S+ steps/s  0 s left  \d+ contacts$"


@claim("progress: in a pipe or file it is plain lines, without escape codes")
def _(t):
    out = t.expect_success("run", t.deck(), "--out", "r").out
    t.assertNotIn("\x1b", out)
    t.assertNotIn("\r", out)
    t.assertEqual(len([line for line in out.splitlines() if " % " in line and "step" in line]), 1)  # a line every ten seconds, and the last
    t.assertRegex("\n".join(out.splitlines()[2:3]), LINE)


@claim("progress: on a terminal one line is redrawn, and ended")
def _(t):
    try:
        terminal, end = pty.openpty()
    except OSError as error:
        raise unittest.SkipTest(f"there are no terminals here: {error}")
    process = t.start("run", t.deck(("end: 20 us", "end: 2 ms")), "--out", "r", "--threads", "1", stdout=end)
    os.close(end)
    drawn = b""
    try:
        while piece := os.read(terminal, 4096):
            drawn += piece
    except OSError:
        pass  # how Linux reports that the program has closed the terminal
    os.close(terminal)
    t.assertEqual((process.wait(timeout=60), process.stderr.read()), (0, ""))
    process.stderr.close()
    lines = [line for line in drawn.decode().split("\r\n") if "steps/s" in line]
    t.assertEqual(len(lines), 1)
    t.assertRegex(lines[0], r"^(\r\x1b\[K *\d+\.\d %  step [^\r\x1b]*)+$")
    t.assertRegex(lines[0], r"\r\x1b\[K100\.0 %[^\r\x1b]*$")


main()
