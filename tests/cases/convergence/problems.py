"""Problems with exact solutions, as decks of the whole program: what docs/theory/convergence.py and convergence.test.py share.

A problem is a function of a body (material, state of the plane, layers, horizon ratio) and of `run`, which runs a deck and
gives what it left. It returns errors by the name of a quantity: relative to the exact solution, signed where it is a number
(program/exact − 1), a norm where it is a field (|program − exact|/|exact|, root of the sum of squares over particles).

Lengths in metres, steel. Bars and plates are strained by 1e-6, so that what is of second order in strain is below all that is measured
here. Beams are bent by 1e-3 of their length: the square of that is small too, and a thousandth of it would be too little, because
rounding then ends the relaxation when the stiffness of 16 layers is still 0.6 % off (it is so small against that of a bond).
"""

import json
import sys
from dataclasses import dataclass
from math import ceil, pi, sqrt
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts/results"))
from vtp_reader import read_vtp  # noqa: E402

YOUNG, DENSITY = 200e9, 8000.0  # [Pa] [kg/m3]
SPEED = sqrt(YOUNG / DENSITY)  # of a long wave in a bar: 5000 m/s
STRESS = 1e-6 * YOUNG
HEIGHT = 0.1  # of bars and beams, and their breadth [m]
TOLERANCE = 1e-7  # of the relaxation: a tenth of it changes the stiffness of a cantilever of 16 layers by 1e-5; the default 1e-4 is not enough for it


@dataclass(frozen=True)
class Body:
    """`layers`: through the height of a bar; of the plate, in the radius of its hole. `horizon`: in spacings."""

    layers: int
    model: str = "ordinary-state"
    poisson: float = 0.3
    plane: str = "none"
    horizon: float = 3.015
    correction: str = "automatic"
    stabilisation: float = 1  # of correspondence: stabilisation_factor

    def name(self):
        name = f"{self.model} nu={self.poisson:.3g} plane={self.plane} {self.layers} layers m={self.horizon:g} {self.correction}"
        return name + (f" stabilisation={self.stabilisation:g}" if self.model == "correspondence" else "")

    def deck(self, spacing, shape):
        material = {"model": self.model, "youngs_modulus": YOUNG, "density": DENSITY}
        if self.model != "bond-based":  # which has 1/4 in space and 1/3 in plane stress, whatever a deck says
            material["poissons_ratio"] = self.poisson
        if self.model == "correspondence":
            material["stabilisation"] = "wan"  # of which the page tells
            material["stabilisation_factor"] = self.stabilisation
        keys = {"plane": self.plane, "horizon_ratio": self.horizon, "surface_correction": self.correction}
        return {"spacing": spacing, "shape": shape, "material": material, **keys}


class Frame:
    """Places in the undeformed body, displacements and time of a picture."""

    def __init__(self, path, first):
        picture = read_vtp(path)
        self.time, self.places, self.moved = picture.time, first.points.astype(float), picture.point["displacement"].astype(float)

    def sections(self, spacing):
        """x of the layers of particles across the bar, and the mean displacement of each."""
        layer = np.rint((self.places[:, 0] - self.places[:, 0].min()) / spacing).astype(int)
        count = np.bincount(layer)
        mean = [np.bincount(layer, self.moved[:, p]) / count for p in range(3)]
        return np.bincount(layer, self.places[:, 0]) / count, np.stack(mean, axis=1)


class Result(Frame):
    """What a run left: the last picture, and what it says of itself."""

    def __init__(self, folder):
        folder = Path(folder)
        self.pictures = sorted((folder / "frames").glob("*.vtp"))
        self.first = read_vtp(self.pictures[0])
        super().__init__(self.pictures[-1], self.first)
        self.report = json.loads((folder / "run.json").read_text())
        self.particles = self.report["bodies"]["body"]["particles"]

    def frame(self, number):
        return Frame(self.pictures[number], self.first)


def relaxed(title, body):
    relax = {"increments": 1, "tolerance": TOLERANCE, "max_iterations": 1_000_000}
    return {"title": title, "time": {"end": 1, "relax": relax}, "bodies": {"body": body}, "output": {"frames": 1, "checkpoint_interval": 0}}


def box(*size):
    return {"box": {"size": list(size)}}


def region(first, last):
    """All that lies between two x."""
    return {"shape": box(last - first, 10 * HEIGHT, 10 * HEIGHT), "position": [0.5 * (first + last), 0, 0]}


def pulled_at_both_ends():
    return {name: {"pressure": {"face": face, "value": -STRESS}} for name, face in (("left", "-x"), ("right", "+x"))}


def relative_norm(computed, exact):
    return float(np.linalg.norm(computed - exact) / np.linalg.norm(exact))


def slope(x, y):
    x = x - x.mean()
    return float((x @ y) / (x @ x))


# -- a bar, pulled at both ends ---------------------------------------------------------------------------------------


def bar(body, run):
    """10 H long, both ends pulled by a pressure on the outermost layer: u = (σ/E) (x, −ν y, −ν z).

    strain, contraction: least squares over the middle half of the length; core: contraction of the inner half of the height
    there. extension: of the ends' layers, ends included.
    """
    spacing, length = HEIGHT / body.layers, 10 * HEIGHT
    keys = body.deck(spacing, box(length, HEIGHT, HEIGHT))
    keys["boundary_conditions"] = pulled_at_both_ends()
    result = run(f"bar {body.name()}", relaxed("A bar in tension", keys))
    strain = STRESS / YOUNG
    x, y = result.places[:, 0], result.places[:, 1]
    middle = np.abs(x) < length / 4
    core = middle & (np.abs(y) < HEIGHT / 4)
    at, mean = result.sections(spacing)
    return result, {
        "strain": slope(x[middle], result.moved[middle, 0]) / strain - 1,
        "contraction": slope(y[middle], result.moved[middle, 1]) / (-body.poisson * strain) - 1,
        "core": slope(y[core], result.moved[core, 1]) / (-body.poisson * strain) - 1,
        "extension": (mean[-1, 0] - mean[0, 0]) / (strain * (at[-1] - at[0])) - 1,
    }


def block(body, run):
    """1 × 0.1 × 0.1 m, clamped as deep as the horizon, loaded by a body force in the last layer (Madenci and Oterkus 2014, 8.5).

    u_x = σ x/E from the clamp's face on. end: u_x of the last layer. field: mean displacements of all free sections.
    """
    spacing, length = HEIGHT / body.layers, 10 * HEIGHT
    depth = ceil(body.horizon - 0.1) * spacing
    keys = body.deck(spacing, box(length + depth, HEIGHT, HEIGHT))
    keys["position"] = [0.5 * (length - depth), 0, 0]  # regions are placed from here
    shift = -keys["position"][0]
    keys["regions"] = {"clamp": region(shift - 2 * depth, shift), "last": region(shift + length - spacing, shift + length + spacing)}
    keys["boundary_conditions"] = {"clamp": {"fixed": {"particle_set": "clamp"}}, "pull": {"body_force": {"particle_set": "last", "force_density": [STRESS / spacing, 0, 0]}}}
    result = run(f"block {body.name()}", relaxed("A block under tension", keys))
    x, mean = result.sections(spacing)
    free = x > 0
    exact = STRESS / YOUNG * x[free]
    return result, {"end": mean[-1, 0] / exact[-1] - 1, "field": relative_norm(mean[free, 0], exact)}


def lattice_moduli(horizon, poisson, plane):
    """Young's modulus and Poisson's ratio along an axis, and the shear modulus, of an endless lattice, over those asked for.

    ordinary-state with its default family and normalisation: sums over a family written out, and nothing of the program.
    """
    reach = int(horizon + 1)
    steps = [np.arange(-reach, reach + 1)] * (2 if plane == "stress" else 3)
    offsets = np.stack([axis.ravel() for axis in np.meshgrid(*steps)], axis=1).astype(float)
    lengths = np.linalg.norm(offsets, axis=1)
    inside = (lengths > 0) & (lengths < horizon + 0.5)
    offsets, lengths = offsets[inside], lengths[inside]
    part = np.minimum(1, horizon + 0.5 - lengths)
    n = offsets / lengths[:, None]
    dimension, shear = n.shape[1], 0.5 / (1 + poisson)
    bulk, share = (0.5 / (1 - poisson), 2) if dimension == 2 else (1 / (3 - 6 * poisson), 5 / 3)
    a = 0.5 * (bulk - share * shear)
    pull = n[:, 0] ** 2 - poisson * (1 - n[:, 0] ** 2)
    trace = 1 - (dimension - 1) * poisson
    d = trace / (pull * part).sum()
    b = (0.5 - a * trace**2) / (pull**2 * lengths * part).sum()

    def energy(stretch):
        return a * (d * (stretch * part).sum()) ** 2 + b * (stretch**2 * lengths * part).sum()

    c11 = 2 * energy(n[:, 0] ** 2)
    c12 = energy(n[:, 0] ** 2 + n[:, 1] ** 2) - c11
    c44 = 2 * energy(n[:, 0] * n[:, 1])
    found = c12 / c11 if dimension == 2 else c12 / (c11 + c12)
    return {"E": c11 - (dimension - 1) * c12 * found, "ν": found / poisson, "µ": c44 / shear}


# -- a wave in a bar --------------------------------------------------------------------------------------------------


def wave(body, run, sudden):
    """A bar 40 H long at rest, of which an end is pushed: d'Alembert, u = (c/E) ∫ p dτ from 0 to t − x/c, c = √(E/ρ).

    Pushed for good from t = 0 on (sudden), or by p sin² for 0.4 of the time in which a wave runs through. field: mean
    displacements of sections after 0.7 of that time. love: the same against Love's bar, which has the inertia
    of its bulging across. speed: from where displacements fall through half of the last one (sudden: a tenth of the bar's
    length times the strain) after 0.35 and after 0.7 of that time; arrival: how far that place has come at the end.
    """
    length = 1.0
    height = length / 40
    spacing, crossing = height / body.layers, length / SPEED
    duration = 0.4 * crossing
    times = np.linspace(0, duration, 101)
    factors = np.sin(pi * times / duration) ** 2
    factors[[0, -1]] = 0
    push = {"face": "-x", "value": STRESS}
    if not sudden:
        push.update(times=times.tolist(), factors=factors.tolist())
    keys = body.deck(spacing, box(length, height, height))
    keys["position"] = [length / 2, 0, 0]
    keys["boundary_conditions"] = {"push": {"pressure": push}}
    deck = {"title": "A wave in a bar", "time": {"end": 0.7 * crossing}, "bodies": {"body": keys}}
    # Rows of the history no closer than some ten steps: in the first steps of a load that begins at nothing the check of energy, which is
    # made with them, sees kinetic energy of the next half step that no work has paid yet.
    deck["output"] = {"frames": 2, "history_interval": 0.07 * crossing, "checkpoint_interval": 0}
    result = run(f"{'step' if sudden else 'pulse'} {body.name()}", deck)

    fine = np.linspace(0, crossing, 100_001)
    pressure = STRESS * (np.ones_like(fine) if sudden else np.interp(fine, times, factors, right=0.0))
    displacement = SPEED / YOUNG * np.concatenate([[0], np.cumsum(0.5 * (pressure[1:] + pressure[:-1]) * np.diff(fine))])
    level = 0.1 * STRESS * length / YOUNG if sudden else 0.5 * displacement[-1]
    age = np.interp(level, displacement, fine)

    def fallen(frame):
        x, mean = frame.sections(spacing)
        last = np.flatnonzero(mean[:, 0] >= level)[-1]
        share = (mean[last, 0] - level) / (mean[last, 0] - mean[last + 1, 0])
        return x[last] + share * (x[last + 1] - x[last])

    gyration = height**2 / (12 if body.plane == "stress" else 6)
    half_way = result.frame(1)
    x, mean = result.sections(spacing)
    return result, {
        "speed": (fallen(result) - fallen(half_way)) / (result.time - half_way.time) / SPEED - 1,
        "arrival": fallen(result) / (SPEED * (result.time - age)) - 1,
        "field": relative_norm(mean[:, 0], np.interp(result.time - x / SPEED, fine, displacement, left=0.0)),
        "love": relative_norm(mean[:, 0], love_bar(x, result.time, fine, pressure, body.poisson**2 * gyration)),
    }


def love_bar(x, time, times, pressure, inertia):
    """Displacements of Love's bar, ρ u_tt = E u_xx + ρ ν² K² u_xxtt, half of one without ends that is pushed by 2 p at x = 0.

    `inertia`: ν² K² [m2]. A period of 4 m is never run through; 4000 waves resolve 1 mm.
    """
    push = np.where(times <= time, pressure, 0.0)[::20]
    instants, interval = times[::20], 20 * (times[1] - times[0])
    push[0] *= 0.5  # the ends of the trapezoidal rule; at the other one the response is 0
    u = np.zeros_like(x)
    for n in range(4001):
        k = 2 * pi * n / 4
        mass = DENSITY * (1 + inertia * k * k)
        frequency = sqrt(YOUNG * k * k / mass)
        age = np.maximum(time - instants, 0)
        response = np.sin(frequency * age) / frequency if n else age
        u += (1 if n == 0 else 2) * (2 * push @ response * interval / mass) * np.cos(k * x) / 4
    return u


def step(body, run):
    return wave(body, run, sudden=True)


def pulse(body, run):
    return wave(body, run, sudden=False)


# -- beams ------------------------------------------------------------------------------------------------------------


def bending_stiffness():
    return YOUNG * HEIGHT**4 / 12  # a square section, in the plane a strip as thick as it is high [N m2]


def shear_stiffness(body):
    """κ G A with Cowper's κ = 10 (1 + ν)/(12 + 11 ν) of a rectangle (J. Appl. Mech. 33 (1966) 335) [N]."""
    return 10 * (1 + body.poisson) / (12 + 11 * body.poisson) * YOUNG / (2 * (1 + body.poisson)) * HEIGHT**2


def compliance(x, w, curve):
    """The factor of `curve` in w, beside a rigid motion: least squares."""
    return float(np.linalg.lstsq(np.stack([curve, x, np.ones_like(x)], axis=1), w, rcond=None)[0][0])


def force_for(deflection, length, times):
    return deflection * times * bending_stiffness() / length**3


def cantilever(body, run):
    """10 H long, clamped H deep, loaded by a force over the last H/2 of its length.

    tip: deflection below the middle of the load against w = P L³/3EI + P L/κGA. stiffness: what the deflections between H
    and 8.5 H say of EI, when a rigid motion is left aside; there Saint-Venant's solution has the very curve of the
    elementary theory, whatever the clamp and the load do nearby.
    """
    spacing, length, loaded = HEIGHT / body.layers, 10 * HEIGHT, HEIGHT / 2
    keys = body.deck(spacing, box(length + HEIGHT, HEIGHT, HEIGHT))
    shift = -(length - HEIGHT) / 2
    keys["position"] = [-shift, 0, 0]
    keys["regions"] = {"clamp": region(shift - 2 * HEIGHT, shift), "tip": region(shift + length - loaded, shift + length + spacing)}
    arm = length - loaded / 2
    force = force_for(1e-3 * length, arm, 3)
    density = force / (loaded * HEIGHT**2)
    keys["boundary_conditions"] = {"clamp": {"fixed": {"particle_set": "clamp"}}, "load": {"body_force": {"particle_set": "tip", "force_density": [0, -density, 0]}}}
    result = run(f"cantilever {body.name()}", relaxed("A cantilever", keys))
    x, mean = result.sections(spacing)
    curve = force * x**2 * (3 * arm - x) / (6 * bending_stiffness())
    inner = (x > HEIGHT) & (x < length - 1.5 * HEIGHT)
    tip = float(np.interp(arm, x, -mean[:, 1]))
    exact = force * arm**3 / (3 * bending_stiffness()) + force * arm / shear_stiffness(body)
    return result, {"tip": tip / exact - 1, "stiffness": 1 / compliance(x[inner], -mean[inner, 1], curve[inner]) - 1}


def three_points(body, run):
    """A beam on two columns of particles that are held upright, 10 H apart, and loaded in the column half-way between.

    middle: deflection against w = P L³/48EI + P L/4κGA. stiffness: as in the cantilever, more than H away from load and
    supports.
    """
    spacing, length = HEIGHT / body.layers, 10 * HEIGHT
    keys = body.deck(spacing, box(length + spacing, HEIGHT, HEIGHT))
    places = {"left": -length / 2, "right": length / 2, "load": 0.0}
    keys["regions"] = {name: region(x - 0.5 * spacing, x + 0.5 * spacing) for name, x in places.items()}
    force = force_for(1e-3 * length, length, 48)
    keys["boundary_conditions"] = {name: {"fixed": {"particle_set": name, "directions": ["y"]}} for name in ("left", "right")}
    keys["boundary_conditions"]["push"] = {"body_force": {"particle_set": "load", "force_density": [0, -force / (spacing * HEIGHT**2), 0]}}
    result = run(f"three points {body.name()}", relaxed("Three-point bending", keys))
    x, mean = result.sections(spacing)
    from_support = length / 2 - np.abs(x)
    curve = force * from_support * (3 * length**2 - 4 * from_support**2) / (48 * bending_stiffness())
    inner = (from_support > HEIGHT) & (np.abs(x) > HEIGHT)
    sides = np.stack([curve, np.abs(x), np.ones_like(x)], axis=1)[inner]  # the two halves mirror one another
    found = float(np.linalg.lstsq(sides, -mean[inner, 1], rcond=None)[0][0])
    middle = -mean[np.argmin(np.abs(x)), 1]
    exact = force * length**3 / (48 * bending_stiffness()) + force * length / (4 * shear_stiffness(body))
    return result, {"middle": middle / exact - 1, "stiffness": 1 / found - 1}


# -- a plate with a hole ----------------------------------------------------------------------------------------------


class HoleInSquare:
    """Plane stress in a square of half-width W with a hole of radius a, pulled along x: exact, with its finite width.

    Kolosov and Muskhelishov's two functions φ and ψ are sums of the odd powers of z with real coefficients (symmetry
    about both axes), found by least squares of the tractions at hole and edges. W → ∞ leaves Kirsch's solution.
    """

    def __init__(self, radius, half_width, poisson, terms=24):
        self.radius, self.half_width, self.poisson = radius, half_width, poisson
        self.powers = np.arange(-2 * terms + 1, 2 * terms, 2)
        self.scale = np.where(self.powers < 0, radius, half_width)
        angle = np.linspace(0, pi / 2, 8 * terms)
        side = np.linspace(0, half_width, 8 * terms)
        rows, right = [], []
        for z, normal, traction in (
            (radius * np.exp(1j * angle), np.exp(1j * angle), 0.0),
            (half_width + 1j * side, np.ones_like(side), STRESS),
            (side + 1j * half_width, 1j * np.ones_like(side), 0.0),
        ):
            phi, psi = self._tractions(z[:, None], normal[:, None])
            matrix = np.concatenate([phi, psi], axis=1)
            rows += [matrix.real, matrix.imag]
            right += [np.full(len(z), traction), np.zeros(len(z))]
        matrix, right = np.concatenate(rows), np.concatenate(right)
        size = np.linalg.norm(matrix, axis=0)
        self.coefficients = np.linalg.lstsq(matrix / size, right, rcond=1e-14)[0] / size
        self.left_over = float(np.abs(matrix @ self.coefficients - right).max() / STRESS)

    def _power(self, z, derivative=0):
        value = np.ones_like(self.powers, float)
        for d in range(derivative):
            value = value * (self.powers - d) / self.scale
        return value * (z / self.scale) ** (self.powers - derivative)

    def _tractions(self, z, normal):
        """σ_n − i τ_n of each power of φ and of ψ."""
        first = self._power(z, 1)
        return 2 * first.real - normal**2 * np.conj(z) * self._power(z, 2), -(normal**2) * first

    def _parts(self):
        return np.split(self.coefficients, 2)

    def displacement(self, x, y):
        phi, psi = self._parts()
        z = (x + 1j * y)[:, None]
        kappa = (3 - self.poisson) / (1 + self.poisson)
        first = (self._power(z, 1) * phi).sum(axis=1)
        w = kappa * (self._power(z) * phi).sum(axis=1) - z[:, 0] * np.conj(first) - np.conj((self._power(z) * psi).sum(axis=1))
        w *= (1 + self.poisson) / YOUNG
        return np.stack([w.real, w.imag], axis=1)

    def strain_xx(self, x, y):
        phi, psi = self._parts()
        z = (x + 1j * y)[:, None]
        trace = 4 * (self._power(z, 1) * phi).sum(axis=1).real
        difference = 2 * (np.conj(z) * self._power(z, 2) * phi + self._power(z, 1) * psi).sum(axis=1).real
        xx, yy = 0.5 * (trace - difference), 0.5 * (trace + difference)
        return (xx - self.poisson * yy) / YOUNG


def hole(body, run):
    """A square plate of 10 radii with a hole, in plane stress, both sides pulled by a pressure on the outermost particles.

    field: displacements of all particles. opening: how much longer the hole has grown along the pull, between the
    particles at its edge. hoop: strain along the pull beside the hole, between the two particles next to its edge, where it
    is about three times that far away; exact at the same place.
    """
    radius = 1.0
    spacing, half = radius / body.layers, 5 * radius
    keys = body.deck(spacing, box(2 * half, 2 * half, radius))
    keys["holes"] = {"hole": {"shape": {"cylinder": {"diameter": 2 * radius, "height": 2 * radius}}}}
    keys["boundary_conditions"] = pulled_at_both_ends()
    result = run(f"hole {body.name()}", relaxed("A plate with a hole", keys))
    x, y = result.places[:, 0], result.places[:, 1]
    exact = HoleInSquare(radius, half, body.poisson)
    true = exact.displacement(x, y)
    moved = result.moved[:, :2] - result.moved[:, :2].mean(axis=0)
    near_x = np.flatnonzero((np.abs(y) < spacing) & (x > 0))
    edge = near_x[x[near_x] < x[near_x].min() + 0.1 * spacing]
    opening = moved[edge, 0].mean() / true[edge, 0].mean() - 1
    above = np.flatnonzero((np.abs(x) < spacing) & (y > 0))
    above = above[y[above] < y[above].min() + 0.1 * spacing]
    hoop = slope(x[above], moved[above, 0])
    there = slope(x[above], true[above, 0])
    return result, {"field": relative_norm(moved, true), "opening": opening, "hoop": hoop / there - 1}


PROBLEMS = {problem.__name__: problem for problem in (bar, block, pulse, step, cantilever, three_points, hole)}
