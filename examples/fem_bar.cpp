// An elastic bar hits a rigid wall, then a rigid wedge:  fem_bar [cells along the bar: 30, 50, 70, ...]
//
// The elements are in fem.hpp. Contact is detected at the nodes, not on the faces between them, so a body sharper than the cells can penetrate between two
// nodes. Output for ParaView: bar_on_wall_0.vtk and so on; the force on the wall: bar_on_wall.csv.
//
// For a bar of length L and speed v that hits a wall, the stress at the wall is ρ c v, the contact duration 2L/c, and the rebound velocity -v
// (Graff, Wave Motion in Elastic Solids (1975), section 2.3).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fccda/fccda.hpp>
#include <string>
#include <vector>

#include "fem.hpp"
#include "vtk.hpp"

using namespace fccda;
using namespace fem;

namespace {

constexpr double start_gap = 1e-4;  // [m]

struct Outcome {
  double first_contact = -1, last_contact = 0;  // [s]
  double impulse = 0;                           // [N s] on the body, downwards
  double lost = 0;                              // [J] dissipated by nodes that stop on contact
  std::vector<double> time, force;              // [s], [N] of each step
};

/// Simulates the bar and the body for `time` seconds. Writes five frames: name_0.vtk to name_4.vtk, and name_body_0.vtk to
/// name_body_4.vtk of the body.
Outcome resolve_contact(Bar& bar, RigidBody& body, const Panels& panels, double speed, double time, const std::string& name) {
  ContactDetector detector{Surface(panels)};  // nodes have no extent
  const double sound = std::sqrt(youngs / rho);
  const int quarter = static_cast<int>(std::ceil(time * (sound + 4 * speed) / (0.4 * bar.cell) / 4));  // Courant number 0.4, since compressed cells are stiffer
  const double dt = time / (4 * quarter);
  const auto picture = [&](int frame) {
    Panels moved = panels;
    for (Vec3d& vertex : moved.vertices) vertex = body.pose().to_world(vertex);
    write_vtk(name + "_" + std::to_string(frame) + ".vtk", bar.x, {{"axial_stress", bar.stress}});
    write_vtk(name + "_body_" + std::to_string(frame) + ".vtk", moved);
  };
  Outcome outcome;
  bar.compute_forces();
  for (int step = 0; step < 4 * quarter; ++step) {
    if (step % quarter == 0) picture(step / quarter);
    const std::vector<Vec3d> x_t0 = bar.x, v_t0 = bar.v;
    advance(bar, dt);
    const std::vector<Vec3d> v_pushed = bar.v;
    const double energy_of_body = body.kinetic_energy();

    const Motion motion = body.advance(dt);
    const std::vector<Contact> contacts = detector.detect(motion, x_t0, bar.x);
    const ContactSum sum = respond(contacts, motion, body, {.x_t0 = x_t0, .x_t1 = bar.x, .velocity = bar.v, .mass = bar.mass});

    // The work of an impulse J is J·(v before + v after)/2, with the velocities before and after the entire step, so that a node at rest on
    // the wall, loaded by its cell and by the wall, has no net work.
    outcome.lost += energy_of_body - body.kinetic_energy();
    for (const Contact& contact : contacts) {
      const std::size_t i = contact.point;
      outcome.lost -= bar.mass[i] * dot(bar.v[i] - v_pushed[i], 0.5 * (bar.v[i] + v_t0[i]));
    }
    outcome.impulse -= sum.impulse.z;
    outcome.time.push_back((step + 1) * dt);
    outcome.force.push_back(-sum.impulse.z / dt);
    if (!contacts.empty()) {
      if (outcome.first_contact < 0) outcome.first_contact = step * dt;
      outcome.last_contact = (step + 1) * dt;
    }
    bar.compute_forces();
  }
  picture(4);
  return outcome;
}

double percent(double value, double of) { return 100 * (value / of - 1); }

void strike_wall(int cells) {
  const double speed = 0.1, sound = std::sqrt(youngs / rho);  // a thousandth of the speed of sound: linear
  Bar bar(cells, speed, start_gap);
  RigidBody wall({.mass = 1}, Pose({0, 0, -0.01}), {}, {}, {});  // fixed, upper face at z = 0
  const double arrival = start_gap / speed, contact = 2 * length / sound;
  const double before = bar.momentum(), energy = bar.kinetic_energy();
  const Outcome outcome = resolve_contact(bar, wall, make_box({.size = {0.1, 0.1, 0.02}, .edge_length = 0.05}), speed, arrival + 1.5 * contact, "bar_on_wall");

  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < outcome.time.size(); ++i)
    if (outcome.time[i] > arrival + 0.1 * contact && outcome.time[i] < arrival + 0.9 * contact) sum += outcome.force[i], ++count;
  const double stress = sum / count / bar.section(), theory = rho * sound * speed;
  std::printf("wall, %zu nodes, %.0f cells along\n", bar.x.size(), length / bar.cell);
  std::printf("  contact stress   %.1f Pa, rho c v = %.1f Pa (%+.2f %%)\n", stress, theory, percent(stress, theory));
  const double lasted = outcome.last_contact - outcome.first_contact;
  std::printf("  contact lasts    %.4f ms, 2 L/c = %.4f ms (%+.2f %%)\n", 1e3 * lasted, 1e3 * contact, percent(lasted, contact));
  std::printf("  impulse          %.6f N s, 2 m v = %.6f N s (%+.2f %%)\n", outcome.impulse, -2 * before, percent(outcome.impulse, -2 * before));
  std::printf("  momentum balance %.1e of the impulse\n", std::fabs(bar.momentum() - before - outcome.impulse) / outcome.impulse);
  const double left = bar.kinetic_energy() + bar.elastic_energy;
  std::printf("  energy balance   %+.3f %%: left %.2f %%, lost where nodes stop %.2f %%\n", 100 * ((left + outcome.lost) / energy - 1), 100 * left / energy,
              100 * outcome.lost / energy);
  if (std::FILE* file = std::fopen("bar_on_wall.csv", "w")) {
    std::fprintf(file, "time [s],force [N],theory [N]\n");
    for (std::size_t i = 0; i < outcome.time.size(); ++i) {
      const bool touches = outcome.time[i] > arrival && outcome.time[i] < arrival + contact;
      std::fprintf(file, "%.9g,%.9g,%.9g\n", outcome.time[i], outcome.force[i], touches ? theory * bar.section() : 0.0);
    }
    std::fclose(file);
  }
}

/// Wedge with its edge along y at the origin, pointing upward, with sides at 45°.
Panels wedge_panels() {
  Panels wedge;
  const double w = 0.03, d = 0.03;
  wedge.vertices = {{0, -w, 0}, {0, w, 0}, {-w, -w, -d}, {-w, w, -d}, {w, -w, -d}, {w, w, -d}};
  wedge.add_quad(0, 1, 3, 2), wedge.add_quad(0, 4, 5, 1), wedge.add_quad(2, 3, 5, 4);
  wedge.add_triangle(0, 2, 4), wedge.add_triangle(1, 5, 3);
  return wedge;
}

void strike_wedge(int cells) {
  const double speed = 4, sound = std::sqrt(youngs / rho);
  Bar bar(cells, speed, start_gap);
  RigidBody wedge({.mass = rho * length * bar.section()}, Pose(), {}, {}, {{false, false, true, false, false, false}});  // mass of the bar, free along z
  const double before = bar.momentum(), energy = bar.kinetic_energy();
  const Outcome outcome = resolve_contact(bar, wedge, wedge_panels(), speed, start_gap / speed + 3 * length / sound, "bar_on_wedge");
  const double left = bar.kinetic_energy() + bar.elastic_energy + wedge.kinetic_energy();
  std::size_t inside = 0;
  for (const Vec3d& x : bar.x) inside += x.z < wedge.pose().position().z - std::fabs(x.x) && std::fabs(x.x) < 0.03;
  std::printf("wedge, %zu nodes, %.0f cells along\n", bar.x.size(), length / bar.cell);
  std::printf("  wedge leaves at  %.4f m/s, the bar on average at %.4f m/s\n", wedge.velocity().z, bar.momentum() / wedge.mass());
  std::printf("  nodes inside     %zu\n", inside);
  std::printf("  momentum balance %.1e of the impulse\n", std::fabs(bar.momentum() + wedge.momentum().z - before) / outcome.impulse);
  std::printf("  energy balance   %+.3f %%: left %.2f %%, lost where nodes stop %.2f %%\n", 100 * ((left + outcome.lost) / energy - 1), 100 * left / energy,
              100 * outcome.lost / energy);
}

}  // namespace

int main(int argc, char** argv) try {
  const int cells = argc > 1 ? std::atoi(argv[1]) : 50;
  if (cells < 30 || cells % 20 != 10)  // cubes, and an odd number across, so that no node is exactly above the edge of the wedge
    throw InputError("fem_bar: the number of cells along the bar must be 30, 50, 70 and so on.");
  strike_wall(cells);
  strike_wedge(cells);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
