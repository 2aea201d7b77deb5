"""A beam for CalculiX in millimetres, tonnes and seconds, of one row of C3D20: 1000 x 100 x 50, along x, without Poisson's ratio.

    python3 beam.py clamped > beam.inp
"""

import sys

ELEMENTS, SIZE = 8, (1000.0, 100.0, 50.0)
YOUNGS_MODULUS, DENSITY = 2.1e5, 7.8e-9  # MPa, t/mm³

# corners, mid-side nodes of the first end, of the second, and between them, in half elements
NODES = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
NODES += [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


def model(is_clamped, modes):
    numbers = {}
    elements = [[numbers.setdefault((2 * e + i, j, k), len(numbers) + 1) for i, j, k in NODES] for e in range(ELEMENTS)]
    lines = ["*NODE, NSET=ALL"]
    for (i, j, k), number in numbers.items():
        lines.append(f"{number}, {SIZE[0] * i / (2 * ELEMENTS)}, {SIZE[1] * j / 2}, {SIZE[2] * k / 2}")
    lines.append("*ELEMENT, TYPE=C3D20, ELSET=BEAM")
    for e, nodes in enumerate(elements, 1):
        lines += [", ".join(map(str, [e, *nodes[:10]])) + ",", ", ".join(map(str, nodes[10:]))]
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNGS_MODULUS}, 0", "*DENSITY", f"{DENSITY}", "*SOLID SECTION, ELSET=BEAM, MATERIAL=STEEL"]
    if is_clamped:
        lines += ["*BOUNDARY"] + [f"{number}, 1, 3" for (i, _, _), number in numbers.items() if i == 0]
    lines += ["*STEP", "*FREQUENCY", f"{modes}", "*NODE FILE", "U", "*EL FILE", "S", "*END STEP"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(model(sys.argv[1] == "clamped", 4), end="")
