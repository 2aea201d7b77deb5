/* C: grains fall on a stretched net, whose knots move by what they receive:  trampoline [number of grains]
 *
 * A discrete-element method for the grains, and for the net knots of finite mass with springs of no length at rest, whose tension is their
 * stiffness times the spacing of the knots: the forces on knots are linear in their positions. Symplectic Euler. The knots are the vertices of a deforming
 * surface of fccda; those of the border are held. One grain falls on the knot in the middle, many fall as a heap. */
#include <fccda/fccda.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { cells = 20, side = cells + 1, knots = side * side, most_grains = 64 };
static const double gravity = 9.81, dt = 5e-4, end_time = 3;         /* [m/s2], [s] */
static const double spacing = 0.05, knot_mass = 0.01;                /* [m], [kg] */
static const double tension = 500, damping = 3;                      /* [N/m], [N s/m] of the springs of the net */
static const double radius = 0.05, grain_mass = 0.3, friction = 0.2; /* [m], [kg] */
static const double stiffness = 2e4, pair_damping = 10;              /* [N/m], [N s/m] between grains */

typedef double vector[3];
static vector x[knots], v[knots], f[knots], impulse[knots];
static double mass[knots];
static vector grain_t0[most_grains], grain[most_grains], velocity[most_grains], force[most_grains];

static void check(fccda_status status) {
  if (status == FCCDA_OK) return;
  fprintf(stderr, "error: %s\n", fccda_last_error());
  exit(2);
}

static int is_held(int k) { return k % side == 0 || k % side == cells || k / side == 0 || k / side == cells; }

static fccda_deforming_surface* make_net(void) {
  static int32_t quads[4 * cells * cells];
  const fccda_surface_options upward = {0, "net", FCCDA_NORMALS, 0};
  const fccda_vectors vertices = fccda_xyz(x[0], knots);
  fccda_surface* surface;
  fccda_deforming_surface* net;
  for (int k = 0; k < knots; ++k) {
    x[k][0] = spacing * (k % side - 0.5 * cells), x[k][1] = spacing * (k / side - 0.5 * cells);
    mass[k] = is_held(k) ? HUGE_VAL : knot_mass;
  }
  for (int c = 0; c < cells * cells; ++c) {
    const int32_t corner = c / cells * side + c % cells;
    quads[4 * c] = corner, quads[4 * c + 1] = corner + 1, quads[4 * c + 2] = corner + 1 + side, quads[4 * c + 3] = corner + side;
  }
  check(fccda_surface_create(&vertices, quads, cells * cells, 4, &upward, &surface));
  check(fccda_deforming_surface_create(surface, &net));
  fccda_surface_destroy(surface);
  return net;
}

static void place_grains(int grains) {
  for (int i = 0; i < grains && grains > 1; ++i) {
    grain[i][0] = 0.11 * (i % 4 - 1.5) + 0.004 * (i % 3), grain[i][1] = 0.11 * (i / 4 % 4 - 1.5) + 0.003 * (i % 5), grain[i][2] = 0.1 + 0.11 * (i / 16);
  }
  if (grains == 1) grain[0][2] = 0.1;
}

/* Adds a force to one and its opposite to the other. */
static void push(vector to, vector from, const vector of) {
  for (int axis = 0; axis < 3; ++axis) to[axis] += of[axis], from[axis] -= of[axis];
}

/* Returns the energy stored in the spring [J]. */
static double add_spring(int a, int b) {
  vector pull;
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double apart = x[b][axis] - x[a][axis];
    pull[axis] = tension * apart + damping * (v[b][axis] - v[a][axis]);
    squared += apart * apart;
  }
  push(f[a], f[b], pull);
  return 0.5 * tension * squared;
}

/* The same of the grains i and j. */
static double add_pair(int i, int j) {
  vector along, of;
  double distance = 0, approach = 0;
  for (int axis = 0; axis < 3; ++axis) along[axis] = grain[i][axis] - grain[j][axis], distance += along[axis] * along[axis];
  distance = sqrt(distance);
  if (distance >= 2 * radius) return 0;
  for (int axis = 0; axis < 3; ++axis) along[axis] /= distance, approach -= along[axis] * (velocity[i][axis] - velocity[j][axis]);
  for (int axis = 0; axis < 3; ++axis) of[axis] = fmax(0, stiffness * (2 * radius - distance) + pair_damping * approach) * along[axis];
  push(force[i], force[j], of);
  return 0.5 * stiffness * (2 * radius - distance) * (2 * radius - distance);
}

/* Forces on knots and grains; returns the potential energy [J]. */
static double add_forces(int grains) {
  double energy = 0;
  memset(f, 0, sizeof f), memset(force, 0, sizeof force);
  for (int k = 0; k < knots; ++k) {
    if (k % side < cells) energy += add_spring(k, k + 1);
    if (k / side < cells) energy += add_spring(k, k + side);
    if (!is_held(k)) f[k][2] -= gravity * knot_mass, energy += gravity * knot_mass * x[k][2];
  }
  for (int i = 0; i < grains; ++i) {
    force[i][2] -= gravity * grain_mass, energy += gravity * grain_mass * grain[i][2];
    for (int j = 0; j < i; ++j) energy += add_pair(i, j);
  }
  return energy;
}

static double kinetic_energy(int grains) {
  double energy = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < knots; ++k) energy += 0.5 * knot_mass * v[k][axis] * v[k][axis];
    for (int i = 0; i < grains; ++i) energy += 0.5 * grain_mass * velocity[i][axis] * velocity[i][axis];
  }
  return energy;
}

/* What the border took: spring forces of the step, and the impulses of contact, which the knots inside receive as velocity. */
static double move_net(void) {
  double on_border = 0;
  for (int k = 0; k < knots; ++k) {
    if (is_held(k)) on_border += dt * f[k][2] + impulse[k][2];
    for (int axis = 0; axis < 3 && !is_held(k); ++axis) {
      v[k][axis] += (dt * f[k][axis] + impulse[k][axis]) / knot_mass;
      x[k][axis] += dt * v[k][axis];
    }
  }
  memset(impulse, 0, sizeof impulse);
  return on_border;
}

int main(int argc, char** argv) {
  const int grains = argc > 1 ? atoi(argv[1]) : 32, steps = (int)(end_time / dt);
  fccda_deforming_surface* net = make_net();
  fccda_deforming_detector* detector;
  const fccda_vectors vertices = fccda_xyz(x[0], knots), onto = fccda_xyz(impulse[0], knots);
  const fccda_numbers masses = fccda_each(mass, knots);
  const fccda_points points = {fccda_xyz(grain_t0[0], (size_t)grains), fccda_xyz(grain[0], (size_t)grains), fccda_xyz(velocity[0], (size_t)grains),
                               fccda_one(grain_mass), fccda_unset()};
  const double weight = gravity * (grain_mass * grains + knot_mass * (cells - 1) * (cells - 1));
  double energy_before = 0, energy = 0, least = HUGE_VAL, growth = 0, on_border = 0, mean_on_border = 0, momentum_error = 0, lowest = 0;
  size_t found, contacts = 0;

  if (grains < 1 || grains > most_grains) return fprintf(stderr, "error: trampoline: give a number of grains from 1 to %d.\n", most_grains), 2;
  check(fccda_deforming_detector_create(net, radius, &detector));
  place_grains(grains);
  for (int step = 1; step <= steps; ++step) {
    double of_border, momentum = 0, potential = add_forces(grains);
    energy = potential + kinetic_energy(grains);
    if (step == 1) energy_before = energy;
    least = fmin(least, energy);
    growth = fmax(growth, energy - least);
    memcpy(grain_t0, grain, sizeof grain);
    for (int i = 0; i < grains; ++i)
      for (int axis = 0; axis < 3; ++axis) velocity[i][axis] += dt * force[i][axis] / grain_mass, grain[i][axis] += dt * velocity[i][axis];
    of_border = move_net();
    check(fccda_deforming_surface_move(net, &vertices));
    check(fccda_deforming_detect(detector, &points, &found));
    check(fccda_deforming_respond(detector, dt, &points, friction, &masses, &onto, NULL));

    contacts += found;
    on_border -= of_border;
    if (step > steps / 2) mean_on_border += -of_border / (dt * (steps - steps / 2));
    for (int i = 0; i < grains; ++i) momentum += grain_mass * velocity[i][2], lowest = fmin(lowest, grain[i][2]);
    for (int k = 0; k < knots; ++k) momentum += is_held(k) ? impulse[k][2] : knot_mass * v[k][2] + impulse[k][2];
    momentum_error = fmax(momentum_error, fabs(momentum - on_border + weight * dt * step));
  }
  printf("%d grains, %zu contacts with the net, lowest grain at %.4f m\n", grains, contacts, lowest);
  printf("force of the border on the net in the second half / weight: %.6f\n", mean_on_border / weight);
  printf("net at its middle: %.6f m, first grain %.6f m above it\n", x[knots / 2][2], grain[0][2] - x[knots / 2][2]);
  printf("energy: lost %.4f J, largest growth from any earlier time %.1e J\n", energy_before - energy, growth);
  printf("momentum of grains and net - impulse of border and gravity: %.1e of the latter at most\n", momentum_error / (weight * end_time));
  fccda_deforming_detector_destroy(detector);
  fccda_deforming_surface_destroy(net);
  return 0;
}
