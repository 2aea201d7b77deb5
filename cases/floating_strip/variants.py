"""The strip of deck.yaml with other layers, widths, sides and corrections, as decks, for docs/theory/floating_strip.py and the tests."""

from dataclasses import dataclass

from theory import Strip

HALF_BOB = 1.33  # half the heave period of the ice [s]


@dataclass(frozen=True)
class Variant:
    layers: int
    across: int = 4  # particles across
    plate: bool = True  # no lateral motion; otherwise the sides are free
    correction: str = "automatic"
    calibration: str = "none"  # bending_calibration of the body
    length: float = 214.0  # 8/λ [m]

    def name(self):
        words = ["plate" if self.plate else "beam", f"{self.layers} layers", f"{self.across} across", f"{self.length:g} m"]
        return " ".join(words + ["volume"] * (self.correction == "volume") + ["calibrated"] * (self.calibration != "none"))

    def strip(self):
        return Strip(plate=self.plate)

    def body(self, load, times, factors, breaks=True):
        """`load`: of the edge, down [N/m]."""
        strip, spacing = self.strip(), 2.0 / self.layers
        material = {"model": "ordinary-state", "youngs_modulus": strip.young, "poissons_ratio": strip.poisson, "density": strip.ice}
        if breaks:
            material.update(flexural_strength=strip.strength * strip.young / strip.modulus, layers=self.layers)
        body = {
            "shape": {"box": {"size": [self.length, self.across * spacing, strip.height]}},
            "position": [self.length / 2, 0, 0],
            "spacing": spacing,
            "material": material,
            "surface_correction": self.correction,
            "particle_sets": {
                "edge": {"shape": {"box": {"size": [spacing, 100, 100]}}, "position": [(spacing - self.length) / 2, 0, 0]},
                "far": {"shape": {"box": {"size": [2, 100, 100]}}, "position": [self.length / 2 - 1, 0, 0]},
            },
            "boundary_conditions": {
                "sea": {"floating": {}},
                "far": {"fixed": {"particle_set": "far", "directions": ["x", "z"]}},
                "load": {"body_force": {"particle_set": "edge", "force_density": [0, 0, -load / (spacing * strip.height)], "times": times, "factors": factors}},
            },
        }
        if self.plate:
            body["boundary_conditions"]["sides"] = {"fixed": {"directions": ["y"]}}
        if self.calibration != "none":
            body["bending_calibration"] = self.calibration
        return body

    def relaxed(self, loads, breaks=True, tolerance=1e-6):
        """Static equilibrium under a sequence of line loads [N/m]."""
        largest = max(loads, key=abs)
        times = [float(i) for i in range(len(loads) + 1)]
        body = self.body(largest, times, [0.0, *(load / largest for load in loads)], breaks)
        relax = {"increments": len(loads), "tolerance": tolerance, "max_iterations": 1_000_000}
        time, output = {"end": times[-1], "relax": relax}, {"frames": len(loads), "checkpoint_interval": 0}
        return {"title": f"A floating strip, relaxed: {self.name()}", "time": time, "bodies": {"ice": body}, "output": output}

    def ramp(self, load, end, step=None):
        """A line load that rises from 0 to `load` [N/m]; at half the rate for half a heave period, which suppresses oscillation."""
        body = self.body(load, [0.0, HALF_BOB, end], [0.0, 0.5 * HALF_BOB / (end - 0.5 * HALF_BOB), 1.0])
        output = {"frames": 60, "history_interval": 0.05, "checkpoint_interval": 0}
        time = {"end": end} | ({"step": step} if step else {})
        return {"title": f"A floating strip: {self.name()}", "time": time, "bodies": {"ice": body}, "output": output}
