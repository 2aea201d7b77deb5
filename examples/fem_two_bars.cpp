// An elastic bar hits an elastic bar at rest, both of finite elements of different sizes:  fem_two_bars [cells along the first bar]
//
// The elements are in fem.hpp. The nodes of the first bar are points of fccda, and the end face of the second is a deforming surface whose vertices are nodes
// of finite elements: its solver moves them, and applies the impulses that they receive.
//
// By the one-dimensional wave equation equal bars exchange their velocities (Graff, Wave Motion in Elastic Solids (1975), section 2.3): the stress is
// ρ c v/2, contact lasts 2L/c, the impulse is m v; then the first bar is at rest and the second has the velocity v.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "fem.hpp"

using namespace fccda;
using fem::Bar;

namespace {

constexpr double speed = 0.1;                // [m/s] a thousandth of the speed of sound: linear
constexpr double gap = 1e-4, radius = 5e-5;  // [m] the nodes at the edges meet the border of the face within this radius

/// The upper end of a bar, as quads over its last nodes.
Panels end_face(const Bar& bar, std::size_t nodes) {
  const int across = static_cast<int>(std::lround(std::sqrt(static_cast<double>(nodes))));
  Panels face;
  face.vertices.assign(bar.x.end() - static_cast<std::ptrdiff_t>(nodes), bar.x.end());
  for (int j = 0; j + 1 < across; ++j)
    for (int i = 0; i + 1 < across; ++i) face.add_quad(j * across + i, j * across + i + 1, (j + 1) * across + i + 1, (j + 1) * across + i);
  return face;
}

double energy_of(const Bar& bar) { return bar.kinetic_energy() + bar.elastic_energy; }
double percent(double value, double of) { return 100 * (value / of - 1); }

}  // namespace

int main(int argc, char** argv) try {
  const int cells = argc > 1 ? std::atoi(argv[1]) : 50;
  if (cells < 20 || cells % 10 != 0) throw InputError("fem_two_bars: the number of cells along the bar must be 20, 30, 40 and so on.");
  Bar first(cells, speed, gap + radius), second(cells - 10, 0, -fem::length);

  const int across = static_cast<int>(std::lround(fem::width / second.cell)) + 1;
  const std::size_t of_face = static_cast<std::size_t>(across * across), below = second.x.size() - of_face;
  const auto face = std::make_shared<DeformingSurface>(Surface(end_face(second, of_face), {.orientation = Orientation::normals}));
  DeformingContactDetector detector(face, radius);
  const std::span vertices(second.x.data() + below, of_face);
  const std::vector<double> vertex_mass(second.mass.begin() + static_cast<std::ptrdiff_t>(below), second.mass.end());
  std::vector<Vec3d> impulses(of_face);

  const double sound = std::sqrt(fem::youngs / fem::rho), arrival = gap / speed, contact = 2 * fem::length / sound;
  const int steps = static_cast<int>(std::ceil((arrival + 1.5 * contact) * (sound + 4 * speed) / (0.4 * first.cell)));  // Courant number 0.4
  const double dt = (arrival + 1.5 * contact) / steps, momentum = first.momentum();
  first.compute_forces(), second.compute_forces();
  const double energy = energy_of(first);
  double impulse = 0, middle = 0, began = -1, ended = 0, most_energy = 0, momentum_error = 0;
  int middle_steps = 0;
  for (int step = 0; step < steps; ++step) {
    const std::vector<Vec3d> x_t0 = first.x;
    advance(first, dt), advance(second, dt);
    face->move(vertices);
    const std::vector<DeformingContact> contacts = detector.detect(x_t0, first.x);
    std::ranges::fill(impulses, Vec3d{});
    const PointArrays points{.x_t0 = x_t0, .x_t1 = first.x, .velocity = first.v, .mass = first.mass};
    const ContactSum sum = respond(contacts, dt, points, 0, vertex_mass, impulses);
    for (std::size_t i = 0; i < of_face; ++i) second.v[below + i] += impulses[i] / vertex_mass[i];
    first.compute_forces(), second.compute_forces();

    impulse -= sum.impulse.z;
    const double time = (step + 1) * dt;
    if (time > arrival + 0.1 * contact && time < arrival + 0.9 * contact) middle -= sum.impulse.z / dt, ++middle_steps;
    if (!contacts.empty()) began = began < 0 ? step * dt : began, ended = time;
    most_energy = std::max(most_energy, energy_of(first) + energy_of(second));
    momentum_error = std::max(momentum_error, std::fabs(first.momentum() + second.momentum() - momentum));
  }

  const double mass = fem::rho * fem::length * first.section(), stress = middle / middle_steps / first.section(), theory = fem::rho * sound * speed / 2;
  std::printf("%zu and %zu nodes, %d steps\n", first.x.size(), second.x.size(), steps);
  std::printf("contact stress   %.1f Pa, rho c v/2 = %.1f Pa (%+.2f %%)\n", stress, theory, percent(stress, theory));
  std::printf("contact lasts    %.4f ms, 2 L/c = %.4f ms (%+.2f %%)\n", 1e3 * (ended - began), 1e3 * contact, percent(ended - began, contact));
  std::printf("impulse          %.6f N s, m v = %.6f N s (%+.2f %%)\n", impulse, mass * speed, percent(impulse, mass * speed));
  std::printf("velocities after %.5f m/s and %.5f m/s\n", first.momentum() / mass, second.momentum() / mass);
  std::printf("momentum balance %.1e of the impulse\n", momentum_error / impulse);
  std::printf("energy           %.3f %% left, %.3f %% at the most\n", 100 * (energy_of(first) + energy_of(second)) / energy, 100 * most_energy / energy);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
