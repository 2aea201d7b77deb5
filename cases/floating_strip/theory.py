"""A semi-infinite strip of ice on water with a line load on its free edge, by elementary theory.

A beam or plate of the bending stiffness D on a Winkler foundation k = ρ_w g (M. Hetenyi, Beams on Elastic Foundation, 1946):

    w = (2 P λ/k) exp(−λx) cos λx,     M = (P/λ) exp(−λx) sin λx,     λ = (k/4D)^¼

All numbers are per metre of width; x is measured from the free edge, w downward. M puts the upper side in tension if P acts downward.
"""

from dataclasses import dataclass
from math import exp, pi, sin

import numpy as np

LARGEST_MOMENT = exp(-pi / 4) * sin(pi / 4)  # M λ/P, at λx = π/4: 0.3224


@dataclass(frozen=True)
class Strip:
    """Ice and water. plate: no lateral motion, as in a wide sheet; otherwise the sides are free, as of a beam."""

    height: float = 2.0  # [m]
    young: float = 1.8e9  # [Pa]
    poisson: float = 0.25
    ice: float = 900.0  # [kg/m3]
    water: float = 1025.0  # [kg/m3]
    gravity: float = 9.81  # [m/s2]
    strength: float = 0.5e6  # flexural [Pa]
    plate: bool = True

    @property
    def modulus(self):
        """Stress over strain at the surface [Pa]."""
        return self.young / (1 - self.poisson**2) if self.plate else self.young

    @property
    def stiffness(self):
        """D, or EI per metre of width [N m]."""
        return self.modulus * self.height**3 / 12

    @property
    def foundation(self):
        return self.water * self.gravity  # k [N/m3]

    @property
    def rate(self):
        return (self.foundation / (4 * self.stiffness)) ** 0.25  # λ [1/m]

    @property
    def freeboard(self):
        return self.height * (1 - self.ice / self.water)  # [m]

    @property
    def breaking_distance(self):
        return pi / (4 * self.rate)  # of the largest moment from the edge [m]

    @property
    def breaking_load(self):
        """At which the largest moment is σ_f h²/6 [N/m]."""
        return self.strength * self.height**2 / 6 * self.rate / LARGEST_MOMENT

    def edge_deflection(self, load):
        return 2 * load * self.rate / self.foundation  # [m]

    def deflection(self, load, x):
        return self.edge_deflection(load) * np.exp(-self.rate * x) * np.cos(self.rate * x)

    def moment(self, load, x):
        return load / self.rate * np.exp(-self.rate * x) * np.sin(self.rate * x)  # [N]


class Elements:
    """The same by cubic Hermite elements: loaded at any x, finite with the far end clamped, and flooded.

    flooded: water that gets onto the ice carries no more of it. The push of the water grows up to w = freeboard only.
    """

    def __init__(self, strip, length=214.0, count=160):
        self.strip, self.size = strip, length / count
        self.x = np.linspace(0, length, count + 1)
        self.degrees = 2 * np.arange(count)[:, None] + np.arange(4)  # of each element: w and its slope times the size, at both ends
        self.bending = strip.stiffness / self.size**3 * np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
        points, weights = np.polynomial.legendre.leggauss(4)
        self.shapes, self.weights = self.shape(0.5 * (points + 1)), 0.5 * self.size * weights

    @staticmethod
    def shape(s):
        return np.stack([1 - 3 * s**2 + 2 * s**3, s - 2 * s**2 + s**3, 3 * s**2 - 2 * s**3, s**3 - s**2], axis=-1)

    def solve(self, load, at=0.0, flooded=False):
        """Deflections [m] and moments [N] at self.x under a line load [N/m] at x = at."""
        strip, degrees, total = self.strip, self.degrees, 2 * len(self.x)
        element = min(int(at / self.size), len(degrees) - 1)
        applied = np.zeros(total)
        applied[degrees[element]] = load * self.shape(np.float64(at / self.size - element))
        u = np.zeros(total)
        for _ in range(50):
            w = u[degrees] @ self.shapes.T
            wet = (w < strip.freeboard) | (not flooded)
            water = strip.foundation * np.where(wet, w, strip.freeboard)
            left = applied.copy()
            np.subtract.at(left, degrees, u[degrees] @ self.bending + (water * self.weights) @ self.shapes)
            matrix = np.zeros((total, total))
            springs = np.einsum("eg,gi,gj->eij", strip.foundation * wet * self.weights, self.shapes, self.shapes)
            np.add.at(matrix, (degrees[:, :, None], degrees[:, None, :]), self.bending + springs)
            change = np.linalg.solve(matrix[:-2, :-2], left[:-2])  # the last two are clamped
            u[:-2] += change
            if np.abs(change).max() <= 1e-10 * np.abs(u).max():
                break
        # curvatures at both ends of the elements, and their mean where two meet
        ends = np.array([[-6, -4, 6, -2], [6, 2, -6, 4]]) / self.size**2
        curvature = u[degrees] @ ends.T
        moment = np.zeros(len(self.x))
        moment[:-1] += curvature[:, 0]
        moment[1:] += curvature[:, 1]
        moment[1:-1] *= 0.5
        return u[::2], strip.stiffness * moment

    def breaking_load(self, at=0.0, flooded=False):
        """At which the largest moment is σ_f h²/6 [N/m]."""
        wanted, load = self.strip.strength * self.strip.height**2 / 6, self.strip.breaking_load
        for _ in range(20):
            largest = np.abs(self.solve(load, at, flooded)[1]).max()
            if abs(largest / wanted - 1) < 1e-6:
                break
            load *= wanted / largest
        return load
