"""What the seed paper concludes, and what we found: its four conclusions, and the two closing characteristics."""

from dataclasses import dataclass

from rows import shown
from topics.plate import FINE

CONFIRMED, LIMITS, NOT = "confirmed", "confirmed with limits", "not confirmed"


@dataclass(frozen=True)
class Conclusion:
    claim: str
    verdict: str
    found: str  # with numbers
    stands_on: tuple  # names of numbers: where a row of one of them fails, so does the verdict


def conclusions(n):
    def count(name):
        return shown(n[name], "count")

    signed = f"{100 * (n['plate.centre'] / n[f'plate.fem_{FINE}mm centre'] - 1):+.2f}".replace("-", "−")
    return [
        Conclusion(
            "1. The contact algorithm can accurately simulate the collision problem in peridynamics",
            LIMITS,
            f"With `swept`, the FCCDA made continuous, the plate's centre is {signed} % from finite elements at 200 µs and the velocity of the cylinder within {n['plate.velocity, all times']:.2f} m/s at all times. "
            f"By the letter of its equations the paper's detector finds no contact at all on that benchmark, and {100 * n['detection.letter']:.0f} % of the crossings of ten shapes; repaired, {100 * n['detection.repaired']:.0f} %.",
            ("plate.centre", "plate.velocity, all times", "panels.letter force", "detection.letter, most", "detection.missed"),
        ),
        Conclusion(
            "2. The mesh size has a weak influence as long as the impactor's shape is adequately modelled",
            CONFIRMED,
            f"Five sizes from 0.1 to 2 mm: the centre differs by {100 * n['panels.spread']:.2f} % at 200 µs, and each by less than three times the depth of its panels below the cylinder, "
            f"Δ_m²/(8R), which is the whole effect. The recommended study of sizes needs nothing but this number.",
            ("panels.spread", *(f"panels.{size} mm off" for size in ("2", "1.5", "1", "0.5", "0.1"))),
        ),
        Conclusion(
            "3. The algorithm has advantages in collisions with objects of complex shapes",
            LIMITS,
            f"`swept` found all of {count('detection.crossings')} crossings of ten shapes, hull, blade and torus among them, and no particle was ever inside the propeller ({count('propeller.looked at')} places). "
            + f"The paper's own detector, repaired, keeps that only where steps are much shorter than flat panels ({100 * n['detection.repaired, flat panels, least']:.0f} % on its worst such shape); on warped quads it is of no use.",
            ("detection.missed", "detection.invented", "detection.left inside", "propeller.inside"),
        ),
        Conclusion(
            "4. The mesh can be refined at sharp changes of shape or on key parts",
            CONFIRMED,
            f"A propeller with panels of 0.15 m, and 0.05 m at edges, {count('propeller.graded panels')} triangles, takes the same peak thrust within {100 * abs(n['propeller.graded off']):.1f} % "
            + f"as one with 0.05 m everywhere, {count('propeller.fine panels')}. It is hardly needed: 0.3 m everywhere, {count('propeller.coarse panels')}, is {100 * abs(n['propeller.coarse off']):.1f} % off, and contact takes at most {100 * n['panels.share']:.1f} % of the plate's run with any panels.",
            ("propeller.graded off", "panels.share"),
        ),
        Conclusion(
            "Characteristic 1: it can be applied to most particle methods, such as SPH",
            CONFIRMED,
            f"SPH in 190 lines on top of the library: {count('coupling.contacts')} contacts of water with a hull, {n['coupling.inside']:.0f} particles inside in any step, momentum kept to {n['coupling.water momentum']:.0e}.",
            ("coupling.contacts", "coupling.inside", "coupling.water momentum"),
        ),
        Conclusion(
            "Characteristic 2: it can be applied where particles are coupled with meshes, such as FEM",
            LIMITS,
            f"Finite elements on top of the library: a bar on a wall has the stress of the wave equation within {100 * abs(n['coupling.stress']):.2f} % and its impulse within {100 * abs(n['coupling.impulse']):.1f} %. The impactor is rigid, and nodes are struck, not faces: "
            "a body sharper than the cells can cut into a face between them. A mesh that deforms as the impactor, coupled to particles, has not been tried.",
            ("coupling.stress", "coupling.impulse", "coupling.wedge inside"),
        ),
    ]
