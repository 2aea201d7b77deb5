"""How a run says how far it is, on a terminal of any width and in a pipe."""

import fcntl
import os
import pty
import re
import resource
import select
import signal
import struct
import termios
import time
import unittest

from claims import claim, main

LINE = r"^ *100\.0 %  step \d+ of \d+  t = 2e-05 s  \S+ steps/s  0 s left  \d+ contacts$"
SOME_STEPS = ("end: 20 us", "end: 5 ms")  # a second or more: the line is redrawn every quarter


class Terminal:
    """A terminal of some columns, whose screen is what a program has written: \\r, \\n, erase to the end of the line, and lines that wrap."""

    def __init__(self, columns):
        try:
            self.ours, self.theirs = pty.openpty()
        except OSError as error:
            raise unittest.SkipTest(f"there are no terminals here: {error}")
        self.resize(columns)
        self.written = b""

    def resize(self, columns):
        self.columns = columns
        fcntl.ioctl(self.theirs if self.theirs is not None else self.ours, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))

    def started(self):
        """The program has the terminal; it closes when the program ends."""
        os.close(self.theirs)
        self.theirs = None

    def read_for(self, seconds):
        """False once the program has closed it."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if select.select([self.ours], [], [], left)[0]:
                try:
                    piece = os.read(self.ours, 4096)
                except OSError:  # how Linux reports that the program has closed the terminal
                    piece = b""
                if not piece:
                    return False
                self.written += piece
        return True

    def screen(self):
        """All rows, also those that have left the top, without empty ones at the end."""
        rows, column = [""], 0
        for part in re.findall(r"\x1b\[K|.", self.written.decode(), re.DOTALL):
            if part == "\r":
                column = 0
            elif part == "\n":
                rows.append("")
            elif part == "\x1b[K":
                rows[-1] = rows[-1][:column]
            else:
                if column == self.columns:
                    rows.append("")
                    column = 0
                rows[-1] = rows[-1][:column] + part + rows[-1][column + 1 :]
                column += 1
        return [row.rstrip() for row in rows]


def on_terminal(t, columns, *arguments, **options):
    terminal = Terminal(columns)
    t.environment["TERM"] = "xterm"
    process = t.start("run", *arguments, "--out", "r", "--threads", "1", stdout=terminal.theirs, **options)
    terminal.started()
    return terminal, process


@claim("progress: in a pipe or file it is plain lines, without escape codes")
def _(t):
    out = t.expect_success("run", t.deck(), "--out", "r").out
    t.assertNotIn("\x1b", out)
    t.assertNotIn("\r", out)
    shown = [line for line in out.splitlines() if " % " in line and "step" in line]
    t.assertEqual(len(shown), 1)  # a line every ten seconds, and the last
    t.assertRegex(shown[0], LINE)


@claim("progress: on a terminal one line is redrawn, and ended; it fits a width of 120, 80, 40, 20 and 7 columns")
def _(t):
    for columns in 120, 80, 40, 20, 7:
        terminal, process = on_terminal(t, columns, t.deck(SOME_STEPS), "--force")
        while terminal.read_for(1):
            pass
        t.assertEqual((process.wait(timeout=60), process.stderr.read()), (0, ""))
        process.stderr.close()
        os.close(terminal.ours)
        drawn = [piece for piece in re.split(r"\r\x1b\[K|\r\n", terminal.written.decode()) if re.match(r" *\d+\.\d", piece)]
        t.assertGreater(len(drawn), 2, "it was drawn once only")
        t.assertLess(max(map(len, drawn)), columns)
        screen = terminal.screen()
        t.assertEqual(len([row for row in screen[: next(k for k, row in enumerate(screen) if row.startswith("where"))] if re.match(r" *\d+\.\d( |$)", row)]), 1, screen)
        t.assertTrue(drawn[-1].startswith("100.0 %"[: columns - 1]), drawn[-1])
        expected = {120: "contacts", 80: "step", 40: "left", 20: "0 s left", 7: "100"}[columns]  # the least important goes first
        t.assertIn(expected, drawn[-1])
    t.assertNotIn("steps/s", drawn[-1])


@claim("progress: the line follows a terminal that becomes narrower during the run; without its size COLUMNS counts, and TERM=dumb has plain lines")
def _(t):
    terminal, process = on_terminal(t, 120, t.deck(("end: 20 us", "end: 100 s"), ("frames: 4", "frames: 0")))
    while b"steps/s" not in terminal.written:
        t.assertTrue(terminal.read_for(0.3))
    terminal.written = b""
    terminal.resize(30)
    terminal.read_for(1.2)
    process.send_signal(signal.SIGINT)
    while terminal.read_for(1):
        pass
    t.assertEqual(process.wait(timeout=60), 130)
    drawn = re.findall(r"\r\x1b\[K( *\d+\.\d %[^\r]*)", terminal.written.decode())
    t.assertGreater(len(drawn), 3)
    t.assertLess(max(map(len, drawn[1:])), 30)  # the first may have been on its way
    process.stderr.close()
    os.close(terminal.ours)

    t.environment["COLUMNS"] = "25"
    terminal, process = on_terminal(t, 0, t.deck(SOME_STEPS), "--force")
    while terminal.read_for(1):
        pass
    drawn = [piece for piece in re.split(r"\r\x1b\[K|\r\n", terminal.written.decode()) if re.match(r" *\d+\.\d %", piece)]
    t.assertLess(max(map(len, drawn)), 25)
    t.assertEqual(process.wait(timeout=60), 0)
    process.stderr.close()

    terminal = Terminal(80)
    t.environment["TERM"] = "dumb"
    process = t.start("run", "deck.yaml", "--out", "r", "--force", "--threads", "1", stdout=terminal.theirs)
    terminal.started()
    while terminal.read_for(1):
        pass
    t.assertEqual(process.wait(timeout=60), 0)
    t.assertNotIn(b"\x1b", terminal.written)
    process.stderr.close()


@claim("progress: the line is alone on its row: warnings, the end of an interrupted run and an error of a failed one begin below it")
def _(t):
    def rows_of(deck, code, **options):
        terminal = Terminal(100)
        t.environment["TERM"] = "xterm"
        process = t.start("run", deck, "--out", "r", "--force", "--threads", "1", stdout=terminal.theirs, stderr=terminal.theirs, **options)
        terminal.started()
        while terminal.read_for(1):
            pass
        t.assertEqual(process.wait(timeout=60), code)
        os.close(terminal.ours)
        return terminal.screen()

    away = rows_of(t.deck(SOME_STEPS, ("-32 m/s", "32 m/s")), 0)
    t.assertEqual(len([row for row in away if row.startswith("warning: Impactor cylinder had no contact")]), 1, away)
    limited = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (500000, 500000))}  # as if the disk were full
    failed = rows_of(t.deck(("end: 20 us", "end: 20 ms"), ("frames: 4", "frames: 0")), 3, **limited)
    for begins in r" *\d+\.\d %  step", "error: r/history.csv cannot be written":
        t.assertEqual(len([row for row in failed if re.match(begins, row)]), 1, failed)
    for row in away + failed:
        if re.match(r" *\d+\.\d %", row):
            t.assertRegex(row, r"contacts$")


@claim("progress: title and warnings appear at once through a pipe, before the set-up and during the run, and its end does not need a reader")
def _(t):
    deck = t.deck(("end: 20 us", "end: 100 s"), ("density: 8000 kg/m3", "density: 8"), ("frames: 4", "frames: 0"))
    process = t.start("run", deck, "--out", "r")
    begin = time.monotonic()
    lines = []
    while len(lines) < 3:
        line = process.stdout.readline()
        if not line.startswith("set-up:"):  # on a slow machine
            lines.append(line)
    t.assertLess(time.monotonic() - begin, 9)  # the first progress line comes after ten
    t.assertEqual(lines[0], "Small plate\n")
    t.assertTrue(lines[2].startswith("warning: The density of plate is 8 kg/m3"), lines)
    process.kill()
    process.communicate()

    short = t.start("run", t.deck(SOME_STEPS), "--out", "unread", "--threads", "1")
    t.assertEqual(short.stdout.readline(), "Small plate\n")
    short.stdout.close()  # as `| head -1` does
    t.assertEqual(short.stderr.read(), "error: the output cannot be printed: Broken pipe. Free disk space, or redirect it elsewhere.\n")
    short.stderr.close()
    t.assertEqual(short.wait(timeout=60), 3)
    t.assertEqual(t.report("unread")["outcome"], "finished")


main()
