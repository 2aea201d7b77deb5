"""Makes the package of the tested build and the claims of tests/cli importable, and runs its examples; import it first.

    python3 views.test.py BUILD/perimpact ["the sentence"]      the package lies in BUILD/python
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(Path(sys.argv[1]).resolve().parent / "python"), str(ROOT / "tests" / "cli")]
from claims import MPIRUN_AS_ROOT  # noqa: E402

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


def run_example(test, name, *arguments, launcher=()):
    """What python/examples/<name>.py prints, after it has drawn its figure. `launcher`: words before the command, such as those of mpirun."""
    figure = test.folder / f"{name}.png"
    # a folder of its own for what PySPH compiles; mpirun starts on few processors only if it is told to
    mpi = MPIRUN_AS_ROOT | {"OMPI_MCA_rmaps_base_oversubscribe": "1"}
    environment = {**test.environment, **mpi, "HOME": str(test.folder), "PYTHONPATH": sys.path[0], "MPLBACKEND": "Agg", "OMP_NUM_THREADS": "1", "MPLCONFIGDIR": str(test.folder)}
    command = [*launcher, sys.executable, ROOT / "python" / "examples" / f"{name}.py", figure, *map(str, arguments)]
    done = subprocess.run(command, env=environment, cwd=test.folder, capture_output=True, text=True, timeout=250)
    test.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
    test.assertEqual(figure.read_bytes()[:4], b"\x89PNG")
    return done.stdout


def number_before(text, words):
    return float(re.search(rf"(-?[\d.]+(?:e[-+]\d+)?){re.escape(words)}", text).group(1))


def number_after(text, words):
    return float(re.search(rf"{re.escape(words)}(-?[\d.]+(?:e[-+]\d+)?)", text).group(1))
