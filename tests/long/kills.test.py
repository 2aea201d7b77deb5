"""Two hundred kills at any moment, those in which a checkpoint is being written among them."""

import random
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from claims import claim, main  # noqa: E402

KILLS = 200
# 140 steps of 384 particles whose bonds break, with a checkpoint after each
CHANGES = [
    ("time: {end: 20 us}", "time: {end: 14 us, step: 0.1 us}"),
    ("[100 mm, 60 mm, 20 mm]", "[40 mm, 60 mm, 20 mm]"),
    ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002"),
    ("  history_interval: 2 us", "  history_interval: 0.7 us\n  checkpoint_interval: 1 ns"),
]
TELL_OF_TIMES = ("run.json", "report.html", "checkpoint.h5")


def tables_and_pictures(t, folder):
    return {name: (t.folder / folder / name).read_bytes() for name in t.files(folder) if name not in TELL_OF_TIMES}


@claim("kills: two hundred of them at random moments, with a checkpoint after every step, change no bit of the results")
def _(t):
    deck, chance = t.deck(*CHANGES), random.Random(7)
    begun = time.monotonic()
    t.expect_success("run", deck, "--out", "whole")
    duration = time.monotonic() - begun
    whole, state = tables_and_pictures(t, "whole"), t.report("whole")["state_hash"]

    kills = in_writing = resumed = runs = 0
    while kills < KILLS:
        runs += 1
        folder, code = f"r{runs}", None
        while code != 0:
            resume = ["--resume"] if (t.folder / folder / "checkpoint.h5").exists() else ["--force"]
            t.environment["OMP_NUM_THREADS"] = str(chance.choice((1, 2, 3, 4)))
            process = t.start("run", deck, "--out", folder, *resume)
            try:
                _, err = process.communicate(timeout=chance.uniform(0, 0.3 * duration) if kills < KILLS else 300)
            except subprocess.TimeoutExpired:
                process.kill()
                _, err = process.communicate()
            code = process.returncode
            t.assertIn((code, err), ((0, ""), (-9, "")))
            if code != 0:
                kills += 1
                in_writing += (t.folder / folder / "checkpoint.h5.part").exists()
        t.assertEqual(t.report(folder)["state_hash"], state)
        t.assertEqual(tables_and_pictures(t, folder), whole)
        resumed += len(t.report(folder).get("resumed_at_steps", []))
    print(f"{kills} kills, {in_writing} of them while a checkpoint was written; {runs} runs, gone on with {resumed} times, all the same")
    t.assertGreater(in_writing, KILLS // 20)
    t.assertGreater(resumed, KILLS // 4)


main()
