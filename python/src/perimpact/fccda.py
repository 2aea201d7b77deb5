"""fccda: continuous contact between points and moving surfaces, rigid or deforming, for any particle code.

    detector = fccda.ContactDetector(fccda.Surface(fccda.Mesh.read("hull.stl")), radius=0.01)
    body = fccda.RigidBody(mass=1.0, velocity=[0, 0, -2])
    for _ in range(steps):
        x_t0 = x.copy()
        ...                                       # the solver updates velocity and x
        motion = body.advance(dt)
        contacts = detector.detect(motion, x_t0, x)
        fccda.respond(contacts, motion, body, x_t0=x_t0, x_t1=x, velocity=velocity, mass=m)
"""

from ._core import Mesh
from ._core.fccda import (
    ContactDetector,
    ContactSum,
    DeformingContactDetector,
    DeformingSurface,
    Motion,
    Pose,
    RigidBody,
    Surface,
    respond,
    respond_deforming,
)

__all__ = [
    "ContactDetector",
    "ContactSum",
    "DeformingContactDetector",
    "DeformingSurface",
    "Mesh",
    "Motion",
    "Pose",
    "RigidBody",
    "Surface",
    "respond",
    "respond_deforming",
]

for _public in __all__:
    if _public != "Mesh":
        globals()[_public].__module__ = __name__
