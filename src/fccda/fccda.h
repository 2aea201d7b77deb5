/// The C interface of fccda: contact of points with rigid and deforming surfaces, for programs in C, Fortran, Julia, Rust and other languages that
/// call C. It is part of the library libfccda, and finds what the C++ interface finds, bit for bit.
///
///   fccda_points points = {fccda_xyz(x_t0, n), fccda_xyz(x_t1, n), fccda_xyz(v, n), fccda_one(mass), fccda_unset()};
///   fccda_surface_read("hull.stl", NULL, &surface);
///   fccda_detector_create(surface, 0.01, &detector);
///   while (...) {
///     fccda_body_advance(body, dt, &motion);
///     ...                                                          x_t1 and v of the solver
///     fccda_detect(detector, &motion, &points, NULL);
///     fccda_respond(detector, &motion, &points, friction, body, NULL);
///   }
///
/// Errors. Every function that can fail returns a status, FCCDA_OK if it did not. fccda_last_error() is then the sentence: where, what, why, and what
/// to do. A call that fails leaves all handles usable, and a failed response leaves points and body as they were. No C++ exception leaves the library.
///
/// Handles. A function …_create returns a handle, which the program passes to …_destroy. Detectors share their surface: the handle of a surface may be
/// destroyed before them. Calls for different handles may run concurrently, calls for one may not, nor a move of a deforming surface with a call for one
/// of its detectors.
///
/// Memory. The library neither keeps nor frees arrays of the program. What a function returns by a pointer to const belongs to the handle, up to the
/// next such call for it. Points, panels and vertices are numbered from 0. Units are those of the program; only sentences assume SI.
///
/// Binary interface. Within one FCCDA_ABI_VERSION functions are only added, the arguments and the meaning of those below stay, and no structure changes
/// its size or the place of a member. A program compares FCCDA_ABI_VERSION, with which it was compiled, and fccda_abi_version() of the library it runs with.
#ifndef FCCDA_FCCDA_H
#define FCCDA_FCCDA_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Version of the binary interface that this header describes.
#define FCCDA_ABI_VERSION 1

/// Version of the binary interface of the library that the program runs with.
int fccda_abi_version(void);

/// Version of the library: "0.1.0".
const char* fccda_version(void);

/// What a function returns: one of the constants below.
typedef int fccda_status;

enum {
  FCCDA_OK = 0,             ///< done
  FCCDA_INPUT_ERROR = 1,    ///< an argument, a file or a surface cannot be used
  FCCDA_RUN_ERROR = 2,      ///< the solver has become unstable: a position or velocity of a point, or a vertex, is not finite or far too fast
  FCCDA_INTERNAL_ERROR = 3  ///< no memory, or a fault of the library
};

/// The sentence of the last call of this thread that failed; "" before. It remains up to the next such call of the thread.
const char* fccda_last_error(void);

/// Sets the number of OpenMP threads that calls from this thread use, at least 1; otherwise it is that of OMP_NUM_THREADS. Detections use several, and so do
/// responses at rigid surfaces with 64 contacts or more. Results do not depend on it.
fccda_status fccda_use_threads(int32_t count);

/* ---- arrays of the program ---- */

enum {
  FCCDA_UNSET = 0,   ///< nothing is given
  FCCDA_DOUBLE = 1,  ///< double precision
  FCCDA_FLOAT = 2,   ///< single precision: read as double, rounded when written; see fccda_detect()
  FCCDA_ONE = 3      ///< one number for all (fccda_numbers)
};

/// A view of vectors in the memory of the program: component c of vector i is `stride` · i bytes after component c of the first. It is not copied.
/// What a function only reads it does not write to, in spite of the pointers.
typedef struct fccda_vectors {
  void* x;           ///< x of the first vector
  void* y;           ///< y of the first vector
  void* z;           ///< z of the first vector
  size_t count;      ///< number of vectors
  ptrdiff_t stride;  ///< [bytes] from one vector to the next, a multiple of the size of a number; may be negative
  int32_t type;      ///< FCCDA_DOUBLE or FCCDA_FLOAT
  int32_t reserved;  ///< 0
} fccda_vectors;

/// A view of numbers: one for each point, or one for all.
typedef struct fccda_numbers {
  const void* first;  ///< number of the first point
  size_t count;       ///< number of numbers
  ptrdiff_t stride;   ///< [bytes] from one number to the next, a multiple of the size of a number; may be negative
  double value;       ///< of all points, with the type FCCDA_ONE
  int32_t type;       ///< FCCDA_DOUBLE, FCCDA_FLOAT, FCCDA_ONE, or FCCDA_UNSET
  int32_t reserved;   ///< 0
} fccda_numbers;

/// Vectors whose components lie anywhere; `type` is FCCDA_DOUBLE or FCCDA_FLOAT, `stride` counts bytes.
static inline fccda_vectors fccda_strided(void* x, void* y, void* z, size_t count, ptrdiff_t stride, int32_t type) {
  fccda_vectors view = {x, y, z, count, stride, type, 0};
  return view;
}
/// An array x y z x y z … of doubles, of `count` vectors.
static inline fccda_vectors fccda_xyz(double* xyz, size_t count) {
  return fccda_strided(xyz, xyz ? xyz + 1 : xyz, xyz ? xyz + 2 : xyz, count, (ptrdiff_t)(3 * sizeof(double)), FCCDA_DOUBLE);
}
/// The same of floats.
static inline fccda_vectors fccda_xyz_float(float* xyz, size_t count) {
  return fccda_strided(xyz, xyz ? xyz + 1 : xyz, xyz ? xyz + 2 : xyz, count, (ptrdiff_t)(3 * sizeof(float)), FCCDA_FLOAT);
}
/// Three arrays of doubles.
static inline fccda_vectors fccda_three(double* x, double* y, double* z, size_t count) {
  return fccda_strided(x, y, z, count, (ptrdiff_t)sizeof(double), FCCDA_DOUBLE);
}
/// Three arrays of floats.
static inline fccda_vectors fccda_three_float(float* x, float* y, float* z, size_t count) {
  return fccda_strided(x, y, z, count, (ptrdiff_t)sizeof(float), FCCDA_FLOAT);
}
/// Numbers anywhere; `type` is FCCDA_DOUBLE or FCCDA_FLOAT, `stride` counts bytes.
static inline fccda_numbers fccda_strided_numbers(const void* first, size_t count, ptrdiff_t stride, int32_t type) {
  fccda_numbers view = {first, count, stride, 0, type, 0};
  return view;
}
/// An array of doubles, one for each point.
static inline fccda_numbers fccda_each(const double* first, size_t count) {
  return fccda_strided_numbers(first, count, (ptrdiff_t)sizeof(double), FCCDA_DOUBLE);
}
/// An array of floats, one for each point.
static inline fccda_numbers fccda_each_float(const float* first, size_t count) {
  return fccda_strided_numbers(first, count, (ptrdiff_t)sizeof(float), FCCDA_FLOAT);
}
/// One number for all points.
static inline fccda_numbers fccda_one(double value) {
  fccda_numbers view = fccda_strided_numbers(NULL, 0, 0, FCCDA_ONE);
  view.value = value;
  return view;
}
/// No numbers: where they have a default.
static inline fccda_numbers fccda_unset(void) { return fccda_strided_numbers(NULL, 0, 0, FCCDA_UNSET); }

/// The arrays of the program, in the order of points. A view remains valid as long as its arrays are where they were, and as many.
typedef struct fccda_points {
  fccda_vectors x_t0;      ///< [m] at the beginning of the step: x_t1 of the previous step after the response
  fccda_vectors x_t1;      ///< [m] at its end; a response moves the points in contact to the surface
  fccda_vectors velocity;  ///< [m/s] from x_t0 to x_t1, which a response changes for points in contact. Detection does not use it
  fccda_numbers mass;      ///< [kg] one for all, or one for each. Detection does not use it
  fccda_numbers radius;    ///< [m] contact radius of each point, which may change from step to step; that of the detector if unset
} fccda_points;

/* ---- surfaces ---- */

/// A surface of panels at rest in its body frame: welded, oriented, with its search tree. It is never changed.
typedef struct fccda_surface fccda_surface;

enum {
  FCCDA_UNDECLARED = 0,  ///< the surface is closed
  FCCDA_NORMALS = 1,     ///< outside of an open surface is where the normals of its panels point; without effect on a closed one
  FCCDA_REVERSED = 2     ///< outside of an open surface is the other side; refused for a closed one
};

/// How panels become a surface. All zero, or NULL instead of it, is the default.
typedef struct fccda_surface_options {
  double weld_distance;  ///< [m] at least 0: vertices nearer than this are merged; always those nearer than 1e-9 of the surface's size
  const char* name;      ///< its name in sentences; NULL: "surface"
  int32_t orientation;   ///< of an open surface: FCCDA_UNDECLARED, FCCDA_NORMALS or FCCDA_REVERSED
  int32_t reserved;      ///< 0
} fccda_surface_options;

/// The surface of a file of any format that fccda reads (STL, OBJ, PLY, VTK, Gmsh, …), in the file's units.
fccda_status fccda_surface_read(const char* path, const fccda_surface_options* options, fccda_surface** surface);

/// A surface of panels. `corners`: 3 or 4 vertex numbers in `panels` for each of the `panel_count` panels, in order around it, counterclockwise as seen
/// from where its normal points; of four the last is -1 in a triangle.
fccda_status fccda_surface_create(const fccda_vectors* vertices, const int32_t* panels, size_t panel_count, int32_t corners,
                                  const fccda_surface_options* options, fccda_surface** surface);

/// A box about the origin, of the edge lengths `size` [m]. `edge_length` [m] of its triangles; 0: two triangles a side.
fccda_status fccda_surface_box(const double size[3], double edge_length, fccda_surface** surface);

/// A sphere about the origin [m]. `edge_length` [m]: no edge of its triangles is longer; 0: diameter/20.
fccda_status fccda_surface_sphere(double diameter, double edge_length, fccda_surface** surface);

/// A cylinder about the origin [m]; `axis` 0, 1 or 2 for x, y or z. `edge_length` [m] of its triangles; 0: diameter/20.
fccda_status fccda_surface_cylinder(double diameter, double height, int32_t axis, double edge_length, fccda_surface** surface);

/// Main dimensions of an icebreaker's hull. Axes: x aft, y to starboard, z up, from where the stem meets the waterline. Members with a default may be 0.
typedef struct fccda_hull {
  double length;                 ///< [m] of the waterline
  double breadth;                ///< [m] on the waterline
  double draft;                  ///< [m]
  double freeboard;              ///< [m] height of the deck above the waterline
  double stem_angle;             ///< [rad] between stem and waterline
  double waterline_angle;        ///< [rad] half angle of entrance
  double fullness;               ///< [-] exponent of the bow's waterlines, 1 for a wedge; 0: 2
  double stern_angle;            ///< [rad] between stern and waterline; 0: 35°
  double stern_waterline_angle;  ///< [rad] half angle of the waterline at the stern; 0: 30°
  double bilge_radius;           ///< [m] 0: a hard chine
  double stem_radius;            ///< [m] of the waterlines at the stem; 0: a sharp edge
  double flare;                  ///< [rad] of the sides from the vertical
  double edge_length;            ///< [m] of the triangles aft of the bow
  double bow_edge_length;        ///< [m] in the bow; 0: as edge_length
} fccda_hull;

/// A hull of these dimensions, closed by a flat deck. Refuses dimensions that are inconsistent.
fccda_status fccda_surface_hull(const fccda_hull* hull, fccda_surface** surface);

/// Main dimensions of a propeller of the Wageningen B-series, about the origin. Members with a default may be 0.
typedef struct fccda_propeller {
  double diameter;           ///< [m]
  double pitch_ratio;        ///< [-] pitch over diameter
  double area_ratio;         ///< [-] expanded area ratio
  double hub_ratio;          ///< [-] hub diameter over diameter
  double hub_length;         ///< [m]
  double rake;               ///< [rad] aft
  double skew;               ///< [rad] of the tip, added to that of the series
  double thickness_factor;   ///< [-] on all thicknesses; 0: 1
  double edge_thickness;     ///< [-] of edges and tip, over the greatest thickness of a section; 0: 0.1
  double edge_length;        ///< [m] longest edge of the triangles
  double blade_edge_length;  ///< [m] the same at the edges and tips of the blades; 0: as edge_length
  int32_t blades;            ///< 4 to 7
  int32_t axis;              ///< of the shaft, which points ahead: 0, 1 or 2 for x, y or z
  int32_t is_left_handed;    ///< 1 if it drives ahead while it turns the other way, otherwise 0
  int32_t reserved;          ///< 0
} fccda_propeller;

/// A propeller of these dimensions: the union of a hub and blades. Refuses dimensions that are inconsistent.
fccda_status fccda_surface_propeller(const fccda_propeller* propeller, fccda_surface** surface);

/// What a surface is.
typedef struct fccda_surface_info {
  int64_t panels;          ///< as given
  int64_t panel_vertices;  ///< vertices of the panels, as given
  int64_t triangles;       ///< after repair
  int64_t vertices;        ///< after welding
  int64_t repairs;         ///< vertices welded, triangles dropped or turned around: 0 if it is as given
  int64_t is_closed;       ///< 1 if watertight, otherwise 0
  double area;             ///< [m²]
  double volume;           ///< [m³] enclosed; 0 if open
  double centroid[3];      ///< [m] of the enclosed volume; of the area if open
  double low[3];           ///< [m] lower corner of its bounds
  double high[3];          ///< [m] upper corner of its bounds
} fccda_surface_info;

/// Numbers of a surface.
fccda_status fccda_surface_measure(const fccda_surface* surface, fccda_surface_info* info);

/// What was found and repaired, in lines of text, which belongs to the handle; NULL for the handle NULL.
const char* fccda_surface_report(const fccda_surface* surface);

/// Copies the vertices of the panels, as given or read, into an array of info.panel_vertices vectors: where a deforming surface is at first.
fccda_status fccda_surface_vertices(const fccda_surface* surface, const fccda_vectors* vertices);

/// Copies the panels, as given or read, four vertex numbers each, the last -1 in a triangle. `panel_count` must be info.panels.
fccda_status fccda_surface_panels(const fccda_surface* surface, int32_t* panels, size_t panel_count);

/// Ends the use of the handle; NULL is allowed.
void fccda_surface_destroy(fccda_surface* surface);

/* ---- rigid bodies ---- */

/// Where a body frame is in the world frame.
typedef struct fccda_pose {
  double position[3];  ///< [m] of its origin
  double attitude[4];  ///< unit quaternion w x y z, which rotates vectors of the body frame into the world frame
} fccda_pose;

/// The motion of a body in a step: it rotates uniformly about its centre by the shorter angle, and the centre moves straight.
typedef struct fccda_motion {
  fccda_pose t0;     ///< at the beginning of the step
  fccda_pose t1;     ///< at its end
  double centre[3];  ///< [m] in the body frame; of a rigid body its centre of mass
  double dt;         ///< [s]
} fccda_motion;

/// A rigid body at the beginning.
typedef struct fccda_body_properties {
  double mass;                 ///< [kg]
  double centre_of_mass[3];    ///< [m] in the body frame
  double inertia[9];           ///< [kg m²] about the centre of mass, along the axes of the body frame; needed if a rotation is free
  double added_mass[3];        ///< [kg] of translation along the world axes, such as entrained water
  fccda_pose pose;             ///< of the body frame
  double velocity[3];          ///< [m/s] of the centre of mass
  double angular_velocity[3];  ///< [rad/s] about world axes
  int32_t is_free[6];          ///< 1 where impulses change the motion: translation along, rotation about x, y, z of the world
} fccda_body_properties;

/// At the origin and not rotated: the body frame is the world frame.
static inline fccda_pose fccda_no_pose(void) {
  fccda_pose pose = {{0, 0, 0}, {1, 0, 0, 0}};
  return pose;
}
/// A body at rest at the origin without free degrees of freedom; change what differs.
static inline fccda_body_properties fccda_fixed_body(double mass) {
  fccda_body_properties body = {0, {0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}, {{0, 0, 0}, {1, 0, 0, 0}}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0}};
  body.mass = mass;
  return body;
}

/// What changes of a body: its state, for output and for a restart, which is bitwise exact.
typedef struct fccda_body_state {
  double centre_of_mass[3];    ///< [m] in the world frame
  double velocity[3];          ///< [m/s] of the centre of mass
  double angular_velocity[3];  ///< [rad/s] about world axes
  double attitude[4];          ///< unit quaternion w x y z
  double constraint_work;      ///< [J] so far, of the reactions of constrained degrees of freedom
} fccda_body_state;

/// A rigid body with six degrees of freedom.
typedef struct fccda_body fccda_body;

/// Refuses what is not finite, a mass that is not positive, an attitude that is not of unit length, and free rotations without inertia.
fccda_status fccda_body_create(const fccda_body_properties* properties, fccda_body** body);

/// Moves the body for dt [s]; `motion` is what it did, for detection and response.
fccda_status fccda_body_advance(fccda_body* body, double dt, fccda_motion* motion);

/// Changes the free velocities by an impulse [N s] and an angular impulse about the centre of mass [N m s].
fccda_status fccda_body_add_impulse(fccda_body* body, const double impulse[3], const double angular_impulse[3]);

/// Prescribes the velocity [m/s], [rad/s] of a constrained degree of freedom: 0 1 2 translation along, 3 4 5 rotation about x y z.
fccda_status fccda_body_drive(fccda_body* body, int32_t degree, double velocity);

/// Where the body frame is.
fccda_status fccda_body_pose(const fccda_body* body, fccda_pose* pose);

/// Kinetic energy [J], with that of the added mass.
fccda_status fccda_body_kinetic_energy(const fccda_body* body, double* energy);

/// Reads the state.
fccda_status fccda_body_state_of(const fccda_body* body, fccda_body_state* state);

/// Sets the state, of the same body in another run or at another time.
fccda_status fccda_body_resume(fccda_body* body, const fccda_body_state* state);

/// Ends the use of the handle; NULL is allowed.
void fccda_body_destroy(fccda_body* body);

/* ---- contact with rigid surfaces ---- */

/// Contact of one point in a step. Positions and directions are in the world frame, with the surface where it is at t1.
typedef struct fccda_contact {
  int64_t point;         ///< number of the point
  int64_t panel;         ///< number of the panel, as given or in the file
  double time_fraction;  ///< time of impact, 0 at t0 to 1 at t1
  double hit[3];         ///< [m] point of the surface first in contact
  double normal[3];      ///< unit, out of the surface, at the relocation
  double relocation[3];  ///< [m] relocated position at t1, at the contact radius from the surface
  double depth;          ///< [m] distance from x_t1 to the relocation
  double radius;         ///< [m] contact radius of the point
  double normal_t0[3];   ///< unit normal at t0 of a point that was in contact there and slides; otherwise 0
} fccda_contact;

/// What a response gave to the surface.
typedef struct fccda_contact_sum {
  double impulse[3];          ///< [N s] of all contacts; divided by dt, the mean force
  double angular_impulse[3];  ///< [N m s] about the body's centre of mass at t1; without a body about motion->centre; of a deforming surface about the origin
  int64_t contacts;           ///< their number
} fccda_contact_sum;

/// A detector of one set of points against one rigid surface.
typedef struct fccda_detector fccda_detector;

/// `radius` [m]: contact radius of points without one of their own; 0 for points without extent.
fccda_status fccda_detector_create(const fccda_surface* surface, double radius, fccda_detector** detector);

/// Contact bounds: where contact is possible, in the body frame. Points that stay away from them need no evaluation of the surface.
enum {
  FCCDA_REFUSE_BEYOND = 0,  ///< refuses a surface that extends beyond its contact bounds
  FCCDA_IGNORE_BEYOND = 1   ///< ignores contact with the part of the surface beyond them
};

/// A box along the axes of the body frame.
typedef struct fccda_box {
  double size[3];    ///< [m] edge lengths, positive
  double centre[3];  ///< [m] from the origin of the body frame
} fccda_box;

/// A cylinder, and within it a hub and equal sectors that rotate with the blades of a propeller.
typedef struct fccda_sectors {
  double axis[3];       ///< direction of the cylinder; need not be a unit vector
  double point[3];      ///< [m] centre of the cylinder
  double radius;        ///< [m] positive
  double length;        ///< [m] at least 0
  double hub_radius;    ///< [m] occupied at all angles; at least 0
  double sector_angle;  ///< [rad] of each sector, at most 2π; 0: the whole cylinder
  double start_angle;   ///< [rad] begin of the first sector, from x for the axis z, from y for x, from z for y
  int32_t blades;       ///< number of sectors, 1 to 1000
  int32_t reserved;     ///< 0
} fccda_sectors;

/// A detector within contact bounds of one or several boxes, which may overlap. `beyond`: FCCDA_REFUSE_BEYOND or FCCDA_IGNORE_BEYOND. Refuses bounds with
/// a number that is not finite or out of its range, and those that no panel reaches.
fccda_status fccda_detector_create_in_boxes(const fccda_surface* surface, double radius, const fccda_box* boxes, size_t box_count, int32_t beyond,
                                            fccda_detector** detector);

/// A detector within contact bounds of a cylinder with sectors; refuses as above.
fccda_status fccda_detector_create_in_sectors(const fccda_surface* surface, double radius, const fccda_sectors* sectors, int32_t beyond,
                                              fccda_detector** detector);

/// A detector within the contact bounds that save most of one box, several boxes and a cylinder with sectors, each fitted to the surface.
fccda_status fccda_detector_create_in_fitted_bounds(const fccda_surface* surface, double radius, fccda_detector** detector);

/// The contact bounds of a detector in a sentence, which belongs to the handle; NULL for the handle NULL.
const char* fccda_detector_bounds(const fccda_detector* detector);

/// Finds the contacts of a step, in the order of points, and keeps them up to the next step. It changes no point. `count`, which may be NULL: their number.
/// Refuses positions that differ in number, and poses that are none; a position that is not finite, or a point that moves farther than 1e6 sizes of the
/// surface, is a run error.
///
/// Points may be appended or removed at the end between two steps, but not both between the same two, unless fccda_detector_moved() reports each number that
/// is used again. To repeat a step, which was rejected, is corrected or failed, save fccda_detector_state() before it and pass it to
/// fccda_detector_resume() before detecting again.
///
/// Positions x_t1 in single precision are relocated to an offset o beyond the contact radius, 2.4e-7 of the largest coordinate of the surface, so that
/// rounding moves none inside, and are in contact from o below it. The response reduces the velocity away from the surface by up to 2 o/dt, which is
/// this way in one step. Refuses o above a tenth of a contact radius, or of the surface's size for points without extent.
fccda_status fccda_detect(fccda_detector* detector, const fccda_motion* motion, const fccda_points* points, size_t* count);

/// The contacts that were found: *contacts[0] to [count - 1].
fccda_status fccda_detector_contacts(fccda_detector* detector, const fccda_contact** contacts, size_t* count);

/// Discards all contacts but those with these numbers in fccda_detector_contacts(), in ascending order: to respond to some of them only.
fccda_status fccda_detector_keep(fccda_detector* detector, const int64_t* which, size_t count);

/// Relocates the points in contact, sets their velocities, and applies the impulse to the body. `motion` and `points` are those of the detection;
/// `friction`: coefficient of Coulomb friction. `sum`, which may be NULL: what the body received. `body` may be NULL: its motion is prescribed, or the
/// program adds up the sums of several processes or sets of points and applies them by fccda_body_add_impulse(); moments are then about motion->centre.
fccda_status fccda_respond(fccda_detector* detector, const fccda_motion* motion, const fccda_points* points, double friction, fccda_body* body,
                           fccda_contact_sum* sum);

/// Reports that something else displaced the point since the last step: a periodic boundary, another body.
fccda_status fccda_detector_moved(fccda_detector* detector, int64_t point);

/// Reports that points were renumbered, or many displaced.
fccda_status fccda_detector_points_changed(fccda_detector* detector);

/// The points that are inside, or nearer than the contact radius, with the body at `pose`: for a check before the first step. `radius` may be NULL: that
/// of the detector.
fccda_status fccda_detector_points_inside(fccda_detector* detector, const fccda_pose* pose, const fccda_vectors* x, const fccda_numbers* radius,
                                          const int64_t** points, size_t* count);

/// What the next step depends on besides positions and poses, as numbers to be saved for a restart.
fccda_status fccda_detector_state(fccda_detector* detector, const int64_t** numbers, size_t* count);

/// Continues from saved numbers, with the same surface, radius and contact bounds. The restart is bitwise exact; at an open surface as long as no individual
/// radius grows from the last step before to the first one after it.
fccda_status fccda_detector_resume(fccda_detector* detector, const int64_t* numbers, size_t count);

/// Ends the use of the handle; NULL is allowed.
void fccda_detector_destroy(fccda_detector* detector);

/* ---- contact with deforming surfaces ---- */

/// A surface whose vertices move: straight and uniformly within a step. Any number of detectors may share it; it is moved once a step. Vertices that were
/// merged move together; impulses are on that of the first panel, whose mass counts.
typedef struct fccda_deforming_surface fccda_deforming_surface;

/// At rest at first. Refuses surfaces of closed parts that may overlap.
fccda_status fccda_deforming_surface_create(const fccda_surface* surface, fccda_deforming_surface** deforming);

/// Begins a step, with the vertices of the panels, as numbered when they were given or read, where they are at its end [m]. Refuses, and changes nothing:
/// another number of them, vertices that were merged and part, panels that lose their area, closed surfaces turned inside out; a vertex that is not finite, or
/// moves farther than 1e6 sizes of the surface, is a run error.
fccda_status fccda_deforming_surface_move(fccda_deforming_surface* surface, const fccda_vectors* vertices);

/// Puts the surface at rest with its vertices there [m], between two steps: after a restart, or where a step began that is rejected. Detectors then continue
/// by fccda_deforming_detector_resume() from the state that they had there. Refuses as above.
fccda_status fccda_deforming_surface_place(fccda_deforming_surface* surface, const fccda_vectors* vertices);

/// Writes to `text`, in lines that belong to the handle, what is unusual about the step that the surface has begun: panels that move farther than their
/// longest edge, turn by more than 90°, or pass through others. "" if nothing is. Takes longer than the move: for a check now and then.
fccda_status fccda_deforming_surface_warnings(fccda_deforming_surface* surface, const char** text);

/// Ends the use of the handle; NULL is allowed.
void fccda_deforming_surface_destroy(fccda_deforming_surface* surface);

/// Contact of one point with a deforming surface.
typedef struct fccda_deforming_contact {
  fccda_contact contact;   ///< in the world frame
  int64_t vertices[3];     ///< of the panels: corners of the triangle in contact
  double weights[3];       ///< barycentric coordinates of the place of contact, of sum 1
  double displacement[3];  ///< [m] of this place of the surface in the step
} fccda_deforming_contact;

/// A detector of one set of points against one deforming surface.
typedef struct fccda_deforming_detector fccda_deforming_detector;

/// `radius` [m]: contact radius of points without one of their own; 0 for points without extent.
fccda_status fccda_deforming_detector_create(const fccda_deforming_surface* surface, double radius, fccda_deforming_detector** detector);

/// Finds the contacts of the step that the surface has begun, as fccda_detect() does. Refuses a surface that was not moved since the last detection.
fccda_status fccda_deforming_detect(fccda_deforming_detector* detector, const fccda_points* points, size_t* count);

/// As fccda_detector_contacts().
fccda_status fccda_deforming_detector_contacts(fccda_deforming_detector* detector, const fccda_deforming_contact** contacts, size_t* count);

/// As fccda_detector_keep().
fccda_status fccda_deforming_detector_keep(fccda_deforming_detector* detector, const int64_t* which, size_t count);

/// Relocates the points in contact, sets their velocities, and adds the impulses on the surface to `vertex_impulses` [N s], one for each vertex of the
/// panels, which the program applies to its vertices. `dt` [s]: of the step. `vertex_mass` [kg]: one for all or one for each; infinite (HUGE_VAL) where
/// motion is prescribed. `sum` may be NULL.
fccda_status fccda_deforming_respond(fccda_deforming_detector* detector, double dt, const fccda_points* points, double friction,
                                     const fccda_numbers* vertex_mass, const fccda_vectors* vertex_impulses, fccda_contact_sum* sum);

/// As fccda_detector_moved().
fccda_status fccda_deforming_detector_moved(fccda_deforming_detector* detector, int64_t point);

/// As fccda_detector_points_changed().
fccda_status fccda_deforming_detector_points_changed(fccda_deforming_detector* detector);

/// The points that are inside the surface where it is now, or nearer than the contact radius of the detector: for a check before the first step.
fccda_status fccda_deforming_detector_points_inside(fccda_deforming_detector* detector, const fccda_vectors* x, const int64_t** points, size_t* count);

/// The same with a radius for each point, or one for all.
fccda_status fccda_deforming_detector_balls_inside(fccda_deforming_detector* detector, const fccda_vectors* x, const fccda_numbers* radius,
                                                   const int64_t** points, size_t* count);

/// As fccda_detector_state().
fccda_status fccda_deforming_detector_state(fccda_deforming_detector* detector, const int64_t** numbers, size_t* count);

/// As fccda_detector_resume().
fccda_status fccda_deforming_detector_resume(fccda_deforming_detector* detector, const int64_t* numbers, size_t count);

/// Ends the use of the handle; NULL is allowed.
void fccda_deforming_detector_destroy(fccda_deforming_detector* detector);

#ifdef __cplusplus
}
#endif

#endif
