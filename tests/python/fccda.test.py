"""The contact library from NumPy, on its own."""

import package
from claims import claim, main

import numpy as np
from perimpact import InputError, fccda

UNIT_BOX = dict(size=[1, 1, 1], panel=0.25)


def grid(n=21, low=-1.0, high=1.0):
    axis = np.linspace(low, high, n)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)


@claim("a box that moves strikes just the points that it passes over, when and where a formula says")
def passing(test):
    x = grid() + 0.013  # none on a plane of the box
    detector = fccda.ContactDetector(fccda.Surface(fccda.Mesh.box(**UNIT_BOX)))
    outside = (np.abs(x) > 0.5).any(axis=1)
    inside = detector.points_inside(fccda.Pose(), x)
    test.assertEqual(inside.tolist(), np.flatnonzero(~outside).tolist())
    x = x[outside]
    motion = fccda.Motion(fccda.Pose(), fccda.Pose([0, 0, 0.4]), dt=0.1)
    contacts = fccda.ContactDetector(fccda.Surface(fccda.Mesh.box(**UNIT_BOX))).detect(motion, x, x)
    struck = (np.abs(x[:, :2]) < 0.5).all(axis=1) & (x[:, 2] > 0.5) & (x[:, 2] < 0.9)
    test.assertEqual(contacts["point"].tolist(), np.flatnonzero(struck).tolist())
    test.assertGreater(len(contacts), 100)
    np.testing.assert_allclose(contacts["time_fraction"], (x[struck, 2] - 0.5) / 0.4, rtol=0, atol=1e-12)  # numbers of order 1 divided by 0.4
    np.testing.assert_allclose(contacts["normal"], np.broadcast_to([0, 0, 1], (len(contacts), 3)), rtol=0, atol=1e-12)
    np.testing.assert_allclose(contacts["relocation"][:, 2], 0.9, rtol=0, atol=1e-12)
    np.testing.assert_allclose(contacts["depth"], 0.9 - x[struck, 2], rtol=0, atol=1e-12)


@claim("points that fall on a free ball give it what they lose, and none gets in")
def falling(test):
    rng = np.random.default_rng(1)
    ball = fccda.Surface(fccda.Mesh.sphere(diameter=2, panel=0.2))
    body = fccda.RigidBody.filling(ball, density=3.0, free=["x", "y", "z", "rx", "ry", "rz"])
    detector = fccda.ContactDetector(ball, radius=0.02)
    x = rng.uniform([-1, -1, 1.1], [1, 1, 2.5], (4000, 3))
    velocity = np.tile([0.0, 0, -2], (4000, 1))
    mass = rng.uniform(1e-4, 1e-3, 4000)
    dt, struck = 0.01, 0
    before = mass @ velocity + body.momentum
    for _ in range(150):
        x_t0 = x.copy()
        x += dt * velocity
        motion = body.advance(dt)
        momentum = mass @ velocity
        contacts = detector.detect(motion, x_t0, x)
        tally = fccda.respond(contacts, motion, body, x_t0=x_t0, x_t1=x, velocity=velocity, mass=mass, friction=0.3, detector=detector)
        np.testing.assert_allclose(tally.impulse, momentum - mass @ velocity, rtol=0, atol=1e-13)  # 4000 terms of 1e-3
        test.assertEqual(tally.contacts, len(contacts))
        struck += len(contacts)
    test.assertGreater(struck, 1000)
    np.testing.assert_allclose(mass @ velocity + body.momentum, before, rtol=0, atol=1e-12)
    test.assertEqual(detector.points_inside(body.pose, x).tolist(), [])
    test.assertLess(body.velocity[2], -0.1)


@claim("arrays are read and written in place whichever way they lie, and those that cannot be written are refused")
def layouts(test):
    def once(make):
        box = fccda.Surface(fccda.Mesh.box(**UNIT_BOX))
        detector, body = fccda.ContactDetector(box), fccda.RigidBody(mass=1.0, velocity=[0, 0, 4], free=["z"])
        x0 = grid(11, -0.9, 0.9)
        x0 = x0[(np.abs(x0) > 0.5).any(axis=1)]
        x1, v = make(x0), make(np.zeros_like(x0))
        motion = body.advance(0.1)
        contacts = detector.detect(motion, make(x0), x1)
        fccda.respond(contacts, motion, body, x_t0=x0, x_t1=x1, velocity=v, mass=1e-3)
        test.assertTrue(len(contacts) > 0 and (v[contacts["point"], 2] > 0).all())
        return np.array(x1), np.array(v), body.velocity

    def padded(a):
        wide = np.zeros((len(a), 5))
        wide[:, 1:4] = a
        return wide[:, 1:4]

    plain = once(lambda a: np.array(a))
    for make in (np.asfortranarray, padded):
        for one, other in zip(once(make), plain):
            test.assertEqual(one.tolist(), other.tolist())

    box = fccda.Surface(fccda.Mesh.box(**UNIT_BOX))
    detector, body, motion = fccda.ContactDetector(box), fccda.RigidBody(mass=1.0), fccda.RigidBody(mass=1.0).advance(0.1)
    x = np.zeros((2, 3)) + 2
    contacts = detector.detect(motion, x.astype(np.float32), x.tolist())  # what is only read may be anything that makes an array
    fixed = x.copy()
    fixed.flags.writeable = False
    for x_t1, velocity, sentence in (
        (x.astype(np.float32), x, "x_t1 is written to, so it must be an array of float64, but it is one of float32; make it with dtype=float."),
        (x, fixed, "velocity is written to, but NumPy says that it may only be read; pass a copy."),
        (np.zeros((3, 2)), x, "x_t1 has the shape (3, 2), but one row x, y, z a point is needed: (points, 3)."),
        (x[::-1], x, "x_t1 is written to, but its rows do not lie one behind the other; pass numpy.ascontiguousarray of it."),
    ):
        with test.assertRaises(InputError) as error:
            fccda.respond(contacts, motion, body, x_t0=x, x_t1=x_t1, velocity=velocity, mass=1.0)
        test.assertEqual(str(error.exception), sentence)
    with test.assertRaisesRegex(InputError, "not equally long"):
        fccda.respond(contacts, motion, body, x_t0=x, x_t1=x.copy(), velocity=x.copy(), mass=[1.0, 1, 1])


@claim("a region limits where contact is looked for")
def regions(test):
    box = fccda.Surface(fccda.Mesh.box(**UNIT_BOX))
    x = grid() + 0.013
    x = x[(np.abs(x) > 0.5).any(axis=1)]
    motion = fccda.Motion(fccda.Pose(), fccda.Pose([0, 0, 0.4]), dt=0.1)
    half = fccda.ContactDetector(box, boxes=[([1, 2, 2], [0.5, 0, 0])], clip=True)
    everywhere = fccda.ContactDetector(box)
    found, all_of_them = half.detect(motion, x, x)["point"], everywhere.detect(motion, x, x)["point"]
    test.assertEqual(found.tolist(), all_of_them[x[all_of_them, 0] > 0].tolist())
    with test.assertRaises(InputError):
        fccda.ContactDetector(box, boxes=[([1, 2, 2], [0.5, 0, 0])])


@claim("poses, bodies and surfaces say what formulas say")
def formulas(test):
    turned = fccda.Pose([1, 2, 3], [np.sqrt(0.5), 0, 0, np.sqrt(0.5)])  # by a right angle about z
    np.testing.assert_allclose(turned.to_world([[1, 0, 0]]), [[1, 3, 3]], rtol=0, atol=1e-15)
    np.testing.assert_allclose(turned.to_body([[1, 3, 3]]), [[1, 0, 0]], rtol=0, atol=1e-15)
    np.testing.assert_allclose(turned.rotation, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], rtol=0, atol=1e-15)

    box = fccda.Surface(fccda.Mesh.box(size=[1, 2, 3], panel=1))
    test.assertTrue(box.is_closed)
    np.testing.assert_allclose([box.area, box.volume], [22, 6], rtol=1e-14)
    np.testing.assert_allclose(box.bounds, [[-0.5, -1, -1.5], [0.5, 1, 1.5]], rtol=0, atol=1e-15)
    body = fccda.RigidBody.filling(box, density=2, angular_velocity=[0, 0, 3], free=["rz", "x"])
    np.testing.assert_allclose(body.inertia, np.diag([13, 10, 5]), rtol=0, atol=1e-12)  # m/12 (b² + c²) with m = 12
    np.testing.assert_allclose(body.kinetic_energy, 0.5 * 5 * 9, rtol=1e-14)
    body.add_impulse([6, 6, 0], [0, 0, 5])
    np.testing.assert_allclose(body.velocity, [0.5, 0, 0], rtol=1e-14)  # y is held
    np.testing.assert_allclose(body.angular_velocity, [0, 0, 4], rtol=1e-14)
    body.drive("y", 2.0)
    motion = body.advance(0.25)
    np.testing.assert_allclose(motion.t1.position, [0.125, 0.5, 0], rtol=1e-14)
    np.testing.assert_allclose(fccda.RigidBody(1, inertia=[1, 2, 3]).inertia, np.diag([1, 2, 3]), rtol=0, atol=0)

    quads = fccda.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], [[0, 1, 2, 3], [1, 4, 2, -1]], parts=["floor", "ramp"])
    test.assertEqual((len(quads), quads.parts, quads.faces.tolist()), (2, ["floor", "ramp"], [[0, 1, 2, 3], [1, 4, 2, -1]]))
    test.assertEqual(fccda.Surface(quads, outside="normals").area, 1.5)
    with test.assertRaises(InputError):
        fccda.Surface(quads)  # open, and nothing says which side is outside
    with test.assertRaisesRegex(InputError, "quaternion"):
        fccda.Pose([0, 0, 0], [1, 1, 0, 0])
    with test.assertRaisesRegex(InputError, "no degree of freedom"):
        fccda.RigidBody(1, free=["u"])


main()
