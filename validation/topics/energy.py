"""The energy balance."""

from rows import AtMost, Row, read_columns

TITLE = "Energy balance"
LONG = False
BALL, BRANCHING = "docs/theory/energy/ball.yaml", "cases/crack_branching/deck.yaml"


def closing(folder):
    """The largest energy balance error of all rows over the energy exchanged."""
    history = read_columns(folder / "history.csv")
    works = [name for name in history if name.endswith((".contact_work [J]", ".work [J]"))]
    return max(map(abs, history["total.energy_balance_error [J]"])) / sum(max(map(abs, history[name])) for name in works)


def measure(runner):
    steps = {step: runner.run("energy", f"ball_{step}", BALL, f"time.step={step} us") for step in ("0.14", "0.07")}
    energies = {step: read_columns(folder / "history.csv")["total.energy [J]"] for step, folder in steps.items()}
    return {
        "ball": closing(steps["0.07"]),
        "branching": closing(runner.run("energy", "branching", BRANCHING, "time.end=25 us", "output.frames=1")),
        "gain": max(max(energy) for energy in energies.values()) / 1.65 - 1,
    }


def text(n):
    return """Work, dissipation and energies of a run balance in every row of the history. More runs: [energy](theory/energy.md)."""


def rows():
    second = "second order in the step: 1e-6 and less at half the critical step"
    return [
        Row("a ball rebounds from a clamped block", "energy exchanged", "ball", "small", AtMost(1e-5), second),
        Row("a crack runs through glass, 25 µs", "energy exchanged", "branching", "small", AtMost(1e-5), second + "; bonds break meanwhile"),
        Row("the energy of ball and block never exceeds the initial energy, at steps of 0.07 and 0.14 µs", "no source of energy", "gain", "small", AtMost(5e-4), "second order in the step"),
    ]  # fmt: skip
