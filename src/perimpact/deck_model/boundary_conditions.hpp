/// Boundary conditions of a body in the deck model (docs/theory/boundary_conditions.md).
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

/// Outward normals of axis-aligned faces, indexed by 2 · axis for the positive and 2 · axis + 1 for the negative direction.
inline constexpr std::string_view face_words[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

/// Homogeneous Dirichlet condition: zero displacement in some directions.
struct FixedSetup {
  static constexpr std::string_view name = "fixed";
  std::string particle_set;             ///< the whole body where empty
  std::vector<std::string> directions;  ///< of x, y, z; all where empty
  static std::span<const Field<FixedSetup>> fields();
};

/// Prescribed displacement or velocity of one direction, constant or tabulated against time.
struct DisplacementSetup : MotionTable {
  std::optional<double> velocity;      ///< [m/s] at all times
  std::optional<double> displacement;  ///< [m] at all times
  static std::span<const Field<DisplacementSetup>> fields();
};

/// Dirichlet condition: prescribed displacement history in some directions.
struct PrescribedSetup {
  static constexpr std::string_view name = "prescribed";
  std::string particle_set;  ///< the whole body where empty
  std::optional<DisplacementSetup> x, y, z;
  static std::span<const Field<PrescribedSetup>> fields();

  std::optional<DisplacementSetup>& of(std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const std::optional<DisplacementSetup>& of(std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// Body force density: weight, inertia of an accelerated frame, or traction spread over a layer.
struct BodyForceSetup {
  static constexpr std::string_view name = "body_force";
  std::string particle_set;   ///< the whole body where empty
  Vec3d force_density{};      ///< [N/m³]
  std::vector<double> times;  ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<BodyForceSetup>> fields();
};

/// Pressure on the outermost particles of a face.
struct PressureSetup {
  static constexpr std::string_view name = "pressure";
  std::string particle_set;  ///< the whole body where empty
  Choice face{face_words};
  double value{};              ///< [Pa] positive into the body
  std::optional<double> area;  ///< [m²]; from the cells of the lattice where absent
  std::vector<double> times;   ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<PressureSetup>> fields();
};

/// Weight, buoyancy, drag and added mass in still water (docs/theory/floating_bodies.md).
struct FloatingSetup {
  static constexpr std::string_view name = "floating";
  std::string particle_set;     ///< the whole body where empty
  std::optional<double> level;  ///< [m] z of the free surface; the equilibrium level of the initial position where absent
  double density = 1025;        ///< [kg/m³] of the water
  double gravity = 9.81;        ///< [m/s²]
  double drag = 1;              ///< [-] C_d of particles at the body's surface, referred to one of their faces
  double added_mass = 0;        ///< [-] of the displaced water, for vertical motion
  double damping = 0;           ///< [1/s] mass-proportional
  static std::span<const Field<FloatingSetup>> fields();
};

/// Absorbing layer: damping that increases with depth, against reflection of outgoing waves.
struct AbsorbingSetup {
  static constexpr std::string_view name = "absorbing";
  std::string particle_set;
  Choice face{face_words};   ///< outward normal of the end of the body
  double reflection = 1e-3;  ///< [-] reflection coefficient of the amplitude
  static std::span<const Field<AbsorbingSetup>> fields();
};

/// `boundary_conditions: {grip: {fixed: {particle_set: left}}}`
struct BoundaryConditionSetup {
  std::string name;
  std::variant<FixedSetup, PrescribedSetup, BodyForceSetup, PressureSetup, FloatingSetup, AbsorbingSetup> kind;
};

}  // namespace perimpact
