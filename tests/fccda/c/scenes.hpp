/// Points in arrays of every layout, seen through the views of C++ and of C.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "fccda/api/respond_arrays.hpp"
#include "fccda/fccda.h"
#include "mesh/panels.hpp"

namespace c_scenes {

using namespace fccda;

/// Where numbers lie in one buffer. Distances count numbers.
struct Layout {
  const char* name;
  std::size_t x_t0, x_t1, velocity, mass, radius;  // of the first point
  std::size_t component;                           // from x to y to z
  std::ptrdiff_t from_vector_to_vector, from_mass_to_mass;
};

inline constexpr std::size_t count = 300;

inline std::vector<Layout> layouts() {
  constexpr std::size_t n = count;
  return {{"x y z x y z", 0, 3 * n, 6 * n, 9 * n, 10 * n, 1, 3, 1},
          {"three arrays", 0, 3 * n, 6 * n, 9 * n, 10 * n, n, 1, 1},
          {"members of structs", 0, 3, 6, 9, 10, 1, 12, 12},
          {"backwards", 3 * (n - 1), 6 * n - 3, 9 * n - 3, 10 * n - 1, 11 * n - 1, 1, -3, -1}};
}

/// A cloud of points that falls; `Number` is double or float.
template <class Number>
struct Cloud {
  Layout layout;
  std::vector<Number> numbers = std::vector<Number>(12 * count);
  static constexpr int type = std::is_same_v<Number, float> ? FCCDA_FLOAT : FCCDA_DOUBLE;

  Cloud(const Layout& where, const Vec3d& low, const Vec3d& high) : layout(where) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> even(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3d share{even(random), even(random), even(random)}, size = high - low;
      vectors(layout.x_t1).set(i, low + Vec3d{share.x * size.x, share.y * size.y, share.z * size.z});
      vectors(layout.velocity).set(i, {even(random) - 0.5, even(random) - 0.5, -2});
      at(layout.mass, i) = static_cast<Number>(0.01 + 0.02 * even(random));
      at(layout.radius, i) = static_cast<Number>(0.01 + 0.03 * even(random));
    }
  }

  Vectors vectors(std::size_t first) {
    Number* x = numbers.data() + first;
    return Vectors(x, x + layout.component, x + 2 * layout.component, count, layout.from_vector_to_vector);
  }
  Numbers of_each(std::size_t first) const { return Numbers(numbers.data() + first, count, layout.from_mass_to_mass); }
  PointArrays points() {
    return {.x_t0 = vectors(layout.x_t0), .x_t1 = vectors(layout.x_t1), .velocity = vectors(layout.velocity), .mass = of_each(layout.mass)};
  }

  fccda_vectors c_vectors(std::size_t first) {
    Number* x = numbers.data() + first;
    return fccda_strided(x, x + layout.component, x + 2 * layout.component, count, layout.from_vector_to_vector * std::ptrdiff_t(sizeof(Number)), type);
  }
  fccda_numbers c_numbers(std::size_t first) const {
    return fccda_strided_numbers(numbers.data() + first, count, layout.from_mass_to_mass * std::ptrdiff_t(sizeof(Number)), type);
  }
  fccda_points c_points(bool with_radii) {
    return {c_vectors(layout.x_t0), c_vectors(layout.x_t1), c_vectors(layout.velocity), c_numbers(layout.mass),
            with_radii ? c_numbers(layout.radius) : fccda_unset()};
  }

  void move(double dt) {
    const Vectors x_t0 = vectors(layout.x_t0), x_t1 = vectors(layout.x_t1), v = vectors(layout.velocity);
    for (std::size_t i = 0; i < count; ++i) {
      v.set(i, v[i] + dt * Vec3d{0, 0, -9.81});
      x_t0.set(i, x_t1[i]);
      x_t1.set(i, x_t1[i] + dt * v[i]);
    }
  }

 private:
  Number& at(std::size_t first, std::size_t i) {
    return numbers[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) + static_cast<std::ptrdiff_t>(i) * layout.from_mass_to_mass)];
  }
};

inline Vec3d as_vector(const double (&xyz)[3]) { return {xyz[0], xyz[1], xyz[2]}; }

/// The surface of panels, through the C interface.
inline fccda_surface* surface_of(Panels panels, const fccda_surface_options* options = nullptr) {
  std::vector<std::int32_t> corners;
  for (const auto& panel : panels.panels) corners.insert(corners.end(), panel.begin(), panel.end());
  fccda_surface* surface = nullptr;
  const fccda_vectors vertices = fccda_xyz(&panels.vertices[0].x, panels.vertices.size());
  fccda_surface_create(&vertices, corners.data(), panels.panels.size(), 4, options, &surface);
  return surface;
}

inline bool same(const Contact& a, const fccda_contact& b) {
  return a.point == static_cast<std::size_t>(b.point) && a.panel == b.panel && a.time_fraction == b.time_fraction && a.hit == as_vector(b.hit) &&
         a.normal == as_vector(b.normal) && a.relocation == as_vector(b.relocation) && a.depth == b.depth && a.radius == b.radius &&
         a.normal_t0 == as_vector(b.normal_t0);
}

inline bool same(const ContactSum& a, const fccda_contact_sum& b) {
  return a.impulse == as_vector(b.impulse) && a.angular_impulse == as_vector(b.angular_impulse) && a.contacts == static_cast<std::size_t>(b.contacts);
}

}  // namespace c_scenes
