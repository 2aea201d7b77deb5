"""The contact library alone, from NumPy."""

import package
from claims import claim, main

import numpy as np
from perimpact import InputError, fccda

UNIT_BOX = dict(size=[1, 1, 1], edge_length=0.25)


def grid(n=21, low=-1.0, high=1.0):
    axis = np.linspace(low, high, n)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)


@claim("a moving box hits exactly the points in its path, at the analytical times and positions")
def passing(test):
    x = grid() + 0.013  # none on a face of the box
    detector = fccda.ContactDetector(fccda.Surface(fccda.Mesh.box(**UNIT_BOX)))
    outside = (np.abs(x) > 0.5).any(axis=1)
    inside = detector.points_inside(fccda.Pose(), x)
    test.assertEqual(inside.tolist(), np.flatnonzero(~outside).tolist())
    x = x[outside]
    motion = fccda.Motion(fccda.Pose(), fccda.Pose([0, 0, 0.4]), dt=0.1)
    contacts = fccda.ContactDetector(fccda.Surface(fccda.Mesh.box(**UNIT_BOX))).detect(motion, x, x)
    in_contact = (np.abs(x[:, :2]) < 0.5).all(axis=1) & (x[:, 2] > 0.5) & (x[:, 2] < 0.9)
    test.assertEqual(contacts["point"].tolist(), np.flatnonzero(in_contact).tolist())
    test.assertGreater(len(contacts), 100)
    np.testing.assert_allclose(contacts["time_fraction"], (x[in_contact, 2] - 0.5) / 0.4, rtol=0, atol=1e-12)  # numbers of order 1 divided by 0.4
    np.testing.assert_allclose(contacts["normal"], np.broadcast_to([0, 0, 1], (len(contacts), 3)), rtol=0, atol=1e-12)
    np.testing.assert_allclose(contacts["relocation"][:, 2], 0.9, rtol=0, atol=1e-12)
    np.testing.assert_allclose(contacts["depth"], 0.9 - x[in_contact, 2], rtol=0, atol=1e-12)


@claim("points that fall on a free ball transfer their momentum loss to it, and none penetrates")
def falling(test):
    rng = np.random.default_rng(1)
    ball = fccda.Surface(fccda.Mesh.sphere(diameter=2, edge_length=0.2))
    body = fccda.RigidBody.filling(ball, density=3.0, free_dofs=["x", "y", "z", "rx", "ry", "rz"])
    detector = fccda.ContactDetector(ball, radius=0.02)
    x = rng.uniform([-1, -1, 1.1], [1, 1, 2.5], (4000, 3))
    velocity = np.tile([0.0, 0, -2], (4000, 1))
    mass = rng.uniform(1e-4, 1e-3, 4000)
    dt, in_contact = 0.01, 0
    before = mass @ velocity + body.momentum
    for _ in range(150):
        x_t0 = x.copy()
        x += dt * velocity
        motion = body.advance(dt)
        momentum = mass @ velocity
        contacts = detector.detect(motion, x_t0, x)
        sum = fccda.respond(contacts, motion, body, x_t0=x_t0, x_t1=x, velocity=velocity, mass=mass, friction=0.3, detector=detector)
        np.testing.assert_allclose(sum.impulse, momentum - mass @ velocity, rtol=0, atol=1e-13)  # 4000 terms of 1e-3
        test.assertEqual(sum.contacts, len(contacts))
        in_contact += len(contacts)
    test.assertGreater(in_contact, 1000)
    np.testing.assert_allclose(mass @ velocity + body.momentum, before, rtol=0, atol=1e-12)
    test.assertEqual(detector.points_inside(body.pose, x).tolist(), [])
    test.assertLess(body.velocity[2], -0.1)


@claim("arrays of any memory layout are read and modified in place, and read-only ones are refused")
def layouts(test):
    def once(make):
        box = fccda.Surface(fccda.Mesh.box(**UNIT_BOX))
        detector, body = fccda.ContactDetector(box), fccda.RigidBody(mass=1.0, velocity=[0, 0, 4], free_dofs=["z"])
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
    def reversed_in_memory(a):
        return a[::-1].copy()[::-1]

    for make in (np.asfortranarray, padded, reversed_in_memory):
        for one, other in zip(once(make), plain):
            test.assertEqual(one.tolist(), other.tolist())

    box = fccda.Surface(fccda.Mesh.box(**UNIT_BOX))
    detector, body, motion = fccda.ContactDetector(box), fccda.RigidBody(mass=1.0), fccda.RigidBody(mass=1.0).advance(0.1)
    x = np.zeros((2, 3)) + 2
    contacts = detector.detect(motion, x.astype(np.float32), x.tolist())  # read-only arguments may be anything that converts to an array
    crooked = np.zeros(2, np.dtype([("x", "f8", 3), ("kind", "i4")]))["x"]  # rows of 28 bytes
    fixed = x.copy()
    fixed.flags.writeable = False
    for x_t1, velocity, sentence in (
        (x.astype(int), x, "x_t1 is modified in place, so it must be an array of float64 or float32, not int64; create it with dtype=float."),
        (x, fixed, "velocity is modified in place, but the array is read-only; pass a copy."),
        (np.zeros((3, 2)), x, "x_t1 has the shape (3, 2), but must have one row x, y, z per point: (points, 3)."),
        (crooked, x, "x_t1 is modified in place, but its strides are not multiples of the item size; pass numpy.ascontiguousarray of it."),
    ):
        with test.assertRaises(InputError) as error:
            fccda.respond(contacts, motion, body, x_t0=x, x_t1=x_t1, velocity=velocity, mass=1.0)
        test.assertEqual(str(error.exception), sentence)
    with test.assertRaisesRegex(InputError, "not equally long"):
        fccda.respond(contacts, motion, body, x_t0=x, x_t1=x.copy(), velocity=x.copy(), mass=[1.0, 1, 1])


@claim("contact bounds limit the detection of contact")
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


@claim("poses, bodies and surfaces agree with formulas")
def formulas(test):
    turned = fccda.Pose([1, 2, 3], [np.sqrt(0.5), 0, 0, np.sqrt(0.5)])  # by 90 degrees about z
    np.testing.assert_allclose(turned.to_world([[1, 0, 0]]), [[1, 3, 3]], rtol=0, atol=1e-15)
    np.testing.assert_allclose(turned.to_body([[1, 3, 3]]), [[1, 0, 0]], rtol=0, atol=1e-15)
    np.testing.assert_allclose(turned.rotation, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], rtol=0, atol=1e-15)

    box = fccda.Surface(fccda.Mesh.box(size=[1, 2, 3], edge_length=1))
    test.assertTrue(box.is_closed)
    np.testing.assert_allclose([box.area, box.volume], [22, 6], rtol=1e-14)
    np.testing.assert_allclose(box.bounds, [[-0.5, -1, -1.5], [0.5, 1, 1.5]], rtol=0, atol=1e-15)
    body = fccda.RigidBody.filling(box, density=2, angular_velocity=[0, 0, 3], free_dofs=["rz", "x"])
    np.testing.assert_allclose(body.inertia, np.diag([13, 10, 5]), rtol=0, atol=1e-12)  # m/12 (b² + c²) with m = 12
    np.testing.assert_allclose(body.kinetic_energy, 0.5 * 5 * 9, rtol=1e-14)
    body.add_impulse([6, 6, 0], [0, 0, 5])
    np.testing.assert_allclose(body.velocity, [0.5, 0, 0], rtol=1e-14)  # y is constrained
    np.testing.assert_allclose(body.angular_velocity, [0, 0, 4], rtol=1e-14)
    body.drive("y", 2.0)
    motion = body.advance(0.25)
    np.testing.assert_allclose(motion.t1.position, [0.125, 0.5, 0], rtol=1e-14)
    kept = body.pose
    body.advance(0.25)
    np.testing.assert_allclose(kept.position, [0.125, 0.5, 0], rtol=1e-14)  # of its time
    np.testing.assert_allclose(fccda.RigidBody(1, inertia=[1, 2, 3]).inertia, np.diag([1, 2, 3]), rtol=0, atol=0)

    quads = fccda.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], [[0, 1, 2, 3], [1, 4, 2, -1]], parts=["floor", "ramp"])
    test.assertEqual((len(quads), quads.parts, quads.faces.tolist()), (2, ["floor", "ramp"], [[0, 1, 2, 3], [1, 4, 2, -1]]))
    test.assertEqual(fccda.Surface(quads, orientation="normals").area, 1.5)
    with test.assertRaises(InputError):
        fccda.Surface(quads)  # open, and no side is declared outside
    with test.assertRaisesRegex(InputError, "quaternion"):
        fccda.Pose([0, 0, 0], [1, 1, 0, 0])
    with test.assertRaisesRegex(InputError, "not a degree of freedom"):
        fccda.RigidBody(1, free_dofs=["u"])


@claim("arrays of float32 are read and modified in place, and their rounding does not move a point into the surface")
def singles(test):
    rng = np.random.default_rng(2)
    box = fccda.Surface(fccda.Mesh.box([1, 1, 1]))
    detector, body = fccda.ContactDetector(box), fccda.RigidBody(mass=1.0, position=[100.1, 0, 0], velocity=[0, 0, 1.0])
    x = (rng.uniform([-0.4, -0.4, 0.6], [0.4, 0.4, 1.2], (500, 3)) + [100.1, 0, 0]).astype(np.float32)
    velocity, in_contact = np.zeros_like(x), 0
    for _ in range(60):
        x_t0 = x.copy()
        velocity[:, 2] -= np.float32(0.0981)
        x += np.float32(0.01) * velocity
        motion = body.advance(0.01)
        contacts = detector.detect(motion, x_t0, x)
        fccda.respond(contacts, motion, body, x_t0=x_t0, x_t1=x, velocity=velocity, mass=np.ones(1000, np.float32)[::2])
        in_contact += len(contacts)
        test.assertGreaterEqual((x[:, 2].astype(float) - body.pose.position[2]).min(), 0.5)
    test.assertGreater(in_contact, 1000)


@claim("each point may have a different radius, and detectors that share a surface find the same contacts as separate ones")
def radii(test):
    box = fccda.Surface(fccda.Mesh.box([1, 1, 1]))
    x0, motion = np.array([[0, 0, 2.0], [0.2, 0, 2.0], [0.4, 0, 2.0]]), fccda.Motion(fccda.Pose(), fccda.Pose(), dt=0.1)
    x1 = x0 - [0, 0, 1.35]  # ends 0.15 above the top face
    radius = [0.1, 0.2, 0.3]
    contacts = fccda.ContactDetector(box).detect(motion, x0, x1, radius)
    test.assertEqual(contacts["point"].tolist(), [1, 2])
    np.testing.assert_allclose(contacts["relocation"][:, 2], [0.7, 0.8], rtol=0, atol=1e-11)  # the offset is 1e-12 of the size
    test.assertEqual(contacts["radius"].tolist(), [0.2, 0.3])
    for kind, size in enumerate(radius):
        alone = fccda.ContactDetector(box, radius=size).detect(motion, x0, x1)
        test.assertEqual(kind in alone["point"], kind > 0)
    test.assertEqual(fccda.ContactDetector(box).points_inside(fccda.Pose(), x1, np.array(radius, np.float32)).tolist(), [1, 2])
    with test.assertRaisesRegex(InputError, "the number of radii differs from the"):
        fccda.ContactDetector(box).detect(motion, x0, x1, [0.1, 0.2])


@claim("with apply=False the body is unchanged, and the summed impulses have the effect of a single call")
def summed(test):
    def collide(parts):
        detector, body = fccda.ContactDetector(fccda.Surface(fccda.Mesh.box([1, 1, 1]))), fccda.RigidBody(mass=4.0, inertia=[1, 1, 1], free_dofs=["z", "rx", "ry"])
        x0, v = np.array([[0.1, 0.2, 0.6], [-0.3, 0, 0.6]]), np.array([[0, 0, -2.0], [0, 0, -3.0]])
        x1, motion = x0 + 0.1 * v, body.advance(0.1)
        contacts = detector.detect(motion, x0, x1)
        tallies = [fccda.respond(contacts[part], motion, body, x_t0=x0, x_t1=x1, velocity=v, mass=0.5, apply=parts == 1) for part in np.array_split(np.arange(2), parts)]
        if parts > 1:
            test.assertEqual(body.velocity.tolist(), [0, 0, 0])
            body.add_impulse(sum(t.impulse for t in tallies), sum(t.angular_impulse for t in tallies))
        return body.velocity.tolist() + body.angular_velocity.tolist()

    test.assertEqual(collide(1), collide(2))


@claim("numbers that are not finite, negative friction and rotations beyond half a revolution are refused, in Python terms")
def refusals(test):
    box, nan = fccda.Surface(fccda.Mesh.box([1, 1, 1])), float("nan")
    detector, still = fccda.ContactDetector(box), fccda.Motion(fccda.Pose(), fccda.Pose(), 0.1)
    x = np.array([[0, 0, 2.0]])
    body = fccda.RigidBody(1, angular_velocity=[0, 0, 10])
    for act in (
        lambda: fccda.Pose([nan, 0, 0]),
        lambda: fccda.Motion(fccda.Pose(), fccda.Pose(), nan),
        lambda: fccda.RigidBody(nan),
        lambda: fccda.RigidBody(1, velocity=[0, nan, 0]),
        lambda: body.advance(nan),
        lambda: body.advance(1),
        lambda: body.add_impulse([nan, 0, 0], [0, 0, 0]),
        lambda: fccda.RigidBody(1, free_dofs=["x"]).drive("x", 1.0),
        lambda: fccda.respond(detector.detect(still, x, x), still, body, x_t0=x, x_t1=x.copy(), velocity=x.copy(), mass=1.0, friction=-1.0, detector=detector),
        lambda: detector.detect(still, x, x, [nan]),
    ):
        test.assertRaises(InputError, act)
    lid = fccda.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    with test.assertRaisesRegex(InputError, 'which side is outside with orientation="normals"'):
        fccda.Surface(lid)
    with test.assertRaisesRegex(InputError, "or pass clip=True if this is intended"):
        fccda.ContactDetector(box, boxes=[([1, 2, 2], [0.5, 0, 0])])
    free = fccda.RigidBody(1, free_dofs=["x"])
    for act, sentence in (
        (lambda: free.drive("q", 1.0), 'degree is "q", but it must be one of x, y, z, rx, ry, rz.'),
        (lambda: free.drive("x", 1.0), "degree x is free, so its velocity cannot be prescribed; leave it out of free_dofs, or drive another one."),
        (lambda: fccda.RigidBody(1, free_dofs=["q"]), 'free_dofs has "q", which is not a degree of freedom; use x, y, z, rx, ry, rz.'),
        (lambda: fccda.Surface(fccda.Mesh.box([1, 1, 1]), weld=-1), "weld is -1 m, but it must be at least 0 and finite."),
        (lambda: fccda.Surface(fccda.Mesh.box([1, 1, 1]), weld=nan), "weld is nan m, but it must be at least 0 and finite."),
    ):
        with test.assertRaises(InputError) as error:
            act()
        test.assertEqual(str(error.exception), sentence)
    test.assertEqual((len(fccda.Mesh.box([1, 2, 3])), len(fccda.Mesh.sphere(2)) > 1000), (12, True))


main()
