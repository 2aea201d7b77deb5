/// What a deck says about the boundaries of a body (docs/theory/boundary_conditions.md).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"
#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/solids.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;
using fccda::Vec3d;

/// Outward normals of faces along the axes: 2 · axis for the positive one, 2 · axis + 1 for the negative.
inline constexpr std::string_view face_words[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

/// Particles that keep their place in some directions.
struct FixedSetup {
  static constexpr std::string_view name = "fixed";
  std::string particle_set;             ///< the whole body where empty
  std::vector<std::string> directions;  ///< of x, y, z; all where empty
  static std::span<const Field<FixedSetup>> fields();
};

/// How far one direction is displaced: constant, or against time.
struct DisplacementSetup : MotionTable {
  std::optional<double> velocity;      ///< [m/s] at all times
  std::optional<double> displacement;  ///< [m] at all times
  static std::span<const Field<DisplacementSetup>> fields();
};

/// Particles that follow a course in some directions.
struct PrescribedSetup {
  static constexpr std::string_view name = "prescribed";
  std::string particle_set;  ///< the whole body where empty
  std::optional<DisplacementSetup> x, y, z;
  static std::span<const Field<PrescribedSetup>> fields();

  std::optional<DisplacementSetup>& of(std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const std::optional<DisplacementSetup>& of(std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// A force on each cubic metre: weight, inertia of an accelerated frame, traction spread over a layer.
struct BodyForceSetup {
  static constexpr std::string_view name = "body_force";
  std::string particle_set;   ///< the whole body where empty
  Vec3d force_density{};      ///< [N/m³]
  std::vector<double> times;  ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<BodyForceSetup>> fields();
};

/// A pressure on the outermost particles.
struct PressureSetup {
  static constexpr std::string_view name = "pressure";
  std::string particle_set;  ///< the whole body where empty
  Choice face{face_words};
  double value{};              ///< [Pa] pushes into the body
  std::optional<double> area;  ///< [m²]; the faces of the outermost particles of a lattice where absent
  std::vector<double> times;   ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<PressureSetup>> fields();
};

/// Weight, and still water that a body floats in (docs/theory/floating_bodies.md).
struct FloatingSetup {
  static constexpr std::string_view name = "floating";
  std::string particle_set;     ///< the whole body where empty
  std::optional<double> level;  ///< [m] z of the water's surface; that at which the body floats as it is placed where absent
  double density = 1025;        ///< [kg/m³] of the water
  double gravity = 9.81;        ///< [m/s²]
  double drag = 1;              ///< [-] of particles at the body's surface, on the area of one of their faces
  double added_mass = 0;        ///< [-] of the water that a particle displaces, for its vertical motion
  double damping = 0;           ///< [1/s] of all velocities
  static std::span<const Field<FloatingSetup>> fields();
};

/// A layer that swallows waves on their way out.
struct AbsorbingSetup {
  static constexpr std::string_view name = "absorbing";
  std::string particle_set;
  Choice face{face_words};   ///< of the layer, where the body ends
  double reflection = 1e-3;  ///< [-] share of a wave's amplitude that comes back
  static std::span<const Field<AbsorbingSetup>> fields();
};

/// `boundaries: {grip: {fixed: {region: left}}}`
struct BoundaryConditionSetup {
  std::string name;
  std::variant<FixedSetup, PrescribedSetup, BodyForceSetup, PressureSetup, FloatingSetup, AbsorbingSetup> kind;
};

}  // namespace perimpact
