/// Setup: what a deck says, as plain structs, with every default. `io/deck` fills it from YAML; the bindings fill the same structs.
/// Each struct lists its simple fields in setup.cpp (base/parameter.hpp); what nests is read by name. SI units throughout.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"
#include "perimpact/deck_model/boundary_conditions.hpp"
#include "perimpact/deck_model/generated_surfaces.hpp"
#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/solids.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;
using fccda::Vec3d;

inline constexpr std::string_view surface_correction_words[] = {"automatic", "energy", "volume", "none"};
enum class SurfaceCorrection { automatic, energy, volume, none };

inline constexpr std::string_view family_words[] = {"hu-ha-bobaru", "madenci-oterkus"};
enum class FamilyRule { hu_ha_bobaru, madenci_oterkus };

inline constexpr std::string_view normalisation_words[] = {"lattice", "continuum"};
enum class Normalisation { lattice, continuum };

inline constexpr std::string_view thin_axis_words[] = {"none", "x", "y", "z"};
enum class ThinAxis { none, x, y, z };

inline constexpr std::string_view plane_words[] = {"none", "stress", "strain"};
enum class PlaneState { none, stress, strain };  // as perimpact::Plane

inline constexpr std::string_view compression_words[] = {"none", "symmetric", "limit"};
enum class CompressionFailure { none, symmetric, limit };

inline constexpr std::string_view influence_words[] = {"constant", "inverse", "inverse-square", "parabolic", "gaussian"};  // as perimpact::Influence

inline constexpr std::string_view stress_law_words[] = {"hencky", "st-venant-kirchhoff"};  // as perimpact::StressLaw

inline constexpr std::string_view stabilisation_words[] = {"bond-level", "wan", "silling"};  // as perimpact::Stabilisation

inline constexpr std::string_view panel_words[] = {"triangles", "quads"};
enum class PanelKind { triangles, quads };

inline constexpr std::string_view detector_words[] = {"swept", "published", "analytic"};
enum class DetectorKind { swept, published, analytic };

inline constexpr std::string_view variant_words[] = {"corrected", "literal"};
enum class PublishedVariant { corrected, literal };

inline constexpr std::string_view initial_overlap_words[] = {"error", "remove", "project"};
enum class InitialOverlap { error, remove, project };

inline constexpr std::string_view on_exceed_words[] = {"error", "clip"};
enum class BeyondBounds { error, clip };

inline constexpr std::string_view fragment_law_words[] = {"none", "repulsive"};
enum class FragmentLaw { none, repulsive };

// ---- time ----

/// From one state of equilibrium to the next, instead of dynamics (docs/theory/relaxation.md).
struct RelaxSetup {
  int increments = 1;           ///< from t = 0 to the end
  double tolerance = 1e-6;      ///< [-] unbalanced force over applied force
  int max_iterations = 100000;  ///< of an increment
  static std::span<const Field<RelaxSetup>> fields();
};

struct TimeSetup {
  double end{};                ///< [s]
  std::optional<double> step;  ///< [s]; the stable estimate where absent
  std::optional<RelaxSetup> relax;
  static std::span<const Field<TimeSetup>> fields();
};

// ---- bodies ----

/// Ice as engineers state it, in place of modulus and strength (docs/theory/ice.md).
struct IceSetup {
  std::optional<double> temperature;   ///< [°C] mean over the thickness
  std::optional<double> salinity;      ///< [g/kg]
  std::optional<double> brine_volume;  ///< [-] share of the volume; in place of the other two
  std::optional<double> thickness;     ///< [m] that bends; gives the layers
  static std::span<const Field<IceSetup>> fields();
};

inline constexpr std::string_view yield_surface_words[] = {"riska-frederking", "derradji-aouat", "kierkegaard", "von-mises"};  // as perimpact::YieldSurface

/// Plastic flow under pressure (docs/theory/ice_plasticity.md).
struct PlasticitySetup {
  Choice surface{yield_surface_words};
  std::optional<double> compressive_strength;  ///< [Pa] uniaxial, to which the surface is scaled
  double failure_strain = 0.01;                ///< [-] ε0
  double failure_width = 1;                    ///< [-] M
  double failure_pressure = 0.75;              ///< [-] N
  static std::span<const Field<PlasticitySetup>> fields();
};

/// What all materials have.
struct ElasticSetup {
  std::optional<double> youngs_modulus;  ///< [Pa] needed
  double poissons_ratio = 0.25;
  double density{};  ///< [kg/m³]
  // at most one of these three says when bonds break; never where all are absent
  std::optional<double> critical_stretch;   ///< [-]
  std::optional<double> fracture_energy;    ///< [J/m²]
  std::optional<double> flexural_strength;  ///< [Pa]
  std::optional<int> layers;                ///< particles through the thickness that bends
  std::optional<IceSetup> ice;              ///< has set what was not given
  std::optional<PlasticitySetup> plasticity;
};

/// Ordinary state-based, linear, isotropic, after Madenci and Oterkus (docs/theory/ordinary_state.md).
struct OrdinaryStateSetup : ElasticSetup {
  static constexpr std::string_view name = "ordinary-state";
  static std::span<const Field<OrdinaryStateSetup>> fields();
};

/// The same after Silling et al.: one influence function, each particle normalised by its own family.
struct LinearSolidSetup : ElasticSetup {
  static constexpr std::string_view name = "linear-peridynamic-solid";
  Choice influence{influence_words, 1};
  static std::span<const Field<LinearSolidSetup>> fields();
};

/// Bonds that know nothing of one another; ν is 1/4, in plane stress 1/3.
struct BondBasedSetup : ElasticSetup {
  static constexpr std::string_view name = "bond-based";
  static std::span<const Field<BondBasedSetup>> fields();
};

/// A classical law of stress, through the deformation gradients of the particles (docs/theory/correspondence.md).
struct CorrespondenceSetup : ElasticSetup {
  static constexpr std::string_view name = "correspondence";
  Choice law{stress_law_words};
  Choice stabilisation{stabilisation_words};
  double stabilisation_factor = 1;
  Choice influence{influence_words, 1};
  static std::span<const Field<CorrespondenceSetup>> fields();
};

using MaterialSetup = std::variant<OrdinaryStateSetup, LinearSolidSetup, BondBasedSetup, CorrespondenceSetup>;  // chosen by the key `model`

/// Which bonds break, beside the critical stretch of the material.
struct FailureSetup {
  Choice compression{compression_words};
  std::optional<double> critical_compression;  ///< [-] positive, where compression is `limit`
  double compression_hardening = 0;            ///< [-] α: pressed together, particles stand more pull across
  std::optional<double> weibull_modulus;       ///< [-] scatter of the strength of particles; none where absent
  std::optional<int> seed;                     ///< of the scatter; 1 where absent
  std::vector<std::string> no_fail;            ///< names of regions
  static std::span<const Field<FailureSetup>> fields();
};

struct BodySetup {
  std::string name;
  BodyShape shape;
  std::optional<double> spacing;  ///< [m] of the lattice that fills the shape; a cloud has none
  double horizon_ratio = 3.015;
  Vec3d position{};  ///< [m] of the shape's origin: of a box, cylinder or sphere its centre
  Vec3d rotate{};    ///< [rad] of all that has a place in the body about x, then y, then z, through its position
  Vec3d velocity{};  ///< [m/s]
  Choice family{family_words};
  Choice normalisation{normalisation_words};
  Choice surface_correction{surface_correction_words};
  Choice bending_calibration{thin_axis_words};  ///< the axis across a thin plate whose bending stiffness is made right
  bool published = false;                       ///< the seed paper's discretisation: madenci-oterkus, continuum, none
  Choice plane{plane_words};                    ///< of a body of two dimensions, a single layer in z
  MaterialSetup material;
  std::optional<FailureSetup> failure;
  std::vector<SolidSetup> add;            ///< united with the shape
  std::vector<SolidSetup> holes;          ///< taken out of it
  std::vector<SolidSetup> particle_sets;  ///< names for what is in them
  std::vector<CrackSetup> cracks;
  std::vector<BoundaryConditionSetup> boundary_conditions;
  static std::span<const Field<BodySetup>> fields();

  bool is_plane() const { return plane.as<PlaneState>() != PlaneState::none; }
  const ElasticSetup& elastic() const {
    return std::visit([](const auto& one) -> const ElasticSetup& { return one; }, material);
  }
};

// ---- impactors ----

struct CylinderSurface {
  static constexpr std::string_view name = "cylinder";
  double diameter{};  ///< [m]
  double height{};    ///< [m]
  Choice axis{axis_words, 2};
  double edge_length{};  ///< [m]
  Choice panel_shape{panel_words};
  static std::span<const Field<CylinderSurface>> fields();
};

struct SphereSurface {
  static constexpr std::string_view name = "sphere";
  double diameter{};     ///< [m]
  double edge_length{};  ///< [m]
  static std::span<const Field<SphereSurface>> fields();
};

struct BoxSurface {
  static constexpr std::string_view name = "box";
  Vec3d size{};          ///< [m]
  double edge_length{};  ///< [m]
  Choice panel_shape{panel_words};
  static std::span<const Field<BoxSurface>> fields();
};

using SurfaceSetup = std::variant<CylinderSurface, SphereSurface, BoxSurface, HullSurface, PropellerSurface, FileSurface>;

/// One box fixed to the impactor: contact is looked for nowhere else (seed paper, section 3.1, example 1).
struct BoxRegionSetup {
  static constexpr std::string_view name = "box";
  Vec3d size{};    ///< [m]
  Vec3d centre{};  ///< [m] from the surface's origin
  static std::span<const Field<BoxRegionSetup>> fields();
};

/// One of several boxes.
struct BoundsBoxSetup {
  std::string name;
  Vec3d size{};    ///< [m]
  Vec3d centre{};  ///< [m] from the surface's origin
  static std::span<const Field<BoundsBoxSetup>> fields();
};

/// Several boxes together (example 2): given by name, or fitted to the surface.
struct BoxUnionBoundsSetup {
  static constexpr std::string_view name = "box_union";
  std::optional<int> count;    ///< fit at most so many
  std::optional<double> gain;  ///< [-] fit; a further box must save this share of the bounding box
  std::vector<BoundsBoxSetup> boxes;
  static std::span<const Field<BoxUnionBoundsSetup>> fields();
};

/// A cylinder and a fan of sectors in it, which turn with the impactor (example 3). What is absent is fitted to the surface.
struct CylinderSectorsBoundsSetup {
  static constexpr std::string_view name = "cylinder_sectors";
  std::optional<Vec3d> axis;
  std::optional<Vec3d> point;                        ///< [m] from the surface's origin
  std::optional<double> radius, length, hub_radius;  ///< [m]
  std::optional<int> blades;
  std::optional<double> sector_angle, start_angle;  ///< [rad]
  static std::span<const Field<CylinderSectorsBoundsSetup>> fields();
};

/// Whichever suits the surface best.
struct AutoBoundsSetup {
  static constexpr std::string_view name = "auto";
  static std::span<const Field<AutoBoundsSetup>> fields();
};

struct ContactBoundsSetup {
  /// none: wherever the surface is
  std::variant<std::monostate, BoxRegionSetup, BoxUnionBoundsSetup, CylinderSectorsBoundsSetup, AutoBoundsSetup> shape;
  Choice on_exceed{on_exceed_words};
  static std::span<const Field<ContactBoundsSetup>> fields();
};

/// Smaller panels in some place of the surface. Box, part and angle narrow one another (docs/theory/remeshing.md).
struct RefinementSetup {
  std::string name;
  double edge_length{};               ///< [m] longest edge
  std::optional<BoxRegionSetup> box;  ///< everywhere where absent
  std::string surface_part;           ///< of the surface; all where empty
  std::optional<double> angle;        ///< [rad] that panels turn by at most where the surface curves; everywhere where absent
  static std::span<const Field<RefinementSetup>> fields();
};

/// Larger panels where the surface is cut finer than its shape needs.
struct CoarseningSetup {
  double max_deviation{};                 ///< [m] that the surface moves by at most
  std::optional<double> max_edge_length;  ///< [m] no edge is made longer; any length where absent
  static std::span<const Field<CoarseningSetup>> fields();
};

/// Sums contact on some parts of the surface, as a load cell would.
struct GaugeSetup {
  std::string name;
  std::vector<std::string> surface_parts;  ///< of the surface; all where empty
  std::optional<Vec3d> point;              ///< [m] of the moments, from the surface's origin, moving along; the centre of mass where absent
  std::optional<Vec3d> axis;               ///< direction of the torque, along the surface's axes, turning along
  static std::span<const Field<GaugeSetup>> fields();
};

/// Motion of one degree of freedom.
struct TranslationTable : MotionTable {
  static std::span<const Field<TranslationTable>> fields();
};
struct RotationTable : MotionTable {
  static std::span<const Field<RotationTable>> fields();
};

inline constexpr std::string_view degree_words[] = {"x", "y", "z", "rx", "ry", "rz"};

struct MotionSetup {
  std::optional<TranslationTable> x, y, z;
  std::optional<RotationTable> rx, ry, rz;

  /// The table of a degree of freedom, counted as in degree_words; null where it has none.
  const MotionTable* of(std::size_t degree) const;
  MotionTable* of(std::size_t degree);
};

/// A force and a moment on the impactor, along the world's axes.
struct LoadSetup {
  std::string name;
  Vec3d force{};               ///< [N]
  Vec3d moment{};              ///< [N m]
  std::optional<Vec3d> point;  ///< [m] where the force acts, from the surface's origin, moving along; the centre of mass where absent
  std::vector<double> times;   ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<LoadSetup>> fields();
};

/// Weight, and still water that the impactor floats in (docs/theory/floating_bodies.md).
struct FloatingImpactorSetup {
  double level = 0;       ///< [m] z of the water's surface
  double density = 1025;  ///< [kg/m³] of the water
  double gravity = 9.81;  ///< [m/s²]
  double added_mass = 0;  ///< [-] of the water displaced at rest, for vertical motion
  double damping = 0;     ///< [1/s] of heave, roll and pitch
  static std::span<const Field<FloatingImpactorSetup>> fields();
};

struct ImpactorSetup {
  std::string name;
  SurfaceSetup surface;
  std::optional<double> mass;           ///< [kg]; this or the density
  std::optional<double> density;        ///< [kg/m³] of what fills the closed surface
  std::optional<Vec3d> centre_of_mass;  ///< [m] from the surface's origin; that of the evenly filled surface where absent
  std::optional<Vec3d> inertia;         ///< [kg m²] about the centre of mass, along the surface's axes; from the closed surface where absent
  Vec3d position{};                     ///< [m] of the surface's origin at t = 0
  Vec3d velocity{};                     ///< [m/s]
  Vec3d angular_velocity{};             ///< [rad/s]
  std::vector<std::string> free_dofs;   ///< degrees of freedom that contact may change: x y z rx ry rz; the others keep their velocity
  std::optional<CoarseningSetup> coarsen;
  std::vector<RefinementSetup> refine;
  ContactBoundsSetup contact_bounds;
  MotionSetup motion;
  std::vector<LoadSetup> loads;
  std::optional<FloatingImpactorSetup> floating;
  std::vector<GaugeSetup> gauges;
  static std::span<const Field<ImpactorSetup>> fields();
};

// ---- contact ----

struct ImpactorContactSetup {
  Choice detector{detector_words};
  Choice variant{variant_words};  ///< of the published detector
  double friction = 0;
  double radius_ratio = 0.5;  ///< contact radius in spacings
  Choice initial_overlap{initial_overlap_words};
  static std::span<const Field<ImpactorContactSetup>> fields();
};

struct FragmentContactSetup {
  Choice law{fragment_law_words};
  double distance_ratio = 1;  ///< of faces, in mean spacings
  double stiffness_factor = 15;
  double friction = 0;
  double restitution = 1;
  static std::span<const Field<FragmentContactSetup>> fields();
};

struct ContactSetup {
  ImpactorContactSetup impactors;
  FragmentContactSetup fragments;
};

// ---- output ----

/// Follows the particle nearest to a reference point.
struct ProbeSetup {
  std::string name;
  std::string body;
  Vec3d at{};  ///< [m] in the reference configuration
  static std::span<const Field<ProbeSetup>> fields();
};

/// Displacements along a line of particles at chosen times, one CSV a time.
struct LineSetup {
  std::string name;
  std::string body;
  Vec3d from{}, to{};         ///< [m] in the reference configuration
  std::vector<double> times;  ///< [s]; the end of the run where empty
  static std::span<const Field<LineSetup>> fields();
};

struct OutputSetup {
  std::string folder = "results";
  int frames = 40;                         ///< number of pictures after the one at t = 0; 0: none at all
  std::optional<double> history_interval;  ///< [s] between rows; a hundredth of the run where absent
  double checkpoint_interval = 300;        ///< [s] of the clock on the wall; 0: none but the last
  std::vector<ProbeSetup> probes;
  std::vector<LineSetup> lines;
  static std::span<const Field<OutputSetup>> fields();
};

struct Setup {
  std::string title;
  TimeSetup time;
  std::vector<BodySetup> bodies;
  std::vector<ImpactorSetup> impactors;
  ContactSetup contact;
  OutputSetup output;
  static std::span<const Field<Setup>> fields();
};

}  // namespace perimpact
