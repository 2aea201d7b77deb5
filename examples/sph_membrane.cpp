// Water falls on an elastic membrane, whose nodes move by what they receive:  sph_membrane [spacing of the particles in metres]
//
// The water is in sph.hpp. The membrane is a disc of linear triangles under constant tension, with lumped masses; the forces on its nodes,
//   f_i = T Σ_j ½ (cot α_ij + cot β_ij) (x_j - x_i + η (v_j - v_i)),   α, β: the angles opposite to the edge i j,
// are linear. Its nodes are the vertices of a deforming surface of fccda; those of the border are held. It begins in equilibrium under its
// own weight, where the sag of a membrane in its middle is σ g a²/(4 T).
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "sph.hpp"

using namespace fccda;
using sph::gravity, sph::Water;

namespace {

constexpr double radius = 0.5, tension = 4000, density = 20;  // [m], [N/m], [kg/m²]
constexpr double viscosity = 1e-4;                            // [s] η
constexpr int rings = 12;                                     // of triangles
constexpr double fall_speed = 2, end_time = 0.25;             // [m/s], [s]

struct Membrane {
  struct Edge {
    int a, b;
    double stiffness;  // [N/m]
  };
  Panels panels;
  std::vector<Edge> edges;
  std::vector<Vec3d> x, v, f, impulse;
  std::vector<double> mass;  // [kg] infinite where the node is held
  Vec3d on_border{};         // [N s] that the border received so far
  double own_mass = 0;       // [kg] of the nodes that move

  Membrane();
  bool is_held(std::size_t i) const { return mass[i] == prescribed_motion; }
  void add_forces();
  void move(double dt);
  void relax(double dt);
  double kinetic_energy() const;
  double potential_energy() const;
  Vec3d momentum() const;
  double height_at(double px, double py) const;

 private:
  void add_triangle(int a, int b, int c, std::vector<double>& node_mass);
};

// Ring r has 6 r nodes; between rings r - 1 and r each of the six sectors has 2 r - 1 triangles.
Membrane::Membrane() {
  const auto first = [](int r) { return r == 0 ? 0 : 1 + 3 * r * (r - 1); };
  const auto node = [&](int r, int k) { return first(r) + (r == 0 ? 0 : k % (6 * r)); };
  panels.vertices.push_back({});
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < 6 * r; ++k) {
      const double angle = std::numbers::pi * k / (3 * r), distance = radius * r / rings;
      panels.vertices.push_back({distance * std::cos(angle), distance * std::sin(angle), 0});
    }
  std::vector<double> node_mass(panels.vertices.size());
  for (int r = 1; r <= rings; ++r)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k < r; ++k) {
        add_triangle(node(r, sector * r + k), node(r, sector * r + k + 1), node(r - 1, sector * (r - 1) + k), node_mass);
        if (k > 0) add_triangle(node(r, sector * r + k), node(r - 1, sector * (r - 1) + k), node(r - 1, sector * (r - 1) + k - 1), node_mass);
      }
  x = panels.vertices;
  v.resize(x.size()), f.resize(x.size()), impulse.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mass.push_back(i < std::size_t(first(rings)) ? node_mass[i] : prescribed_motion);
    if (!is_held(i)) own_mass += mass[i];
  }
}

void Membrane::add_triangle(int a, int b, int c, std::vector<double>& node_mass) {
  panels.add_triangle(a, b, c);
  const int corners[] = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    const Vec3d &p = panels.vertices[std::size_t(corners[k])], &q = panels.vertices[std::size_t(corners[(k + 1) % 3])],
                &opposite = panels.vertices[std::size_t(corners[(k + 2) % 3])];
    const double doubled_area = norm(cross(p - opposite, q - opposite));
    edges.push_back({corners[k], corners[(k + 1) % 3], 0.5 * tension * dot(p - opposite, q - opposite) / doubled_area});
    node_mass[std::size_t(corners[k])] += density * doubled_area / 6;
  }
}

void Membrane::add_forces() {
  for (std::size_t i = 0; i < x.size(); ++i) f[i] = is_held(i) ? Vec3d{} : Vec3d{0, 0, -gravity * mass[i]};
  for (const Edge& edge : edges) {
    const auto a = std::size_t(edge.a), b = std::size_t(edge.b);
    const Vec3d pull = edge.stiffness * (x[b] - x[a] + viscosity * (v[b] - v[a]));
    f[a] += pull, f[b] -= pull;
  }
}

void Membrane::move(double dt) {
  add_forces();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (is_held(i)) {
      on_border += dt * f[i] + impulse[i];
    } else {
      v[i] += (dt * f[i] + impulse[i]) / mass[i];
      x[i] += dt * v[i];
    }
    impulse[i] = {};
  }
}

/// To equilibrium: it is stopped whenever its kinetic energy begins to fall (kinetic damping).
void Membrane::relax(double dt) {
  double before = 0;
  for (int step = 0; step < 4000; ++step) {
    move(dt);
    const double energy = kinetic_energy();
    if (energy < before) std::ranges::fill(v, Vec3d{});
    before = energy < before ? 0 : energy;
  }
  std::ranges::fill(v, Vec3d{});
  on_border = {};
}

double Membrane::kinetic_energy() const {
  double energy = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!is_held(i)) energy += 0.5 * mass[i] * squared_norm(v[i]);
  return energy;
}

double Membrane::potential_energy() const {
  double energy = 0;
  for (const Edge& edge : edges) energy += 0.5 * edge.stiffness * squared_norm(x[std::size_t(edge.b)] - x[std::size_t(edge.a)]);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!is_held(i)) energy += gravity * mass[i] * x[i].z;
  return energy;
}

/// With the impulses of contact, which nodes and border get in the next step.
Vec3d Membrane::momentum() const {
  Vec3d sum = on_border;
  for (std::size_t i = 0; i < x.size(); ++i) sum += impulse[i] + (is_held(i) ? Vec3d{} : mass[i] * v[i]);
  return sum;
}

/// Height of the membrane above a point of the plane, by a loop over its triangles that shares nothing with fccda; -infinity beside it.
double Membrane::height_at(double px, double py) const {
  for (const auto& panel : panels.panels) {
    const Vec3d &a = x[std::size_t(panel[0])], &b = x[std::size_t(panel[1])], &c = x[std::size_t(panel[2])];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double s = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / area, t = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) return a.z + s * (b.z - a.z) + t * (c.z - a.z);
  }
  return -HUGE_VAL;
}

double mechanical_energy(const Water& water) {
  double energy = 0;
  for (std::size_t i = 0; i < water.x.size(); ++i) energy += water.mass * (0.5 * squared_norm(water.v[i]) + gravity * water.x[i].z);
  return energy;
}

}  // namespace

int main(int argc, char** argv) try {
  const double spacing = argc > 1 ? std::atof(argv[1]) : 0.04;
  if (!(spacing >= 0.01 && spacing <= 0.1)) throw InputError("sph_membrane: give a spacing between 0.01 and 0.1 m.");
  Water water(spacing, {0.4, 0.4, 0.3}, 0, fall_speed);
  const int steps = static_cast<int>(std::ceil(end_time / std::min(water.stable_step(), 4e-4)));  // 4e-4 s: half of the membrane's limit
  const double dt = end_time / steps;

  Membrane membrane;
  membrane.relax(dt);
  const double sag = -membrane.x[0].z, expected = density * gravity * radius * radius / (4 * tension);
  const auto surface = std::make_shared<DeformingSurface>(Surface(membrane.panels, {.orientation = Orientation::normals}));
  surface->move(membrane.x);
  DeformingContactDetector detector(surface, spacing / 2);
  for (Vec3d& each : water.x) each.z += spacing;

  const double weight = gravity * (water.mass * double(water.x.size()) + membrane.own_mass), momentum_before = water.momentum_z();
  const double at_rest = membrane.potential_energy();
  const auto mechanical = [&] { return mechanical_energy(water) + membrane.kinetic_energy() + membrane.potential_energy() - at_rest; };
  const double energy_before = mechanical();
  double most_energy = energy_before, momentum_error = 0, deepest = 0;
  std::size_t contacts_found = 0, below = 0;
  for (int step = 1; step <= steps; ++step) {
    const std::vector<Vec3d> before = water.advance(dt);
    membrane.move(dt);
    surface->move(membrane.x);
    const std::vector<DeformingContact> contacts = detector.detect(before, water.x);
    respond(contacts, dt, {.x_t0 = before, .x_t1 = water.x, .velocity = water.v, .mass = water.mass}, 0, membrane.mass, membrane.impulse);

    contacts_found += contacts.size();
    momentum_error = std::max(momentum_error, std::fabs(water.momentum_z() + membrane.momentum().z - momentum_before + weight * dt * step));
    most_energy = std::max(most_energy, mechanical());
    deepest = std::min(deepest, membrane.x[0].z);
    for (const DeformingContact& each : contacts) {
      const Vec3d& x = water.x[each.contact.point];
      below += x.z < membrane.height_at(x.x, x.y);
    }
  }
  for (const Vec3d& x : water.x) below += x.z < membrane.height_at(x.x, x.y);

  std::printf("%zu particles, %d steps, %zu contacts\n", water.x.size(), steps, contacts_found);
  std::printf("sag of the membrane by its own weight: %.4f mm, by sigma g a^2/(4 T) %.4f mm\n", 1e3 * sag, 1e3 * expected);
  std::printf("particles below the membrane: %zu; its middle at %.4f m at the lowest\n", below, deepest);
  std::printf("mechanical energy: before %.3f J, largest %.3f J, after %.3f J\n", energy_before, most_energy, mechanical());
  std::printf("momentum of water, membrane and border - impulse of gravity: %.1e of that of the water at most\n", momentum_error / std::fabs(momentum_before));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
