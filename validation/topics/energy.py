"""The balance of energy closes."""

from rows import AtMost, Row, Within, read_columns

TITLE = "Energy closes"
LONG = False
BALL, BRANCHING = "docs/theory/energy/ball.yaml", "cases/crack_branching/deck.yaml"


def closing(folder):
    """The largest closing error of all rows over the energy that changed hands."""
    history = read_columns(folder / "history.csv")
    works = [name for name in history if name.endswith((".contact_work [J]", ".work [J]"))]
    return max(map(abs, history["total.closing_error [J]"])) / sum(max(map(abs, history[name])) for name in works)


def measure(runner):
    steps = {step: runner.run("energy", f"ball_{step}", BALL, f"time.step={step} us") for step in ("0.14", "0.07")}
    gains = {step: read_columns(folder / "history.csv")["total.energy [J]"][-1] - 1.65 for step, folder in steps.items()}
    return {
        "ball": closing(steps["0.07"]),
        "branching": closing(runner.run("energy", "branching", BRANCHING, "time.end=25 us", "output.frames=1")),
        "gain": gains["0.07"] / 1.65,
        "gain halves": gains["0.14"] / gains["0.07"],
    }


def text(n):
    return f"""Works, losses and energies of a run add up at every row ([energy](theory/energy.md), with more runs). What does not go away is told too: a light
impactor that is pushed back gains energy of first order in the step, a ball of 33 g {100 * n["gain"]:.1f} % of its own with the step of the deck."""


def rows():
    second = "of second order in the step: 1e-6 and less with steps of half the limit"
    return [
        Row("a ball bounces off a clamped block", "what changed hands", "ball", "small", AtMost(1e-5), second),
        Row("a crack runs through glass, 25 µs", "what changed hands", "branching", "small", AtMost(1e-5), second + "; bonds break between"),
        Row("the ball's gain is of first order: with twice the step, so much more", "F² T Δt/M", "gain halves", "", Within(2, 0.2), "terms of second order, a tenth"),
    ]  # fmt: skip
