"""perimpact: peridynamics with continuous contact against rigid bodies of any shape.

    import perimpact

    simulation = perimpact.Simulation.from_deck("deck.yaml", set={"time.end": "50 us"})
    simulation.run()
    force = simulation.history["cylinder.force_y [N]"]

Units are SI. `perimpact.fccda` is the contact library for other codes; `perimpact.modes` makes elastic impactors from finite-element models.
"""

import importlib

from . import fccda
from ._core import Body, Impactor, InputError, Mesh, RunError, Simulation, __version__, read_deck, thread_count, use_threads
from .results import Results

__all__ = ["Body", "Impactor", "InputError", "Mesh", "Results", "RunError", "Simulation", "fccda", "modes", "read_deck", "thread_count", "use_threads"]

for _public in __all__:
    if _public not in ("fccda", "modes", "Results"):
        globals()[_public].__module__ = __name__


def __getattr__(name):
    if name == "modes":  # imported when it is used, since it is also a program: python3 -m perimpact.modes
        return importlib.import_module(".modes", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
