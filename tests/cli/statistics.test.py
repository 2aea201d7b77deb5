"""perimpact statistics: what forces come to, and how wide a channel is, against plain sums over history.csv and cracks of known places."""

import cmath
import math
import random

from claims import claim, main, table

FORCE = "cylinder.force_y [N]"


def rows_of(history, column, begin=-math.inf, end=math.inf):
    """(length, value, time) of each row's part in the window."""
    times = history["time [s]"]
    for before, time, value in zip(times, times[1:], history[column][1:]):
        length = min(time, end) - max(before, begin)
        if length > 1e-9 * (time - before):
            yield length, value, time


def mean_of(rows):
    rows = list(rows)
    return sum(length * value for length, value, _ in rows) / sum(length for length, _, _ in rows)


def results_table(path):
    """Rows of statistics.csv by their column."""
    head, *rows = (line.split(",") for line in path.read_text().splitlines())
    return {row[0]: dict(zip(head, row)) for row in rows}


@claim("statistics: means, deviations and extremes are those of the rows of history, the whole run or a part of it")
def _(t):
    t.expect_success("run", t.deck(("history_interval: 2 us", "history_interval: 0.3 us")), "--out", "r")
    history = t.history("r")
    for limits, (begin, end) in (([], (-math.inf, math.inf)), (["--from", "4.25 us", "--to", "17e-6"], (4.25e-6, 17e-6))):
        t.assertIn("cylinder.force_y [N]", t.expect_success("statistics", "r", *limits).out)
        reported = results_table(t.folder / "r/statistics.csv")
        t.assertEqual(list(reported), [f"cylinder.force_{axis}" for axis in "xyz"])
        reported, rows = reported["cylinder.force_y"], list(rows_of(history, FORCE, begin, end))
        mean = mean_of(rows)
        t.assertAlmostEqual(float(reported["mean"]) / mean, 1, delta=1e-12)  # sums of 60 numbers, in another order
        square = sum(length * (value - mean) ** 2 for length, value, _ in rows) / sum(length for length, _, _ in rows)
        t.assertAlmostEqual(float(reported["standard_deviation"]) / math.sqrt(square), 1, delta=1e-12)
        for word, choose in (("maximum", max), ("minimum", min)):
            value = choose(value for _, value, _ in rows)
            t.assertEqual(float(reported[word]), value)
            t.assertEqual(float(reported[word + "_at [s]"]), next(time for _, each, time in rows if each == value))
        t.assertEqual(reported["unit"], "N")


@claim("statistics: windows give mean and extremes of equal parts of the time")
def _(t):
    t.expect_success("run", t.deck(("history_interval: 2 us", "history_interval: 0.3 us")), "--out", "r")
    out = t.expect_success("statistics", "r", "--columns", "cylinder.force_y,cylinder.position_y", "--windows", "7").out
    t.assertIn("Written to r: statistics.csv, windows.csv, spectrum.csv", out)
    history, windows = t.history("r"), table(t.folder / "r/windows.csv")
    t.assertEqual(list(windows), ["from [s]", "to [s]"] + [f"cylinder.{which}.{what} [{unit}]" for which, unit in (("position_y", "m"), ("force_y", "N"))
                                                           for what in ("mean", "maximum", "minimum")])
    for k, (begin, end) in enumerate(zip(windows["from [s]"], windows["to [s]"], strict=True)):
        t.assertAlmostEqual(begin, 20e-6 * k / 7, delta=1e-18)
        rows = list(rows_of(history, FORCE, begin, end))
        t.assertAlmostEqual(windows["cylinder.force_y.mean [N]"][k], mean_of(rows), delta=1e-9 * max(history[FORCE]))  # parts of rows at the ends
        for word, choose in (("maximum", max), ("minimum", min)):
            t.assertEqual(windows[f"cylinder.force_y.{word} [N]"][k], choose(value for _, value, _ in rows))
        # the cylinder moves down: its highest position is at the beginning, interpolated between two rows
        row = next(n for n in range(1, len(history["time [s]"])) if history["time [s]"][n] > begin)
        (t0, t1), (y0, y1) = history["time [s]"][row - 1 : row + 1], history["cylinder.position_y [m]"][row - 1 : row + 1]
        t.assertAlmostEqual(windows["cylinder.position_y.maximum [m]"][k], y0 + (y1 - y0) * (begin - t0) / (t1 - t0), delta=1e-12)
    t.expect_success("statistics", "r")
    t.assertFalse((t.folder / "r/windows.csv").exists())  # they were of other columns


def write_history(t, times, columns):
    """A history.csv that no run has written."""
    (t.folder / "r").mkdir(exist_ok=True)
    rows = [",".join(["time [s]", *columns])] + [",".join(map(repr, row)) for row in zip(times, *columns.values())]
    (t.folder / "r/history.csv").write_text("\n".join(rows) + "\n")
    t.write_kinds("r", loads=["ship.force_x"])


@claim("statistics: the spectrum equals Welch's method by a direct sum over each segment, and reports segments and resolution")
def _(t):
    chance, dt = random.Random(5), 0.02
    force = [3 * math.sin(2 * math.pi * 2.5 * dt * k) + chance.gauss(0, 1) for k in range(301)]
    write_history(t, [dt * k for k in range(301)], {"ship.force_x [N]": force, "ship.contacts [-]": [1.0] * 301})
    out = t.expect_success("statistics", "r", "--segment", "2").out
    t.assertIn("spectrum: 8 Hann windows of 1.28 s (64 intervals of 0.02 s), half overlapping; resolution 0.7812 Hz, up to 25 Hz", out)
    spectrum = table(t.folder / "r/spectrum.csv")
    t.assertEqual(list(spectrum), ["frequency [Hz]", "ship.force_x [N2/Hz]"])
    window = [math.sin(math.pi * n / 64) ** 2 for n in range(64)]
    for k in (0, 1, 3, 17, 32):
        power = 0
        for begin in range(0, 300 - 63, 32):
            part = force[1 + begin : 65 + begin]
            mean = sum(part) / 64
            power += abs(sum(w * (x - mean) * cmath.exp(-2j * math.pi * k * n / 64) for n, (w, x) in enumerate(zip(window, part)))) ** 2 / 8
        wanted = (1 if k in (0, 32) else 2) * dt * power / sum(w * w for w in window)
        # rows that end at rounded times are resampled with some 1e-13 of their neighbours
        t.assertAlmostEqual(spectrum["ship.force_x [N2/Hz]"][k], wanted, delta=1e-9)
        t.assertAlmostEqual(spectrum["frequency [Hz]"][k], k / 1.28, delta=1e-12)
    period = float(results_table(t.folder / "r/statistics.csv")["ship.force_x"]["dominant_period [s]"])
    t.assertAlmostEqual(1 / period, 2.5, delta=1 / 1.28)  # within the resolution


def block_errors(values):
    """Block length → standard error of the mean from the scatter of the means of such blocks, for at least eight of them."""
    errors, block = {}, 1
    while len(values) // block >= 8:
        means = [sum(values[k * block : (k + 1) * block]) / block for k in range(len(values) // block)]
        middle = sum(means) / len(means)
        errors[block] = math.sqrt(sum((mean - middle) ** 2 for mean in means) / len(means) / (len(means) - 1))
        block *= 2
    return errors


@claim("statistics: the standard error of a mean is from blocks longer than the correlation, and marked as a bound where the run has too few of them")
def _(t):
    chance, rows = random.Random(8), 4001
    noise = [chance.gauss(5, 2) for _ in range(rows)]
    gusts = [0.0]
    for _ in range(rows - 1):  # correlated over some ten rows
        gusts.append(0.9 * gusts[-1] + chance.gauss(0, math.sqrt(1 - 0.9**2)))
    slow = [math.sin(3 * math.pi * k / rows) for k in range(rows)]
    write_history(t, [0.25 * k for k in range(rows)], {"ship.force_x [N]": noise, "ship.force_y [N]": gusts, "ship.force_z [N]": slow})
    t.write_kinds("r", loads=["ship.force_x", "ship.force_y", "ship.force_z"])
    out = t.expect_success("statistics", "r").out
    reported = results_table(t.folder / "r/statistics.csv")
    for axis, values, (fewest, most) in (("x", noise, (8, 32)), ("y", gusts, (32, 256))):
        found = float(reported[f"ship.force_{axis}"]["standard_error"])
        errors = block_errors(values[1:])  # the first row has no interval
        block = next(block for block, error in errors.items() if block**3 > 2 * 4000 * max(1, error / errors[1]) ** 4)
        t.assertTrue(fewest <= block <= most, block)
        t.assertAlmostEqual(found / errors[block], 1, delta=1e-9)  # sums of 4000 numbers, in another order
        t.assertEqual(reported[f"ship.force_{axis}"]["standard_error_is_bound"], "0")
    # of 4000 independent values; of values that are correlated (1 + 0.9)/(1 - 0.9) times as many are needed; 60 blocks scatter by 9 %
    t.assertAlmostEqual(float(reported["ship.force_x"]["standard_error"]) * math.sqrt(4000) / 2, 1, delta=0.2)
    t.assertAlmostEqual(float(reported["ship.force_y"]["standard_error"]) * math.sqrt(4000 / 19), 1, delta=0.3)
    t.assertEqual(reported["ship.force_z"]["standard_error_is_bound"], "1")
    t.assertRegex(out, r"\nship.force_z \[N\] +\S+ +>0\.\d+ ")
    t.assertAlmostEqual(float(reported["ship.force_z"]["standard_error"]), max(block_errors(slow[1:]).values()), delta=1e-9)


@claim("statistics: unevenly spaced rows give the same spectral peak as even ones")
def _(t):
    chance, times = random.Random(6), [0.0]
    while times[-1] < 60:
        times.append(times[-1] + chance.uniform(0.02, 0.1))

    def impulse(time):
        return 5 * time - math.cos(2 * math.pi * 0.8 * time) / (2 * math.pi * 0.8)

    force = [0.0] + [(impulse(b) - impulse(a)) / (b - a) for a, b in zip(times, times[1:])]  # of 5 + sin
    write_history(t, times, {"ship.force_x [N]": force, "ship.contacts [-]": [1.0] * len(times)})
    t.expect_success("statistics", "r", "--to", "50", "--segment", "13")
    reported = results_table(t.folder / "r/statistics.csv")["ship.force_x"]
    t.assertAlmostEqual(float(reported["mean"]), 5, delta=1e-3)  # 40 whole periods, less a part of the row in which the last ends
    spectrum = table(t.folder / "r/spectrum.csv")
    resolution = spectrum["frequency [Hz]"][1]
    t.assertAlmostEqual(1 / float(reported["dominant_period [s]"]), 0.8, delta=resolution)
    # means over 0.06 s and over rows of up to 0.1 s take at most 1 - sinc(0.08)^2 - 1 - sinc(0.05)^2 = 3 % of the power of this sine
    t.assertAlmostEqual(sum(spectrum["ship.force_x [N2/Hz]"]) * resolution, 0.5, delta=0.02)


@claim("statistics: forces and torques of gauges belong to the loads, those of boundary conditions do not, and --columns selects any")
def _(t):
    deck = t.deck(("    free_dofs: [y]", "    free_dofs: [y]\n    gauges: {side: {point: [0, 0, 0], axis: [0, 0, 1]}}"),
                  ("  plate:\n    shape", "  plate:\n    particle_sets: {low: {position: [0, -25 mm, 0], shape: {box: {size: [1, 10 mm, 1]}}}}\n"
                                         "    boundary_conditions: {grip: {fixed: {particle_set: low}}}\n    shape"), ("20 us}", "20 us, step: 0.5 us}"))
    t.expect_success("run", deck, "--out", "r")
    t.expect_success("statistics", "r")
    loads = [f"cylinder.{part}{axis}" for part in ("force_", "side.force_") for axis in "xyz"] + ["cylinder.side.torque"]
    t.assertEqual(list(results_table(t.folder / "r/statistics.csv")), loads)
    out = t.expect_success("statistics", "r", "--columns", "plate.grip.force,total.energy").out
    t.assertEqual(list(results_table(t.folder / "r/statistics.csv")), [f"plate.grip.force_{axis}" for axis in "xyz"] + ["total.energy"])
    t.assertIn("spectrum: none, since 10 intervals are fewer than the required 16", out)
    t.assertFalse((t.folder / "r/spectrum.csv").exists())


# a sheet of 80 by 60 cells with two straight cracks: a strip from y = -75 to 45 mm is cut out of it
SHEET = ("shape: {box: {size: [100 mm, 60 mm, 20 mm]}}\n    spacing: 5 mm",
         "shape: {box: {size: [400 mm, 300 mm, 5 mm]}}\n    spacing: 5 mm\n    plane: stress\n    position: [1, 0, 0]\n    cracks:\n"
         "      low: {polygon: [[-201 mm, -75 mm, 0], [201 mm, -75 mm, 0]]}\n      high: {polygon: [[-201 mm, 45 mm, 0], [201 mm, 45 mm, 0]]}")
BREAKS = ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.01")


def sheet(t, *changes):
    return t.deck(SHEET, BREAKS, ("at: [0, 0, 0]", "at: [1, 0, 0]"), ("from: [0, -30 mm, 0], to: [0, 30 mm, 0]", "from: [1, -0.03, 0], to: [1, 0.03, 0]"), *changes)


@claim("statistics: the width of a channel between two cracks is their distance, and its edges are theirs")
def _(t):
    t.expect_success("run", sheet(t), "--out", "r", "--force", "--set", "output.frames=1")
    whole = t.expect_success("statistics", "r", "--channel", "plate:x").out  # the strip is 40 % of the sheet
    t.assertIn("no column is broken through", whole)
    out = t.expect_success("statistics", "r", "--channel", "plate:x", "--sheet", "0.41").out
    t.assertIn("no column is broken through", t.expect_success("statistics", "r", "--channel", "plate:x", "--sheet", "0.2").out)
    # the strips along it have 25 and 35 % of the particles: with 41 % nothing remains, and the whole sheet is broken
    t.assertIn("mean 0.3 m", out)
    cut = t.deck(SHEET, BREAKS, ("at: [0, 0, 0]", "at: [1, 0, 0]"), ("from: [0, -30 mm, 0], to: [0, 30 mm, 0]", "from: [1, -0.03, 0], to: [1, 0.03, 0]"),
                 ("-201 mm, 45 mm", "-201 mm, -45 mm"), ("201 mm, 45 mm", "201 mm, -45 mm"))
    t.expect_success("run", cut, "--out", "r", "--force", "--set", "output.frames=1")  # a strip of 30 mm, 10 % of the sheet
    out = t.expect_success("statistics", "r", "--channel", "plate:x", "--sheet", "0.2", "--channel-from", "0.9", "--channel-to", "1100 mm").out
    for words in ("channel along x in body plate at 2e-05 s (r/frames/plate_00001.vtp)", "length            0.2 m", "mean 0.03 m, standard deviation ",
                  "narrowest         0.03 m", "0.006 m2 of the channel"):
        t.assertIn(words, out)
    columns = table(t.folder / "r/fragments/plate_channel_x.csv")
    t.assertEqual(len(columns["along_x [m]"]), 80)
    for along, low, high, width in zip(*(columns[name] for name in ("along_x [m]", "low_y [m]", "high_y [m]", "width [m]"))):
        for got, wanted in ((low, -0.075), (high, -0.045), (width, 0.03)):
            t.assertAlmostEqual(got, wanted, delta=1e-9)  # places are rounded to a thousandth of a spacing, which these hit
    across = t.expect_success("statistics", "r", "--channel", "plate:y", "--sheet", "0.2").out
    t.assertIn("mean 0.4 m", across)  # along the other axis, the whole sheet is broken through over 30 mm


@claim("statistics: invalid requests are refused with 2 and a sentence, and nothing is written")
def _(t):
    t.expect_success("run", sheet(t, ("20 us}", "20 us, step: 0.5 us}")), "--out", "r")
    t.expect_success("run", t.deck(name="other.yaml"), "--out", "unbroken")
    before = t.files("r")
    for arguments, words in (
        (["nowhere"], ["nowhere/history.csv does not exist", "perimpact run"]),
        (["r", "--from", "1"], ["--from 1 s and --to 2e-05 s leave no time of r/history.csv, whose rows range from 0 to 2e-05 s"]),
        (["r", "--from", "1 us", "--to", "1.0000000001 us"], ["--from and --to are 1e-16 s apart, less than a millionth of the interval between rows of r/history.csv"]),
        (["r", "--to", "1 kg"], ["--to is 1 kg: that is a mass; write a time"]),
        (["r", "--columns", "cylinder.fource_x"], ["--columns: r/history.csv has no column cylinder.fource_x", "did you mean cylinder.force_x?"]),
        (["r", "--windows", "0"], ["--windows: Value 0 not in range", "--help lists the options"]),
        (["r", "--segment", "1 s"], ["--segment is 1 s, but it must cover from 16 rows to all 10"]),
        (["r", "--channel", "plate"], ["--channel is plate, but it must be a body and the axis", "ice:x"]),
        (["r", "--channel", "plate:z"], ["--channel is plate:z"]),
        (["r", "--channel", "ice:x"], ["--channel: r has no body ice; its bodies: plate"]),
        (["unbroken", "--channel", "plate:x"], ["--channel: body plate has no failure criterion"]),
        (["r", "--channel", "plate:x", "--sheet", "2"], ["--sheet is 2, but it must be above 0 and at most 1"]),
        (["r", "--channel", "plate:x", "--channel-from", "2", "--channel-to", "1"], ["--channel-from is 2 m, but it must be below --channel-to, which is 1 m"]),
        (["r", "--channel", "plate:x", "--channel-from", "2 s"], ["--channel-from is 2 s: that is a time; write a length"]),
    ):
        done = t.run_program("statistics", *arguments)
        t.expect_complaint(done, 2, words[0], *words)
        t.assertEqual(done.out, "")
    t.assertEqual(t.files("r"), before)
    (t.folder / "r/history.csv").write_text("time [s],ship.force_x [N],ship.contacts [-]\n0,1,0\n1,nan,0\n")
    t.write_kinds("r", loads=["ship.force_x"])
    t.expect_complaint(t.run_program("statistics", "r"), 2, "r/history.csv:3: ship.force_x [N] is not a finite number", "--to")
    (t.folder / "r/history.csv").write_text("time [s],ship.force_x [N],ship.contacts [-]\n0,1,0\n0,1,0\n")
    t.expect_complaint(t.run_program("statistics", "r"), 2, "r/history.csv:3: time goes from 0 s to 0 s, but it must increase")
    (t.folder / "r/history.csv").write_text("time [s],ice.kinetic_energy [J]\n0,1\n1,1\n")
    t.write_kinds("r")
    t.expect_complaint(t.run_program("statistics", "r"), 2, "r/history.csv has no columns of impactors", "--columns")


@claim("statistics: the channel is where the ice was before it moved, whatever frame is the first")
def _(t):
    t.expect_success("run", sheet(t), "--out", "r", "--set", "output.frames=1", "--set", "bodies.plate.velocity=[1000 m/s, 0, 0]")  # four spacings
    frames = t.folder / "r/frames/plate.pvd"
    first, *others = [line for line in frames.read_text().splitlines() if "<DataSet" in line]
    t.assertEqual(len(others), 1)
    frames.write_text(frames.read_text().replace(first + "\n", ""))
    t.expect_success("statistics", "r", "--channel", "plate:x", "--sheet", "0.41")
    # the sheet is from 0.8 to 1.2 m; frames have single precision, and places are rounded to a thousandth of a spacing
    t.assertAlmostEqual(table(t.folder / "r/fragments/plate_channel_x.csv")["along_x [m]"][0], 0.8025, delta=1e-5)


@claim("statistics: files that are not of the run are neither replaced nor removed")
def _(t):
    t.expect_success("run", t.deck(("history_interval: 2 us", "history_interval: 0.3 us")), "--out", "r")
    for name in ("statistics.csv", "windows.csv", "spectrum.csv", "statistics.csv.part"):
        (t.folder / "r" / name).write_text("mine")
        refused = t.run_program("statistics", "r", "--windows", "2")
        t.expect_complaint(refused, 2, f"r/{name} would be replaced, but r/files.txt does not list it as a file of a run; move or rename it.")
        t.assertEqual((t.folder / "r" / name).read_text(), "mine")
        (t.folder / "r" / name).unlink()
    (t.folder / "r/windows.csv").write_text("mine")
    t.expect_success("statistics", "r")  # writes no windows
    t.assertEqual((t.folder / "r/windows.csv").read_text(), "mine")
    (t.folder / "r/windows.csv").unlink()
    t.expect_success("statistics", "r", "--windows", "2")
    t.expect_success("statistics", "r")  # replaces its own
    t.assertFalse((t.folder / "r/windows.csv").exists())


@claim("statistics: a new run into the same folder removes the statistics of the earlier one")
def _(t):
    t.expect_success("run", sheet(t), "--out", "r", "--force", "--set", "output.frames=1")
    before = t.files("r")
    t.expect_success("statistics", "r", "--windows", "2", "--channel", "plate:x")
    t.assertEqual(sorted(set(t.files("r")) - set(before)), ["fragments/plate_channel_x.csv", "statistics.csv", "windows.csv"])
    t.expect_success("run", sheet(t), "--out", "r", "--force", "--set", "output.frames=1")
    t.assertEqual(t.files("r"), before)


main()
