"""What the columns of history.csv are, and that no setting of the output changes what a run finds."""

import csv
import json
import signal
import time

from claims import claim, main, table


def kinds_of(t, folder):
    columns = json.loads((t.folder / folder / "history.json").read_text())["columns"]
    return {f"{one['name']} [{one['unit']}]": one["kind"] for one in columns}


def results_table(path):
    with open(path, newline="") as file:
        return {row["column"]: row for row in csv.DictReader(file)}


FLOATING = ("    free_dofs: [y]", "    free_dofs: [x, y, z]\n    floating: {level: 0, damping: 100}")


@claim("columns: history.json gives unit and kind of every column of history.csv, during a run, after it was killed, and after a restart")
def _(t):
    deck = t.deck(FLOATING, ("end: 20 us", "end: 400 us"), ("  history_interval: 2 us", "  history_interval: 2 us\n  checkpoint_interval: 20 us"))
    going = t.start("run", deck, "--out", "r", "--force")
    history = t.folder / "r/history.csv"
    while not (t.folder / "r/checkpoint.h5").exists() or history.read_bytes().count(b"\n") < 4:
        t.assertIsNone(going.poll())
        time.sleep(0.005)
    going.send_signal(signal.SIGKILL)
    going.communicate()
    t.assertFalse((t.folder / "r/run.json").exists())
    killed = kinds_of(t, "r")
    t.assertEqual(list(killed), list(t.history("r")))
    wanted = {"time [s]": "instantaneous", "cylinder.position_y [m]": "instantaneous", "cylinder.force_y [N]": "interval mean",
              "cylinder.moment_z [N m]": "interval mean", "cylinder.water_force_z [N]": "interval mean", "cylinder.water_moment_x [N m]": "interval mean",
              "cylinder.displaced_mass [kg]": "instantaneous", "cylinder.contact_work [J]": "cumulative", "plate.broken_bonds [-]": "cumulative",
              "plate.kinetic_energy [J]": "instantaneous", "total.contact_dissipation [J]": "cumulative", "total.momentum_x [kg m/s]": "instantaneous"}
    t.assertEqual({column: killed[column] for column in wanted}, wanted)
    t.expect_success("statistics", "r")
    t.expect_success("run", deck, "--out", "r", "--resume")
    t.assertEqual(kinds_of(t, "r"), killed)
    t.expect_success("statistics", "r", "--columns", "cylinder.water_force")


@claim("columns: the mean of a water force times the time is the momentum from the water")
def _(t):
    # without contact, only weight, buoyancy and damping move it
    deck = t.deck(FLOATING, ("position: [0, 50 mm, 0]", "position: [0, 2, 5 mm]"), ("velocity: [0, -32 m/s, 0]", "velocity: [0, 0, -2]"), ("end: 20 us", "end: 400 us"),
                  ("history_interval: 2 us", "history_interval: 133 us"))
    t.expect_success("run", deck, "--out", "r")
    t.expect_success("statistics", "r", "--columns", "cylinder.water_force_z")
    mean = float(results_table(t.folder / "r/statistics.csv")["cylinder.water_force_z"]["mean"])
    history = t.history("r")
    speed, seconds = history["cylinder.velocity_z [m/s]"], history["time [s]"]
    gained = 1 * (speed[-1] - speed[0])  # of 1 kg
    t.assertGreater(abs(gained), 1e-4)
    t.assertAlmostEqual(mean * (seconds[-1] - seconds[0]) / gained, 1, delta=1e-9)  # speeds of 2 m/s round at 4e-16, and 0.01 m/s are gained


@claim("columns: interval means count for the time before their row, values are interpolated linearly")
def _(t):
    (t.folder / "r").mkdir()
    (t.folder / "r/history.csv").write_text("time [s],ship.water_force_z [N],ship.force_x [N]\n0,0,0\n1,10,10\n3,40,40\n")
    t.write_kinds("r", ship_water_force_z="interval mean")
    t.expect_success("statistics", "r", "--columns", "ship")
    reported = results_table(t.folder / "r/statistics.csv")
    t.assertAlmostEqual(float(reported["ship.water_force_z"]["mean"]), (10 * 1 + 40 * 2) / 3, delta=1e-12)
    t.assertAlmostEqual(float(reported["ship.force_x"]["mean"]), (5 * 1 + 25 * 2) / 3, delta=1e-12)


@claim("columns: output.history_interval changes no pressure of a panel, nor the pressures at the peak")
def _(t):
    found = []
    for history in ("40 us", "2 us", "0.3 us"):
        deck = t.deck(("end: 20 us", "end: 40 us"), ("history_interval: 2 us", f"history_interval: {history}"))
        t.expect_success("run", deck, "--out", "r", "--force", "--no-report")
        found.append({name: (t.folder / "r" / name).read_bytes() for name in t.files("r") if name.startswith("frames/cylinder") or name.endswith("_at_peak.csv")})
    t.assertEqual(len(found[0]), 1 + 5 + 1)  # the list of frames, the frames, the curve
    t.assertGreater(max(table(t.folder / "r/pressure_area/cylinder_at_peak.csv")["mean_pressure [Pa]"]), 0)
    t.assertTrue(found[0] == found[1] == found[2])


main()
