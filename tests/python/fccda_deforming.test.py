"""The detector of surfaces whose vertices move, from NumPy."""

import package
from claims import claim, main

import numpy as np
from perimpact import InputError, RunError, fccda

CELLS = 6  # of the sheet, along an edge


def sheet():
    """Vertices and triangles of a square sheet of side 2 in z = 0, normals up."""
    axis = np.linspace(-1, 1, CELLS + 1)
    x, y = (a.ravel() for a in np.meshgrid(axis, axis, indexing="ij"))
    corner = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    across, along = corner + CELLS + 1, corner + 1
    faces = np.concatenate([np.stack([corner, across, along], axis=1), np.stack([across, across + 1, along], axis=1)])
    return np.stack([x, y, np.zeros_like(x)], axis=1), faces


def deforming(vertices, faces, orientation="normals"):
    return fccda.DeformingSurface(fccda.Surface(fccda.Mesh(vertices, faces), orientation=orientation))


def waving(vertices, time):
    """The sheet in oblique waves that steepen, while it is sheared and carried upwards."""
    x, y, _ = vertices.T
    return np.stack([x + 0.2 * time * y, y - 0.1 * time * x, 0.3 * time + 0.25 * np.sin(2 * x + 3 * time) * np.cos(y - 2 * time)], axis=1)


def first_crossing(x0, x1, corners0, corners1):
    """The time at which a point first crosses a triangle, by the roots of the cubic volume; infinite if it never does. Also how narrowly: the smallest
    distance of a root from the ends of the step, and of a barycentric coordinate at a root from 0."""
    u0, u1 = corners0 - x0, corners1 - x1
    samples = np.array([0, 1 / 3, 2 / 3, 1])
    volumes = [np.linalg.det(u0 + t * (u1 - u0)) for t in samples]
    roots = np.roots(np.linalg.solve(np.vander(samples), volumes))
    first, margin = np.inf, np.inf
    for t in roots[np.abs(roots.imag) < 1e-7].real:
        margin = min(margin, abs(t), abs(t - 1))
        if 0 <= t <= 1:
            a, b, c = u0 + t * (u1 - u0)
            normal = np.cross(b - a, c - a)
            weights = np.array([np.dot(np.cross(b, c), normal), np.dot(np.cross(c, a), normal), np.dot(np.cross(a, b), normal)]) / np.dot(normal, normal)
            margin = min(margin, np.abs(weights).min())
            if (weights > 0).all():
                first = min(first, t)
    return first, margin


@claim("balls of different radii rest at their own radius on a sheet that rises")
def radii(test):
    vertices, faces = sheet()
    surface = deforming(vertices, faces)
    detector = fccda.DeformingContactDetector(surface)
    x0 = np.array([[0.1, 0.2, 0.4], [-0.3, 0.1, 0.4], [0.5, -0.4, 0.4]])
    radius = np.array([0.1, 0.2, 0.0])
    surface.move(vertices + [0, 0, 0.35])
    contacts = detector.detect(x0, x0.copy(), radius)
    test.assertEqual(contacts["point"].tolist(), [0, 1])
    test.assertEqual(contacts["radius"].tolist(), [0.1, 0.2])
    test.assertLess(np.abs(contacts["relocation"][:, 2] - [0.45, 0.55]).max(), 1e-9)
    test.assertEqual(detector.points_inside(x0, radius).tolist(), [0, 1])
    surface.move(vertices + [0, 0, 0.35])
    with test.assertRaisesRegex(InputError, "radi"):
        detector.detect(x0, x0.copy(), radius[:2])


@claim("points are in contact with a sheet that deforms exactly where the cubic of a panel has a root, at that time")
def oracle(test):
    rng = np.random.default_rng(5)
    vertices, faces = sheet()
    surface = deforming(vertices, faces)
    detector = fccda.DeformingContactDetector(surface)
    surface.move(waving(vertices, 0.0))
    detector.detect(np.zeros((0, 3)), np.zeros((0, 3)))
    low, high = waving(vertices, 0.0), waving(vertices, 0.1)
    surface.move(high)
    x0 = rng.uniform([-0.8, -0.8, 0.3], [0.8, 0.8, 0.7], (400, 3))  # above the sheet: 0.25 is its highest
    x1 = x0 + rng.uniform([-0.2, -0.2, -1.0], [0.2, 0.2, 0.2], (400, 3))
    contacts = detector.detect(x0, x1)
    expected = {}
    for i in range(len(x0)):
        each = [first_crossing(x0[i], x1[i], low[face], high[face]) for face in faces]
        test.assertGreater(min(margin for _, margin in each), 1e-9)  # so that no decision is one of rounding
        if (time := min(time for time, _ in each)) < np.inf:
            expected[i] = time
    test.assertTrue(100 < len(expected) < 300, len(expected))
    test.assertEqual(contacts["point"].tolist(), list(expected))
    np.testing.assert_allclose(contacts["time_fraction"], list(expected.values()), rtol=0, atol=1e-10)  # a root of numpy loses some digits
    test.assertEqual(contacts["panel"].dtype, np.int32)
    # the place: corners are the vertices named, the weights give the relocation, and the displacement is interpolated
    np.testing.assert_array_equal(contacts["corners"], high[contacts["vertices"]])
    place = np.einsum("ij,ijk->ik", contacts["weights"], contacts["corners"])
    np.testing.assert_allclose(place, contacts["relocation"], rtol=0, atol=1e-11)  # the offset is 1e-12 of the size
    moved = np.einsum("ij,ijk->ik", contacts["weights"], (high - low)[contacts["vertices"]])
    np.testing.assert_allclose(contacts["displacement"], moved, rtol=0, atol=1e-14)  # displacements of order 0.1
    np.testing.assert_allclose(contacts["depth"], np.linalg.norm(contacts["relocation"] - x1[contacts["point"]], axis=1), rtol=1e-12)


@claim("points that rain on a membrane of point masses and springs pass their momentum to its vertices, and none passes through")
def momentum(test):
    rng = np.random.default_rng(6)
    vertices, faces = sheet()
    surface, dt, count = deforming(vertices, faces), 2e-3, 600
    detector = fccda.DeformingContactDetector(surface, radius=0.01)
    test.assertEqual(surface.vertex_count, len(vertices))
    edges = np.unique(np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)
    length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    vertex_mass, vertex_velocity, place = rng.uniform(0.05, 0.1, len(vertices)), np.zeros_like(vertices), vertices.copy()
    x = rng.uniform([-0.9, -0.9, 0.02], [0.9, 0.9, 1.5], (count, 3))
    velocity, mass = np.tile([0.3, -0.2, -4.0], (count, 1)), rng.uniform(1e-3, 2e-3, count)
    total = mass @ velocity
    scale, in_contact = np.linalg.norm(total), 0
    for _ in range(200):
        along = place[edges[:, 1]] - place[edges[:, 0]]
        distance = np.linalg.norm(along, axis=1, keepdims=True)
        pull = 40.0 * (distance - length[:, None]) * along / distance
        np.add.at(vertex_velocity, edges[:, 0], dt * pull / vertex_mass[edges[:, 0], None])
        np.add.at(vertex_velocity, edges[:, 1], -dt * pull / vertex_mass[edges[:, 1], None])
        place += dt * vertex_velocity
        x_t0 = x.copy()
        x += dt * velocity
        surface.move(place)
        contacts = detector.detect(x_t0, x)
        impulses, before = np.zeros_like(place), velocity.copy()
        sum = fccda.respond_deforming(contacts, dt, x_t0=x_t0, x_t1=x, velocity=velocity, mass=mass, vertex_impulses=impulses, vertex_mass=vertex_mass, friction=0.2, detector=detector)
        vertex_velocity += impulses / vertex_mass[:, None]
        in_contact += sum.contacts
        test.assertEqual(sum.contacts, len(contacts))
        np.testing.assert_allclose(sum.impulse, impulses.sum(axis=0), rtol=0, atol=1e-12 * scale)
        np.testing.assert_allclose(sum.impulse, mass @ (before - velocity), rtol=0, atol=1e-12 * scale)
        turned = np.cross(x, mass[:, None] * (before - velocity)).sum(axis=0)
        np.testing.assert_allclose(np.cross(place, impulses).sum(axis=0), turned, rtol=0, atol=1e-12 * scale)  # all within 2 m of the origin
        np.testing.assert_allclose(sum.angular_impulse, turned, rtol=0, atol=1e-12 * scale)
        test.assertEqual(detector.points_inside(x).tolist(), [])
    test.assertGreater(in_contact, 1000)
    np.testing.assert_allclose(mass @ velocity + vertex_mass @ vertex_velocity, total, rtol=0, atol=1e-12 * scale)


def barycentric(place, corners):
    """In the projection along z."""
    return np.linalg.solve(np.vstack([corners[:, :2].T, np.ones(3)]), [*place[:2], 1])


@claim("a sheet of infinite mass, given or not, is a wall, and the corners of its panels share the impulse")
def prescribed(test):
    vertices, faces = sheet()
    x0 = np.array([[0.11, 0.07, 0.2], [0.5, -0.31, 0.4]])
    results = []
    for options in ({}, {"vertex_mass": np.inf}, {"vertex_mass": np.full(len(vertices), np.inf, np.float32)}):
        surface = deforming(vertices, faces)
        detector = fccda.DeformingContactDetector(surface)
        surface.move(vertices + [0, 0, 0.1])
        x1, velocity, impulses = x0 - [0, 0, 1.0], np.tile([0, 0, -10.0], (2, 1)), np.zeros_like(vertices)
        contacts = detector.detect(x0.tolist(), x1)
        fccda.respond_deforming(contacts, 0.1, x_t0=x0, x_t1=x1, velocity=velocity, mass=[2.0, 3.0], vertex_impulses=impulses, **options)
        np.testing.assert_allclose(x1, x0 * [1, 1, 0] + [0, 0, 0.1], rtol=0, atol=1e-11)
        # velocity to the relocation: from z0 to 0.1 in 0.1 s
        np.testing.assert_allclose(velocity[:, 2], (0.1 - x0[:, 2]) / 0.1, rtol=0, atol=1e-10)
        np.testing.assert_allclose(impulses.sum(axis=0), [0, 0, -np.dot([2.0, 3.0], velocity[:, 2] + 10)], rtol=0, atol=1e-12)
        # without friction the corners get their shares by the barycentric coordinates of the point
        shares = np.zeros_like(vertices)
        for place, corners, of_point in zip(x0, contacts["vertices"], [2.0, 3.0] * (velocity[:, 2] + 10)):
            shares[corners, 2] -= barycentric(place, vertices[corners]) * of_point
        np.testing.assert_allclose(impulses, shares, rtol=0, atol=1e-10)  # of 20 N s, at relocations with an offset of 1e-12
        results.append((x1.tolist(), velocity.tolist(), impulses.tolist()))
    test.assertEqual(results[0], results[1])
    test.assertEqual(results[0], results[2])


@claim("a point and the vertices that it hits move on together: their impact is inelastic, with the masses of both")
def yielding(test):
    vertices, faces = sheet()
    vertex_mass = np.random.default_rng(7).uniform(0.5, 2, len(vertices))
    for x0 in ([0.11, 0.07, 0.0], [-0.52, 0.31, 0.0], [0.75, -0.9, 0.0]):  # on the sheet, which is at rest
        surface = deforming(vertices, faces)
        detector = fccda.DeformingContactDetector(surface)
        surface.move(vertices)
        x_t0 = np.array([x0]) + [0, 0, 1e-9]
        x1, velocity, impulses = x_t0 - [0, 0, 0.8], np.array([[0, 0, -8.0]]), np.zeros_like(vertices)
        (contact,) = contacts = detector.detect(x_t0, x1)
        fccda.respond_deforming(contacts, 0.1, x_t0=x_t0, x_t1=x1, velocity=velocity, mass=1.5, vertex_impulses=impulses, vertex_mass=vertex_mass)
        corners = contact["vertices"]
        weights = barycentric(x0, vertices[corners])
        together = weights @ (impulses[corners, 2] / vertex_mass[corners])
        np.testing.assert_allclose(velocity[0, 2], together, rtol=0, atol=1e-7)  # of 8 m/s, from 1e-9 m above it in 0.1 s
        test.assertTrue(-7 < together < -1)


@claim("arrays of float32 and of any stride are modified in place, those of vertices too")
def layouts(test):
    vertices, faces = sheet()
    x0 = np.array([[0.11, 0.07, 0.25], [0.5, -0.31, 0.5], [0.2, 0.2, 3.0]])

    def once(make):
        surface = deforming(vertices, faces)
        detector = fccda.DeformingContactDetector(surface)
        surface.move(make(vertices + [0, 0, 0.125]))
        x1, velocity, impulses = make(x0 - [0, 0, 1.0]), make(np.tile([0, 0, -8.0], (3, 1))), make(np.ones_like(vertices))
        contacts = detector.detect(make(x0), x1)
        fccda.respond_deforming(contacts, 0.125, x_t0=make(x0), x_t1=x1, velocity=velocity, mass=1.0, vertex_impulses=impulses, vertex_mass=4.0)
        test.assertEqual(contacts["point"].tolist(), [0, 1])
        test.assertLess(impulses[:, 2].sum(), len(vertices))  # added to what was there
        return np.array(x1), np.array(velocity), np.array(impulses)

    def records(a):
        rows = np.zeros(len(a), np.dtype([("x", "f8", 3), ("kind", "i8")]))
        rows["x"] = a
        return rows["x"]

    plain = once(np.array)
    for make in (np.asfortranarray, records, lambda a: a[::-1].copy()[::-1]):
        for one, other in zip(once(make), plain):
            test.assertEqual(one.tolist(), other.tolist())
    for one, other in zip(once(lambda a: np.array(a, np.float32)), plain):
        test.assertEqual(one.dtype, np.float32)
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-5)  # velocities of 8 from positions rounded by 1e-7, in steps of 0.125


@claim("what cannot be used is refused with a sentence: shapes, types, contacts and steps of deforming surfaces")
def refusals(test):
    vertices, faces = sheet()
    surface = deforming(vertices, faces)
    detector = fccda.DeformingContactDetector(surface)
    x0, count = np.array([[0.11, 0.07, 0.2]]), len(vertices)
    x1 = x0 - [0, 0, 1.0]
    surface.move(vertices)
    contacts = detector.detect(x0, x1)
    with test.assertRaisesRegex(InputError, "move"):
        detector.detect(x0, x1)  # the surface has not begun another step
    fixed = np.zeros((count, 3))
    fixed.flags.writeable = False
    outside, elsewhere = contacts.copy(), contacts.copy()
    outside["vertices"], elsewhere["point"] = -1, 1

    def respond(contacts=contacts, dt=0.1, **changed):
        arrays = dict(x_t0=x0, x_t1=x1.copy(), velocity=np.zeros((1, 3)), mass=1.0, vertex_impulses=np.zeros((count, 3)), vertex_mass=1.0)
        return fccda.respond_deforming(contacts, dt, **{**arrays, **changed})

    test.assertEqual(respond().contacts, 1)
    for sentence, attempt in {
        "vertices has the shape (49, 2), but must have one row x, y, z per vertex: (vertices, 3).": lambda: surface.move(vertices[:, :2]),
        "deforming surface: there are positions of 48 vertices, but its panels have 49; give one for each.": lambda: surface.move(vertices[1:]),
        "x_t1 has the shape (3,), but must have one row x, y, z per point: (points, 3).": lambda: detector.detect(x0, x1[0]),
        "x_t1 is modified in place, so it must be an array of float64 or float32, not int64; create it with dtype=float.": lambda: respond(x_t1=np.zeros((1, 3), int)),
        "vertex_impulses is modified in place, but the array is read-only; pass a copy.": lambda: respond(vertex_impulses=fixed),
        "vertex_impulses has the shape (49,), but must have one row x, y, z per vertex: (vertices, 3).": lambda: respond(vertex_impulses=np.zeros(count)),
        "vertex_mass has the shape (49, 1), but must be one number for all vertices or one per vertex.": lambda: respond(vertex_mass=np.ones((count, 1))),
        "mass has the shape (1, 1), but must be one number for all points or one per point.": lambda: respond(mass=np.ones((1, 1))),
        "contacts has the shape (1, 1), but must be one-dimensional, as returned by detect.": lambda: respond(contacts.reshape(1, 1)),
        "contacts refers to point 1, but there are 1.": lambda: respond(elsewhere),
        "contacts refers to vertex -1, but vertex_impulses has 49 rows; give one for each vertex of the mesh.": lambda: respond(outside),
        f"contacts refers to vertex {contacts['vertices'][0, 0]}, but vertex_impulses has 2 rows; give one for each vertex of the mesh.": lambda: respond(vertex_impulses=np.zeros((2, 3))),
        "friction requires the detector of the contacts, which limits sliding at obstructing panels; pass detector=… to respond_deforming.": lambda: respond(friction=0.1),
        "contact: the step has a duration of 0 s, but velocities need a positive one; pass that of the step.": lambda: respond(dt=0.0),
    }.items():
        with test.assertRaises(InputError) as error:
            attempt()
        test.assertEqual(str(error.exception), sentence)
    for words, changed in {
        "the number of masses of vertices differs": dict(vertex_mass=np.ones(3)),
        "the mass of vertex": dict(vertex_mass=0.0),
        "not equally long": dict(mass=[1.0, 1.0]),
    }.items():
        with test.assertRaisesRegex(InputError, words):
            respond(**changed)
    surface.move(vertices)
    with test.assertRaises(RunError):
        detector.detect(x0, x1 * np.nan)
    with test.assertRaisesRegex(RunError, "not finite"):
        surface.move(vertices * np.nan)
    with test.assertRaises(InputError):
        fccda.DeformingContactDetector(surface, radius=-1.0)
    with test.assertRaises(TypeError):
        fccda.DeformingContactDetector(fccda.Surface(fccda.Mesh.box([1, 1, 1])))
    with test.assertRaises(TypeError):
        respond(fccda.ContactDetector(fccda.Surface(fccda.Mesh.box([1, 1, 1]))).detect(fccda.Motion(fccda.Pose(), fccda.Pose(), 1.0), x0 + 2, x0 + 2))


@claim("points that were displaced or renumbered are found again once the detector is told")
def displaced(test):
    vertices, faces = sheet()
    surface = deforming(vertices, faces)
    detector = fccda.DeformingContactDetector(surface)

    def contacts_of(x0):
        surface.move(vertices)
        return detector.detect(x0, x0 - [0, 0, 0.02])["point"].tolist()

    far, near = np.array([[0.1, 0.1, 50.0], [0.2, 0.1, 50.0]]), np.array([[0.1, 0.1, 50.0], [0.2, 0.1, 0.01]])
    test.assertEqual(contacts_of(far), [])
    test.assertEqual(contacts_of(near), [])  # nobody said that point 1 has jumped
    detector.moved(1)
    test.assertEqual(contacts_of(near), [1])
    detector.points_changed()
    test.assertEqual(contacts_of(near[::-1].copy()), [0])


main()
