"""Makes the package of the tested build and the claims of tests/cli importable; import it first.

    python3 views.test.py BUILD/perimpact ["the sentence"]      the package lies in BUILD/python
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(Path(sys.argv[1]).resolve().parent / "python"), str(ROOT / "tests" / "cli")]

# The deck of claims.py with Python numbers, in SI.
SETUP = {
    "title": "Small plate",
    "time": {"end": 20e-6},
    "bodies": {
        "plate": {
            "shape": {"box": {"size": [0.1, 0.06, 0.02]}},
            "spacing": 0.005,
            "material": {"model": "ordinary-state", "youngs_modulus": 191e9, "poissons_ratio": 0.25, "density": 8000},
        }
    },
    "impactors": {
        "cylinder": {
            "surface": {"cylinder": {"diameter": 0.04, "height": 0.04, "axis": "z", "edge_length": 0.004}},
            "mass": 1,
            "position": [0, 0.05, 0],
            "velocity": [0, -32, 0],
            "free_dofs": ["y"],
        }
    },
    "contact": {"impactors": {"detector": "swept"}},
    "output": {
        "folder": "results",
        "frames": 4,
        "history_interval": 2e-6,
        "probes": {"centre": {"body": "plate", "at": [0, 0, 0]}},
        "lines": {"along_y": {"body": "plate", "from": [0, -0.03, 0], "to": [0, 0.03, 0]}},
    },
}
