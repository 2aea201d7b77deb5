/// Setup: the contents of a deck as plain structs with all defaults. `io/deck` fills it from YAML; the bindings fill the same structs.
/// Each struct lists its simple fields in setup.cpp (base/parameter.hpp); io/deck/schema.hpp lists the nested ones. SI units throughout.
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

/// Adaptive dynamic relaxation: quasi-static increments instead of dynamics (docs/theory/relaxation.md).
struct RelaxSetup {
  int increments = 1;           ///< from t = 0 to the end
  double tolerance = 1e-6;      ///< [-] residual force over applied force
  int max_iterations = 100000;  ///< per increment
  static std::span<const Field<RelaxSetup>> fields();
};

struct TimeSetup {
  double end{};                ///< [s]
  std::optional<double> step;  ///< [s]; from the estimated stable time step where absent
  std::optional<RelaxSetup> relax;
  static std::span<const Field<TimeSetup>> fields();
};

// ---- bodies ----

/// Ice by temperature and salinity, in place of modulus and strength (docs/theory/ice.md).
struct IceSetup {
  std::optional<double> temperature;   ///< [°C] mean over the thickness
  std::optional<double> salinity;      ///< [g/kg]
  std::optional<double> brine_volume;  ///< [-] brine volume fraction; in place of the other two
  std::optional<double> thickness;     ///< [m] in bending; determines the number of layers
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
  std::optional<double> friction_angle;        ///< [rad] φ of ice that has failed
  static std::span<const Field<PlasticitySetup>> fields();
};

/// Parameters common to all materials.
struct ElasticSetup {
  std::optional<double> youngs_modulus;  ///< [Pa] required
  double poissons_ratio = 0.25;
  double density{};  ///< [kg/m³]
  // failure criterion: at most one of these three; bonds never break where all are absent
  std::optional<double> critical_stretch;   ///< [-]
  std::optional<double> fracture_energy;    ///< [J/m²]
  std::optional<double> flexural_strength;  ///< [Pa]
  std::optional<int> layers;                ///< of particles through the thickness in bending
  std::optional<IceSetup> ice;              ///< source of the values that the deck does not give
  std::optional<PlasticitySetup> plasticity;
};

/// Ordinary state-based material, linear and isotropic, after Madenci and Oterkus (docs/theory/ordinary_state.md).
struct OrdinaryStateSetup : ElasticSetup {
  static constexpr std::string_view name = "ordinary-state";
  static std::span<const Field<OrdinaryStateSetup>> fields();
};

/// Linear peridynamic solid after Silling et al.: ordinary state-based, normalised by each particle's own weighted volume.
struct LinearSolidSetup : ElasticSetup {
  static constexpr std::string_view name = "linear-peridynamic-solid";
  Choice influence{influence_words, 1};
  static std::span<const Field<LinearSolidSetup>> fields();
};

/// Bond-based material: independent bonds (micromodulus c); ν is 1/4, in plane stress 1/3.
struct BondBasedSetup : ElasticSetup {
  static constexpr std::string_view name = "bond-based";
  static std::span<const Field<BondBasedSetup>> fields();
};

/// Correspondence (non-ordinary state-based) material: a classical stress law on the deformation gradient (docs/theory/correspondence.md).
struct CorrespondenceSetup : ElasticSetup {
  static constexpr std::string_view name = "correspondence";
  Choice law{stress_law_words};
  Choice stabilisation{stabilisation_words};
  double stabilisation_factor = 1;
  Choice influence{influence_words, 1};
  static std::span<const Field<CorrespondenceSetup>> fields();
};

using MaterialSetup = std::variant<OrdinaryStateSetup, LinearSolidSetup, BondBasedSetup, CorrespondenceSetup>;  // chosen by the key `model`

/// Bond failure in addition to the material's critical stretch.
struct FailureSetup {
  Choice compression{compression_words};
  std::optional<double> critical_compression;  ///< [-] positive; where compression is `limit`
  double compression_hardening = 0;            ///< [-] α of the confinement-dependent critical stretch
  std::optional<double> weibull_modulus;       ///< [-] scatter of the critical stretch; none where absent
  std::optional<int> seed;                     ///< of the scatter; 1 where absent
  std::vector<std::string> no_fail;            ///< names of particle sets
  static std::span<const Field<FailureSetup>> fields();
};

struct BodySetup {
  std::string name;
  BodyShape shape;
  std::optional<double> spacing;  ///< [m] of the lattice that fills the shape; absent for a point cloud
  double horizon_ratio = 3.015;
  Vec3d position{};  ///< [m] of the shape's origin: of a box, cylinder or sphere its centre
  Vec3d rotate{};    ///< [rad] of the body about x, then y, then z, through its position
  Vec3d velocity{};  ///< [m/s]
  Choice family{family_words};
  Choice normalisation{normalisation_words};
  Choice surface_correction{surface_correction_words};
  Choice bending_calibration{thin_axis_words};  ///< axis across a thin plate whose bending stiffness is calibrated
  bool published = false;                       ///< discretisation of the FCCDA paper: madenci-oterkus, continuum, none
  Choice plane{plane_words};                    ///< of a 2-D body, a single layer in z
  MaterialSetup material;
  std::optional<FailureSetup> failure;
  std::vector<SolidSetup> add;            ///< Boolean union with the shape
  std::vector<SolidSetup> holes;          ///< subtracted from it
  std::vector<SolidSetup> particle_sets;  ///< named sets of the particles in a solid
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

/// One box fixed to the impactor, outside which contact is not searched (Zhang et al., section 3.1, example 1).
struct BoxRegionSetup {
  static constexpr std::string_view name = "box";
  Vec3d size{};    ///< [m]
  Vec3d centre{};  ///< [m] from the surface's origin
  static std::span<const Field<BoxRegionSetup>> fields();
};

/// One box of a union.
struct BoundsBoxSetup {
  std::string name;
  Vec3d size{};    ///< [m]
  Vec3d centre{};  ///< [m] from the surface's origin
  static std::span<const Field<BoundsBoxSetup>> fields();
};

/// Union of boxes (example 2), given by name or fitted to the surface.
struct BoxUnionBoundsSetup {
  static constexpr std::string_view name = "box_union";
  std::optional<int> count;    ///< maximum number of fitted boxes
  std::optional<double> gain;  ///< [-] share of the bounding box that a further fitted box must save
  std::vector<BoundsBoxSetup> boxes;
  static std::span<const Field<BoxUnionBoundsSetup>> fields();
};

/// Cylinder with a fan of sectors that rotates with the impactor (example 3). Absent values are fitted to the surface.
struct CylinderSectorsBoundsSetup {
  static constexpr std::string_view name = "cylinder_sectors";
  std::optional<Vec3d> axis;
  std::optional<Vec3d> point;                        ///< [m] from the surface's origin
  std::optional<double> radius, length, hub_radius;  ///< [m]
  std::optional<int> blades;
  std::optional<double> sector_angle, start_angle;  ///< [rad]
  static std::span<const Field<CylinderSectorsBoundsSetup>> fields();
};

/// Contact bounds chosen automatically for the surface.
struct AutoBoundsSetup {
  static constexpr std::string_view name = "auto";
  static std::span<const Field<AutoBoundsSetup>> fields();
};

struct ContactBoundsSetup {
  /// monostate: no bounds, the whole surface
  std::variant<std::monostate, BoxRegionSetup, BoxUnionBoundsSetup, CylinderSectorsBoundsSetup, AutoBoundsSetup> shape;
  Choice on_exceed{on_exceed_words};
  static std::span<const Field<ContactBoundsSetup>> fields();
};

/// Local refinement of panels. Box, part and angle restrict it jointly (docs/theory/remeshing.md).
struct RefinementSetup {
  std::string name;
  double edge_length{};               ///< [m] longest edge
  std::optional<BoxRegionSetup> box;  ///< no restriction where absent
  std::string surface_part;           ///< of the surface; all where empty
  std::optional<double> angle;        ///< [rad] largest turn between panels of curved areas; no restriction where absent
  static std::span<const Field<RefinementSetup>> fields();
};

/// Coarsening of panels that are finer than the shape requires.
struct CoarseningSetup {
  double max_deviation{};                 ///< [m] of the surface from its original shape
  std::optional<double> max_edge_length;  ///< [m] no limit where absent
  static std::span<const Field<CoarseningSetup>> fields();
};

/// Gauge: resultant contact force and moment on parts of the surface, like a load cell.
struct GaugeSetup {
  std::string name;
  std::vector<std::string> surface_parts;  ///< of the surface; all where empty
  std::optional<Vec3d> point;              ///< [m] reference point of moments, fixed to the surface; the centre of mass where absent
  std::optional<Vec3d> axis;               ///< direction of the torque, in the surface's axes
  static std::span<const Field<GaugeSetup>> fields();
};

/// Prescribed motion of one degree of freedom.
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

  /// The table of a degree of freedom, indexed as in degree_words; null where there is none.
  const MotionTable* of(std::size_t degree) const;
  MotionTable* of(std::size_t degree);
};

/// Applied force and moment on the impactor, in global axes.
struct LoadSetup {
  std::string name;
  Vec3d force{};               ///< [N]
  Vec3d moment{};              ///< [N m]
  std::optional<Vec3d> point;  ///< [m] of application, fixed to the surface; the centre of mass where absent
  std::vector<double> times;   ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<LoadSetup>> fields();
};

/// Weight, buoyancy and added mass of an impactor in still water (docs/theory/floating_bodies.md).
struct FloatingImpactorSetup {
  double level = 0;       ///< [m] z of the free surface
  double density = 1025;  ///< [kg/m³] of the water
  double gravity = 9.81;  ///< [m/s²]
  double added_mass = 0;  ///< [-] share of the water displaced at rest, for vertical motion
  double damping = 0;     ///< [1/s] of heave, roll and pitch
  static std::span<const Field<FloatingImpactorSetup>> fields();
};

struct ImpactorSetup {
  std::string name;
  SurfaceSetup surface;
  std::optional<double> mass;           ///< [kg]; this or the density
  std::optional<double> density;        ///< [kg/m³] of a uniformly filled closed surface
  std::optional<Vec3d> centre_of_mass;  ///< [m] from the surface's origin; that of the uniformly filled surface where absent
  std::optional<Vec3d> inertia;         ///< [kg m²] about the centre of mass, along the surface's axes; from the closed surface where absent
  Vec3d position{};                     ///< [m] of the surface's origin at t = 0
  Vec3d velocity{};                     ///< [m/s]
  Vec3d angular_velocity{};             ///< [rad/s]
  std::vector<std::string> free_dofs;   ///< of x y z rx ry rz; the others are prescribed or keep their velocity
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

/// Displacement probe: mean over the particles nearest to a reference point.
struct ProbeSetup {
  std::string name;
  std::string body;
  Vec3d at{};  ///< [m] in the reference configuration
  static std::span<const Field<ProbeSetup>> fields();
};

/// Displacements along a line of particles at chosen times, one CSV file per time.
struct LineSetup {
  std::string name;
  std::string body;
  Vec3d from{}, to{};         ///< [m] in the reference configuration
  std::vector<double> times;  ///< [s]; the end of the run where empty
  static std::span<const Field<LineSetup>> fields();
};

struct OutputSetup {
  std::string folder = "results";
  int frames = 40;                         ///< number of output frames after the one at t = 0; 0: none
  std::optional<double> history_interval;  ///< [s] between rows of history.csv; a hundredth of the run where absent
  double checkpoint_interval = 300;        ///< [s] wall-clock time; 0: only the final one
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
