"""perimpact: peridynamics with continuous contact against rigid bodies of any shape.

    import perimpact

    simulation = perimpact.Simulation.from_deck("deck.yaml", set={"time.end": "50 us"})
    simulation.run()
    force = simulation.history["cylinder.force_y [N]"]

Units are SI. `perimpact.fccda` is the contact library for other codes.
"""

from . import fccda
from ._core import Body, Impactor, InputError, Mesh, RunError, Simulation, __version__, read_deck, thread_count, use_threads

__all__ = ["Body", "Impactor", "InputError", "Mesh", "RunError", "Simulation", "fccda", "read_deck", "thread_count", "use_threads"]

for _public in __all__:
    if _public != "fccda":
        globals()[_public].__module__ = __name__
