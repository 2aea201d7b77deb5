/// Setup: the contents of a deck as plain structs with all defaults. `io/deck` fills it from YAML; the bindings fill the same structs.
/// Each struct lists its simple fields in setup.cpp (base/parameter.hpp); io/deck/schema.hpp lists the nested ones. SI units throughout.
#pragma once

#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"
#include "perimpact/boundary_conditions/all_setups.hpp"
#include "perimpact/contact_bounds/all_setups.hpp"
#include "perimpact/deck_model/frame_selection.hpp"
#include "perimpact/deck_model/generated_surfaces.hpp"
#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/solids.hpp"
#include "perimpact/materials/all_setups.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;
using fccda::Vec3d;

inline constexpr std::string_view surface_correction_words[] = {"automatic", "energy", "volume", "none"};
enum class SurfaceCorrection { automatic, energy, volume, none };
static_assert(fccda::are_enumerators<SurfaceCorrection>(surface_correction_words));

inline constexpr std::string_view family_words[] = {"hu-ha-bobaru", "madenci-oterkus"};
enum class FamilyRule { hu_ha_bobaru, madenci_oterkus };
static_assert(fccda::are_enumerators<FamilyRule>(family_words));

inline constexpr std::string_view normalisation_words[] = {"lattice", "continuum"};
enum class Normalisation { lattice, continuum };
static_assert(fccda::are_enumerators<Normalisation>(normalisation_words));

inline constexpr std::string_view thin_axis_words[] = {"none", "x", "y", "z"};
enum class ThinAxis { none, x, y, z };
static_assert(fccda::are_enumerators<ThinAxis>(thin_axis_words));

inline constexpr std::string_view plane_words[] = {"none", "stress", "strain"};
static_assert(fccda::are_enumerators<Plane>(plane_words));

inline constexpr std::string_view compression_words[] = {"none", "symmetric", "limit"};
enum class CompressionFailure { none, symmetric, limit };
static_assert(fccda::are_enumerators<CompressionFailure>(compression_words));

inline constexpr std::string_view panel_words[] = {"triangles", "quads"};

inline constexpr std::string_view detector_words[] = {"swept", "published", "analytic"};
enum class DetectorKind { swept, published, analytic };
static_assert(fccda::are_enumerators<DetectorKind>(detector_words));

inline constexpr std::string_view variant_words[] = {"corrected", "literal"};

inline constexpr std::string_view initial_overlap_words[] = {"error", "remove", "project"};
enum class InitialOverlap { error, remove, project };
static_assert(fccda::are_enumerators<InitialOverlap>(initial_overlap_words));

inline constexpr std::string_view on_exceed_words[] = {"error", "clip"};

inline constexpr std::string_view fragment_law_words[] = {"none", "repulsive"};
enum class FragmentLaw { none, repulsive };
static_assert(fccda::are_enumerators<FragmentLaw>(fragment_law_words));

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

/// `boundary_conditions: {grip: {fixed: {particle_set: left}}}`
struct BoundaryConditionSetup {
  std::string name;
  BoundaryConditionKind kind;
};

inline constexpr std::string_view window_axis_words[] = {"x", "y"};
enum class WindowAxis { x, y };
static_assert(fccda::are_enumerators<WindowAxis>(window_axis_words));

/// A body that follows an impactor: material is added ahead and discarded behind (docs/theory/moving_window.md).
struct MovingWindowSetup {
  std::string follow;              ///< name of the impactor
  Choice axis{window_axis_words};  ///< along which it travels
  double start_after = 0;          ///< [m] travel of the impactor before the window follows it
  static std::span<const Field<MovingWindowSetup>> fields();
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
  double mass_scaling = 1;                      ///< inertia over the mass of the material (docs/theory/time_step.md)
  Choice plane{plane_words};                    ///< of a 2-D body, a single layer in z
  MaterialSetup material;
  std::optional<FailureSetup> failure;
  std::vector<SolidSetup> add;            ///< Boolean union with the shape
  std::vector<SolidSetup> holes;          ///< subtracted from it
  std::vector<SolidSetup> particle_sets;  ///< named sets of the particles in a solid
  std::vector<CrackSetup> cracks;
  std::vector<BoundaryConditionSetup> boundary_conditions;
  std::optional<MovingWindowSetup> moving_window;
  static std::span<const Field<BodySetup>> fields();

  bool is_plane() const { return plane.as<Plane>() != Plane::none; }
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

struct ContactBoundsSetup {
  /// monostate: no bounds, the whole surface
  ContactBoundsShape shape;
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
  std::vector<double> speeds;  ///< [m/s] along the force, of `speed_factors`; independent of speed where empty
  std::vector<double> speed_factors;
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

/// Elastic deformation of an impactor: vibration modes superposed on its rigid motion (docs/guide/elastic_impactors.md).
struct ElasticImpactorSetup {
  std::string modes;                        ///< path of the file of modes; a relative one starts at the deck's folder
  std::optional<double> damping;            ///< [-] ratio of critical damping of all modes; that of the file where absent
  std::optional<double> highest_frequency;  ///< [Hz] modes above are left out; none where absent
  static std::span<const Field<ElasticImpactorSetup>> fields();
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
  std::optional<ElasticImpactorSetup> elastic;  ///< rigid where absent
  std::vector<GaugeSetup> gauges;
  static std::span<const Field<ImpactorSetup>> fields();
};

// ---- contact ----

struct ImpactorContactSetup {
  Choice detector{detector_words};
  Choice variant{variant_words};  ///< of the published detector
  double friction = 0;
  double radius_ratio = 0.5;                ///< contact radius in spacings
  std::optional<double> crushing_pressure;  ///< [Pa]
  Choice initial_overlap{initial_overlap_words};
  static std::span<const Field<ImpactorContactSetup>> fields();
};

struct FragmentContactSetup {
  Choice law{fragment_law_words};
  bool is_chosen = false;     ///< the deck gives the law, also if it is `none`
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

inline constexpr std::string_view frame_format_words[] = {"vtp", "vtkhdf"};
enum class FrameFormat { vtp, vtkhdf };
static_assert(fccda::are_enumerators<FrameFormat>(frame_format_words));

struct OutputSetup {
  std::string folder = "results";
  int frames = 40;                          ///< number of output frames after the one at t = 0; 0: none
  Choice frame_format{frame_format_words};  // FrameFormat
  std::vector<std::string> frame_fields{std::begin(frame_field_words), std::end(frame_field_words)};
  std::optional<FrameParticlesSetup> frame_particles;  ///< all where absent
  std::optional<double> history_interval;              ///< [s] between rows of history.csv; a hundredth of the run where absent
  double checkpoint_interval = 300;                    ///< [s] wall-clock time; 0: only the final one
  int checkpoints_kept = 1;                            ///< number of the latest checkpoints that are kept
  std::vector<ProbeSetup> probes;
  std::vector<LineSetup> lines;
  static std::span<const Field<OutputSetup>> fields();

  bool writes(std::string_view field) const;  ///< field of the particles, in frames
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
