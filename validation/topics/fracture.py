"""Dynamic fracture: impact between two notches, and crack branching."""

from rows import AtMost, Row, expected_rows
from runner import ROOT, script_of

TITLE = "Cracks: Kalthoff and Winkler, branching"
LONG = True
KALTHOFF, BRANCHING = "cases/kalthoff_winkler", "cases/crack_branching"


def measure(runner):
    numbers = {}
    for case, short in ((KALTHOFF, "kalthoff"), (BRANCHING, "branching")):
        script = script_of(f"{case}/measure.py")
        folder = runner.run("fracture", short, f"{case}/deck.yaml")
        found = script.measure(folder) if short == "kalthoff" else script.measure(script.frames(folder))
        numbers |= {f"{short} {name.split(' [')[0]}": value for name, value in found.items() if value is not None}
    return numbers


def text(n):
    return f"""[Kalthoff and Winkler](../cases/kalthoff_winkler/README.md): a projectile hits a plate between two notches, and a crack runs from each at an angle. The case shows
what the angle depends on, above all the fracture energy. [Crack branching](../cases/crack_branching/README.md): glass under tension, against an independent program of one page of numpy
([reference.py](../cases/crack_branching/reference.py))."""


def rows():
    kalthoff = {"angle": ("angle of the cracks from the notch line", "°"), "angle right minus left": ("right minus left", "°"), "starts": ("first bond breaks", "µs"),
                "projectile at 65 us": ("projectile at 65 µs", "m/s"), "length": ("length of the cracks", "mm")}  # fmt: skip
    branching = {"starts": ("crack in glass starts", "µs"), "branches at": ("it branches, from the notch tip", "mm"), "branches": ("time of branching", "µs"),
                 "far edge": ("the branches reach the far edge", "µs"), "exit": ("distance of the branches from the centre line there", "mm"), "exit up minus down": ("upper minus lower branch", "mm")}  # fmt: skip
    rows = []
    for case, short, named in ((KALTHOFF, "kalthoff", kalthoff), (BRANCHING, "branching", branching)):
        units, claims = {q: unit for q, (_, unit) in named.items()}, {q: claim for q, (claim, _) in named.items()}
        rows += expected_rows(ROOT / case / "expected.csv", f"{short} ", units=units, claims=claims)
    experiments = "cracks in experiments, final speed 1.5 to 1.6 km/s"
    return [*rows, Row("mean speed of the crack in glass", experiments, "branching mean speed", "km/s", AtMost(1.6e3), "the mean includes the start and is below the final speed")]
