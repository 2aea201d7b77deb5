"""A small block of particles beside the place where a surface reaches furthest in one direction, struck by the surface from there."""

from typing import NamedTuple

import numpy as np
from vtp_reader import read_vtp

# A soft body, struck at a fifth of the speed sqrt(E/rho): a step of a quarter of the time that sound takes from particle to particle is
# stable, and in a hundred of them the surface moves by five particles, so that it goes deep into a block six particles thick.
YOUNGS_MODULUS, DENSITY = 1e6, 1000.0  # [Pa] [kg/m3]
SOUND = (YOUNGS_MODULUS / DENSITY) ** 0.5  # [m/s]
SPEED, STEPS, ROWS = SOUND / 5, 100, 20
ACROSS, THICK = 15, 6  # particles
BREAKS = 0.1  # critical stretch
DRIFT = 1e-12  # rounding of what a run sums in a hundred steps and a thousand particles; measured are 1e-15

DECK = """\
title: Struck by {file.name}
time: {{end: {end}, step: {step}}}
bodies:
  block:
    shape: {{box: {{size: {size}}}}}
    spacing: {spacing}
    position: {position}
    material: {{model: ordinary-state, youngs_modulus: {youngs_modulus}, poissons_ratio: 0.25, density: {density}, critical_stretch: {breaks}}}
impactors:
  striker:
    surface: {{file: "{file}", translate: {translate}{outside}}}
    mass: {mass}
    velocity: {velocity}
    free_dofs: [x, y, z]
output: {{folder: results, frames: 1, history_interval: {history}}}
"""


class Outcome(NamedTuple):
    touched: bool
    entered: int  # particles that came in where the surface is not felt, as the run tells
    unresolved: int
    crossed: int  # particles that ended on another side of the surface than they began on
    drift: float  # of the momentum of block and surface together, as a share of what the surface brought


class Strike:
    """The scene, whose origin is the surface's furthest point in `direction` ("+x"), given its corners (n, 3, 3)."""

    def __init__(self, file, corners, direction, spacing, outside=None):
        axis, sign = "xyz".index(direction[1]), {"+": 1, "-": -1}[direction[0]]
        towards = sign * np.eye(3)[axis]
        points = corners.reshape(-1, 3)
        self.furthest = points[np.argmax(points @ towards)]
        self.corners = corners - self.furthest
        self.step = 0.25 * spacing / SOUND
        counts = np.where(np.arange(3) == axis, THICK, ACROSS)
        # a contact radius and a quarter of a spacing lie between; a little to the side, so that no particle lies in a plane of symmetry
        aside = np.array([0.137, 0.291, 0.219]) * spacing * (np.arange(3) != axis)
        self.mass = 10 * DENSITY * spacing**3 * counts.prod()
        self.velocity = SPEED * towards
        self.spacing = spacing
        self.text = DECK.format(
            file=file, outside=f", orientation: {outside}" if outside else "", spacing=spacing, size=(spacing * counts).tolist(), mass=self.mass,
            position=(aside + towards * spacing * (0.5 * THICK + 0.25)).tolist(), translate=(-self.furthest).tolist(),
            velocity=self.velocity.tolist(), step=self.step, end=STEPS * self.step, history=STEPS // ROWS * self.step,
            youngs_modulus=YOUNGS_MODULUS, density=DENSITY, breaks=BREAKS,
        )  # fmt: skip

    def outcome(self, report, history, frames):
        """What run.json, the columns of history.csv and the pictures say."""
        columns = lambda name, unit: np.array([history[f"{name}_{axis} [{unit}]"] for axis in "xyz"])
        way = columns("striker.position", "m")
        momentum = columns("total.momentum", "kg m/s")
        detection = report["impactors"]["striker"]["detection"]["block"]
        begin, end = (read_vtp(frames / f"block_{k:05}.vtp").points.astype(float) for k in (0, 1))
        return Outcome(
            touched=max(history["striker.contacts [-]"]) > 0,
            entered=detection["entered_inside"],
            unresolved=detection["unresolved_penetrations"],
            # seen from the surface, the straight way from where a particle was to where it is goes through it an odd number of times
            crossed=int((crossings(begin, end - (way[:, -1] - way[:, 0]), self.corners) % 2).sum()),
            drift=np.abs(momentum - momentum[:, :1]).max() / (self.mass * SPEED),
        )


def run(t, path, corners, direction, spacing, outside):
    """What comes of a strike; the program must end well, keep momentum and pinch nothing."""
    scene = Strike(path, corners, direction, spacing, outside)
    (t.folder / "deck.yaml").write_text(scene.text)
    t.expect_success("run", "deck.yaml", "--force", "--threads", 1)
    outcome = scene.outcome(t.report("results"), t.history("results"), t.folder / "results/frames")
    t.assertLess(outcome.drift, DRIFT, (path.name, direction))
    t.assertEqual(outcome.unresolved, 0, (path.name, direction))
    return outcome


def crossings(begin, end, corners):
    """How many triangles each segment goes through (Möller and Trumbore, Journal of Graphics Tools 2 (1997) 21)."""
    lowest, highest = corners.min(axis=1), corners.max(axis=1)

    def near(low, high):
        return np.flatnonzero((lowest <= high).all(axis=1) & (highest >= low).all(axis=1))

    def through(begin, way, a, ab, ac):
        """(segments, triangles)"""
        p = np.cross(way[:, None], ac)
        from_a = begin[:, None] - a
        q = np.cross(from_a, ab)
        with np.errstate(divide="ignore", invalid="ignore"):  # a triangle along the way is not gone through: comparisons with nan are false
            scale = 1 / np.einsum("tj,stj->st", ab, p)
            u, v = scale * np.einsum("stj,stj->st", from_a, p), scale * np.einsum("sj,stj->st", way, q)
            t = scale * np.einsum("tj,stj->st", ac, q)
            return (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0) & (t <= 1)

    count = np.zeros(len(begin), int)
    for row in np.split(np.arange(len(begin)), range(ACROSS, len(begin), ACROSS)):  # neighbours share the triangles that are near
        low, high = np.minimum(begin[row], end[row]).min(axis=0), np.maximum(begin[row], end[row]).max(axis=0)
        a, b, c = corners[near(low, high)].transpose(1, 0, 2)
        count[row] = through(begin[row], end[row] - begin[row], a, b - a, c - a).sum(axis=1)
    return count
