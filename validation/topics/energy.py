"""The balance of energy closes."""

from rows import AtMost, Row, read_columns

TITLE = "Energy closes"
LONG = False
BALL, BRANCHING = "docs/theory/energy/ball.yaml", "cases/crack_branching/deck.yaml"


def closing(folder):
    """The largest closing error of all rows over the energy that changed hands."""
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
    return """Works, losses and energies of a run add up at every row ([energy](theory/energy.md), with more runs)."""


def rows():
    second = "of second order in the step: 1e-6 and less with steps of half the limit"
    return [
        Row("a ball bounces off a clamped block", "what changed hands", "ball", "small", AtMost(1e-5), second),
        Row("a crack runs through glass, 25 µs", "what changed hands", "branching", "small", AtMost(1e-5), second + "; bonds break between"),
        Row("the ball and the block never have more energy than at first, at steps of 0.07 and 0.14 µs", "nothing gives energy", "gain", "small", AtMost(5e-4), "of second order in the step"),
    ]  # fmt: skip
