#include "io/deck/setup_to_text.hpp"

#include <algorithm>
#include <random>

#include "fixtures/temporary_folder.hpp"
#include "io/deck/fixtures.hpp"
#include "io/deck/schema.hpp"

using namespace perimpact;
using fixtures::read;

namespace {

using Random = std::mt19937_64;

// Any value that the range allows, with all the digits of a double.
double some_number(Random& random, const fccda::Range& range) {
  const double low = std::max(range.low, -1e6), high = std::min(range.high, 1e6);
  return std::uniform_real_distribution<double>(std::nextafter(low, high), high)(random);
}
void fill(Random& random, const fccda::Range& range, double& value) { value = some_number(random, range); }
void fill(Random& random, const fccda::Range& range, int& value) { value = static_cast<int>(some_number(random, range)); }
void fill(Random& random, const fccda::Range&, bool& value) { value = random() % 2; }
void fill(Random& random, const fccda::Range&, Choice& value) { value.index = static_cast<int>(random() % value.words.size()); }
void fill(Random& random, const fccda::Range& range, Vec3d& value) {
  for (std::size_t axis = 0; axis < 3; ++axis) fill(random, range, value[axis]);
}
void fill(Random& random, const fccda::Range&, std::string& value) {
  constexpr std::string_view letters[] = {"a", "Z", " ", "\"", "\\",   "\n", "\t", "\x01", ": ", "# ", "{",   "]",
                                          "é", "∛", "'", "~",  "null", "-",  "&",  "*",    "!",  "%",  "\x7f"};
  value.clear();
  for (std::size_t i = random() % 12; i > 0; --i) value += letters[random() % std::size(letters)];
  if (value.starts_with('~')) value.insert(0, "a");  // the paths of a resolved deck are expanded
}
template <class T>
void fill(Random& random, const fccda::Range& range, std::optional<T>& value) {
  if (random() % 2) fill(random, range, value.emplace());
}
template <class T>
void fill(Random& random, const fccda::Range& range, std::vector<T>& values) {
  values.resize(random() % 3);
  for (T& value : values) fill(random, range, value);
}
template <class T>
void fill_fields(Random& random, T& into) {
  for (const Field<T>& field : T::fields()) std::visit([&](auto member) { fill(random, field.range, into.*member); }, field.member);
}

bool same(const Choice& a, const Choice& b) { return a.index == b.index; }
template <class T>
bool same(const T& a, const T& b) {
  return a == b;
}
template <class T>
void check_fields(const T& a, const T& b) {
  for (const Field<T>& field : T::fields()) CHECK_MESSAGE(std::visit([&](auto member) { return same(a.*member, b.*member); }, field.member), field.name);
}
template <class... T>
void check_alternative(const std::variant<T...>& a, const std::variant<T...>& b) {
  REQUIRE(a.index() == b.index());
  std::visit(
      [&]<class Chosen>(const Chosen& chosen) {
        if constexpr (deck::Described<Chosen>) check_fields(chosen, std::get<Chosen>(b));
      },
      a);
}

void check_solids(const std::vector<SolidSetup>& a, const std::vector<SolidSetup>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    CHECK(a[k].name == b[k].name);
    check_fields(a[k], b[k]);
    check_alternative(a[k].shape, b[k].shape);
  }
}

void check_same(const Setup& a, const Setup& b) {
  check_fields(a, b);
  check_fields(a.time, b.time);
  REQUIRE(a.time.relax.has_value() == b.time.relax.has_value());
  if (a.time.relax) check_fields(*a.time.relax, *b.time.relax);
  REQUIRE(a.bodies.size() == b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    CHECK(a.bodies[i].name == b.bodies[i].name);
    check_fields(a.bodies[i], b.bodies[i]);
    check_alternative(a.bodies[i].shape, b.bodies[i].shape);
    check_solids(a.bodies[i].add, b.bodies[i].add);
    check_solids(a.bodies[i].holes, b.bodies[i].holes);
    check_solids(a.bodies[i].particle_sets, b.bodies[i].particle_sets);
    REQUIRE(a.bodies[i].cracks.size() == b.bodies[i].cracks.size());
    for (std::size_t k = 0; k < a.bodies[i].cracks.size(); ++k) check_fields(a.bodies[i].cracks[k], b.bodies[i].cracks[k]);
    check_alternative(a.bodies[i].material, b.bodies[i].material);
    REQUIRE(a.bodies[i].boundary_conditions.size() == b.bodies[i].boundary_conditions.size());
    for (std::size_t k = 0; k < a.bodies[i].boundary_conditions.size(); ++k) {
      CHECK(a.bodies[i].boundary_conditions[k].name == b.bodies[i].boundary_conditions[k].name);
      check_alternative(a.bodies[i].boundary_conditions[k].kind, b.bodies[i].boundary_conditions[k].kind);
      if (const auto* prescribed = std::get_if<PrescribedSetup>(&a.bodies[i].boundary_conditions[k].kind))
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto &one = prescribed->of(axis), &other = std::get<PrescribedSetup>(b.bodies[i].boundary_conditions[k].kind).of(axis);
          REQUIRE(one.has_value() == other.has_value());
          if (one) check_fields(*one, *other);
        }
    }
  }
  REQUIRE(a.impactors.size() == b.impactors.size());
  for (std::size_t i = 0; i < a.impactors.size(); ++i) {
    CHECK(a.impactors[i].name == b.impactors[i].name);
    check_fields(a.impactors[i], b.impactors[i]);
    check_alternative(a.impactors[i].surface, b.impactors[i].surface);
    if (const auto* propeller = std::get_if<PropellerSurface>(&a.impactors[i].surface)) {
      const auto& again = std::get<PropellerSurface>(b.impactors[i].surface).sections;
      REQUIRE(propeller->sections.has_value() == again.has_value());
      if (again) check_fields(*propeller->sections, *again);
    }
    check_fields(a.impactors[i].contact_bounds, b.impactors[i].contact_bounds);
    check_alternative(a.impactors[i].contact_bounds.shape, b.impactors[i].contact_bounds.shape);
    for (std::size_t degree = 0; degree < 6; ++degree) {
      const MotionTable *one = a.impactors[i].motion.of(degree), *other = b.impactors[i].motion.of(degree);
      REQUIRE((one == nullptr) == (other == nullptr));
      if (one) CHECK((one->times == other->times && one->velocities == other->velocities && one->displacements == other->displacements));
    }
    REQUIRE(a.impactors[i].loads.size() == b.impactors[i].loads.size());
    for (std::size_t k = 0; k < a.impactors[i].loads.size(); ++k) check_fields(a.impactors[i].loads[k], b.impactors[i].loads[k]);
    REQUIRE(a.impactors[i].gauges.size() == b.impactors[i].gauges.size());
    for (std::size_t k = 0; k < a.impactors[i].gauges.size(); ++k) check_fields(a.impactors[i].gauges[k], b.impactors[i].gauges[k]);
    if (const auto* boxes = std::get_if<BoxUnionBoundsSetup>(&a.impactors[i].contact_bounds.shape)) {
      const auto& others = std::get<BoxUnionBoundsSetup>(b.impactors[i].contact_bounds.shape).boxes;
      REQUIRE(boxes->boxes.size() == others.size());
      for (std::size_t k = 0; k < others.size(); ++k) {
        CHECK(boxes->boxes[k].name == others[k].name);
        check_fields(boxes->boxes[k], others[k]);
      }
    }
  }
  check_fields(a.contact.impactors, b.contact.impactors);
  check_fields(a.contact.fragments, b.contact.fragments);
  check_fields(a.output, b.output);
  REQUIRE(a.output.probes.size() == b.output.probes.size());
  for (std::size_t i = 0; i < a.output.probes.size(); ++i) check_fields(a.output.probes[i], b.output.probes[i]);
  REQUIRE(a.output.lines.size() == b.output.lines.size());
  for (std::size_t i = 0; i < a.output.lines.size(); ++i) check_fields(a.output.lines[i], b.output.lines[i]);
  const auto &ours = a.output.frame_particles, &theirs = b.output.frame_particles;
  REQUIRE(ours.has_value() == theirs.has_value());
  if (!ours) return;
  check_fields(*ours, *theirs);
  REQUIRE(ours->boxes.size() == theirs->boxes.size());
  for (std::size_t i = 0; i < ours->boxes.size(); ++i) check_fields(ours->boxes[i], theirs->boxes[i]);
}

/// Fields and particles of frames, of which a deck allows few.
void fill_frames(Random& random, OutputSetup& output) {
  output.frame_fields.resize(random() % 4);
  for (std::size_t i = 0; i < output.frame_fields.size(); ++i) output.frame_fields[i] = std::array{"velocity", "fragment", "damage"}[i];
  if (random() % 2 == 0) return;
  fill_fields(random, output.frame_particles.emplace());
  FrameBoxSetup& box = output.frame_particles->boxes.emplace_back();
  fill_fields(random, box);
  box.name = "bow", box.upper = box.lower + Vec3d{1, 2, 3};
}

/// Increasing times with a value each.
void fill_table(Random& random, std::vector<double>& times, std::vector<double>& values) {
  double time = 0;
  for (std::size_t k = 1 + random() % 4; k > 0; --k) {
    times.push_back(time += 1e-3 * static_cast<double>(1 + random() % 7));
    values.push_back(some_number(random, {}));
  }
}

/// One of each kind, with nothing along z, which a plane body cannot have.
void add_boundaries(Random& random, BodySetup& body, bool relaxes) {
  const auto some = [&]<class Kind>(Kind kind) {
    fill_fields(random, kind);
    if constexpr (requires { kind.factors; }) kind.times.clear(), kind.factors.clear();
    if constexpr (requires { kind.face; }) kind.face.index %= 4;
    return kind;
  };
  FixedSetup fixed = some(FixedSetup{});
  fixed.directions = {"z", "x"};
  body.boundary_conditions = {{"grip", fixed}};
  PrescribedSetup prescribed = some(PrescribedSetup{});
  if (random() % 2) prescribed.x.emplace().velocity = some_number(random, {});
  DisplacementSetup& course = prescribed.y.emplace();
  fill_table(random, course.times, random() % 2 ? course.velocities : course.displacements);
  body.boundary_conditions.push_back({"pull", prescribed});
  BodyForceSetup weight = some(BodyForceSetup{});
  weight.force_density.z = 0;
  if (random() % 2) fill_table(random, weight.times, weight.factors);
  body.boundary_conditions.push_back({"weight", weight});
  body.boundary_conditions.push_back({"push", some(PressureSetup{})});
  if (!relaxes) body.boundary_conditions.push_back({"sink", some(AbsorbingSetup{})});
}

void add_motion_loads_and_gauges(Random& random, ImpactorSetup& impactor) {
  // of y and ry, which are constrained here
  TranslationTable& heave = impactor.motion.y.emplace();
  fill_table(random, heave.times, random() % 2 ? heave.velocities : heave.displacements);
  RotationTable& turn = impactor.motion.ry.emplace();
  fill_table(random, turn.times, turn.velocities);
  std::erase(impactor.free_dofs, "ry");
  impactor.velocity.y = impactor.angular_velocity.y = 0;
  LoadSetup& load = impactor.loads.emplace_back();
  fill_fields(random, load);
  load.name = "thrust", load.times.clear(), load.factors.clear(), load.speeds.clear(), load.speed_factors.clear();
  if (random() % 2) fill_table(random, load.times, load.factors);
  if (random() % 2) fill_table(random, load.speeds, load.speed_factors);
  GaugeSetup& gauge = impactor.gauges.emplace_back();
  fill_fields(random, gauge);
  gauge.name = "root", gauge.surface_parts.clear();
}

void fill_region(Random& random, ContactBoundsSetup& region) {
  switch (random() % 6) {
    case 1:
      fill_fields(random, region.shape.emplace<BoxRegionSetup>());
      break;
    case 2:
      fill_fields(random, region.shape.emplace<BoxUnionBoundsSetup>());
      break;
    case 3:
      for (const char* name : {"bow", "stern"}) {
        if (!std::holds_alternative<BoxUnionBoundsSetup>(region.shape)) region.shape.emplace<BoxUnionBoundsSetup>();
        BoundsBoxSetup& box = std::get<BoxUnionBoundsSetup>(region.shape).boxes.emplace_back();
        fill_fields(random, box);
        box.name = name;
      }
      break;
    case 4: {
      auto& sectors = region.shape.emplace<CylinderSectorsBoundsSetup>();
      fill_fields(random, sectors);
      if (!sectors.sector_angle) sectors.start_angle.reset();
      if (sectors.radius && sectors.hub_radius) sectors.hub_radius = std::min(*sectors.hub_radius, *sectors.radius);
      break;
    }
    case 5:
      region.shape.emplace<AutoBoundsSetup>();
      break;
    default:
      region.on_exceed.index = 0;  // without a region there is nothing to clip
      break;
  }
}

/// A file of one particle.
std::string point_file() {
  static const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "points.csv", "x [m], y [m], z [m], volume [m3]\n0, 0, 0, 1\n");
  return (folder / "points.csv").string();
}

template <class Shape>
void fill_shape(Random& random, Shape& shape) {
  std::visit(
      [&]<class Chosen>(Chosen& chosen) {
        fill_fields(random, chosen);
        if constexpr (std::is_same_v<Chosen, FileSolid> || std::is_same_v<Chosen, CellsShape>) chosen.file = PROJECT_FOLDER "/LICENSE";  // exists
        if constexpr (std::is_same_v<Chosen, PointsShape>) chosen.file = point_file();
      },
      shape);
}

std::vector<SolidSetup> some_solids(Random& random) {
  const SolidShape shapes[] = {BoxSolid{}, CylinderSolid{}, SphereSolid{}, FileSolid{}};
  std::vector<SolidSetup> solids;
  for (std::size_t k = random() % 3; k > 0; --k) {
    SolidSetup& solid = solids.emplace_back();
    fill_fields(random, solid);
    solid.name = "solid_" + std::to_string(k);
    solid.shape = shapes[random() % std::size(shapes)];
    fill_shape(random, solid.shape);
  }
  return solids;
}

void fill_shapes(Random& random, BodySetup& body) {
  const BodyShape shapes[] = {BoxSolid{}, CylinderSolid{}, SphereSolid{}, FileSolid{}, PointsShape{}, CellsShape{}};
  body.shape = shapes[random() % std::size(shapes)];
  fill_shape(random, body.shape);
  body.add = some_solids(random), body.holes = some_solids(random), body.particle_sets = some_solids(random);
  if (!body.spacing) body.spacing = 0.01;
  if (body.shape.index() >= 4) body.spacing.reset(), body.add.clear();  // a cloud has none
  const auto set_thickness = [&](auto* cloud) {
    if (cloud) cloud->thickness = body.is_plane() ? std::optional(0.01) : std::nullopt;
  };
  set_thickness(std::get_if<PointsShape>(&body.shape)), set_thickness(std::get_if<CellsShape>(&body.shape));
  if (body.is_plane() && (std::holds_alternative<SphereSolid>(body.shape) || std::holds_alternative<CylinderSolid>(body.shape)))
    body.shape = BoxSolid{{1, 2, 3}};
  if (auto* box = std::get_if<BoxSolid>(&body.shape); box && body.add.empty() && random() % 2) {
    body.rotate = {};
    box->size = Vec3d{3, 20, 1} * *body.spacing;
  } else {
    body.rotate = {0, 0, 0.5};  // which no lattice fits anyhow, and a plane body may have
  }
  for (std::size_t k = random() % 3; k > 0; --k) {
    CrackSetup& crack = body.cracks.emplace_back();
    fill_fields(random, crack);
    crack.name = "crack_" + std::to_string(k);
  }
}

/// Any model, with at most one failure criterion.
void fill_material(Random& random, BodySetup& body) {
  const MaterialSetup models[] = {OrdinaryStateSetup{}, LinearSolidSetup{}, BondBasedSetup{}, CorrespondenceSetup{}};
  body.material = models[random() % std::size(models)];
  const bool is_correspondence = std::holds_alternative<CorrespondenceSetup>(body.material);
  const bool own_family = is_correspondence || std::holds_alternative<LinearSolidSetup>(body.material);
  if (own_family && !body.published) body.surface_correction.index = 0;
  if (own_family) body.published = false;
  if (is_correspondence) body.normalisation.index = 0;
  if (is_correspondence || !body.spacing || body.is_plane()) body.bending_calibration.index = 0;  // x and y would do in a plane body
  std::visit(
      [&](auto& material) {
        fill_fields(random, material);
        if (!material.youngs_modulus) material.youngs_modulus = 9e9;
        const auto kept = random() % 4;
        if (kept != 0) material.critical_stretch.reset();
        if (kept != 1) material.fracture_energy.reset();
        if (kept != 2) material.flexural_strength.reset();
        if (!material.flexural_strength) material.layers.reset();
        if (kept == 3 || !(material.critical_stretch || material.fracture_energy || material.flexural_strength)) return;
        if (random() % 2 == 0) material.ice = IceSetup{.brine_volume = 0.1};  // determines nothing that the keys above do not
        FailureSetup& failure = body.failure.emplace();
        fill_fields(random, failure);
        std::sort(failure.no_fail.begin(), failure.no_fail.end());
        failure.no_fail.erase(std::unique(failure.no_fail.begin(), failure.no_fail.end()), failure.no_fail.end());
        const bool is_limit = failure.compression.as<CompressionFailure>() == CompressionFailure::limit;
        if (is_limit != failure.critical_compression.has_value()) failure.compression.index = 0, failure.critical_compression.reset();
        if (failure.compression.index != 0) failure.compression_hardening = 0;
        if (!failure.weibull_modulus) failure.seed.reset();
      },
      body.material);
}

/// A Setup with values everywhere that a deck could have given.
Setup some_setup(Random& random) {
  Setup setup;
  fill_fields(random, setup);
  fill_fields(random, setup.time);
  if (setup.time.step) setup.time.step = std::min(*setup.time.step, setup.time.end);
  const bool relaxes = random() % 4 == 0;
  if (relaxes) fill_fields(random, setup.time.relax.emplace()), setup.time.step.reset();
  for (const char* name : {"plate", "floe-2"}) {
    BodySetup& body = setup.bodies.emplace_back();
    fill_fields(random, body);
    body.name = name;
    if (body.published) body.family.index = 1, body.normalisation.index = 1, body.surface_correction.index = 3;
    fill_shapes(random, body);
    fill_material(random, body);
    if (relaxes) body.velocity = {};
    if (random() % 2) add_boundaries(random, body, relaxes);
  }
  const SurfaceSetup surfaces[] = {CylinderSurface{}, SphereSurface{}, BoxSurface{}, HullSurface{}, PropellerSurface{}, PropellerSurface{}, FileSurface{}};
  for (const SurfaceSetup& surface : surfaces) {
    ImpactorSetup& impactor = setup.impactors.emplace_back();
    fill_fields(random, impactor);
    impactor.name = "impactor_" + std::to_string(setup.impactors.size());
    impactor.surface = surface;
    std::visit([&](auto& chosen) { fill_fields(random, chosen); }, impactor.surface);
    if (auto* propeller = std::get_if<PropellerSurface>(&impactor.surface); propeller && random() % 2) fill_fields(random, propeller->sections.emplace());
    if (auto* file = std::get_if<FileSurface>(&impactor.surface)) file->file = PROJECT_FOLDER "/LICENSE";  // exists
    impactor.free_dofs.resize(random() % 4);
    for (std::size_t i = 0; i < impactor.free_dofs.size(); ++i) impactor.free_dofs[i] = std::array{"rz", "x", "ry"}[i];
    fill_fields(random, impactor.contact_bounds);
    if (random() % 2) fill_fields(random, impactor.contact_bounds.shape.emplace<BoxRegionSetup>());
    if (random() % 2)
      impactor.mass.reset(), impactor.density = 900 + 0.1 * static_cast<double>(random() % 1000);
    else
      impactor.mass = 1 + 0.1 * static_cast<double>(random() % 1000), impactor.density.reset();
    if (random() % 2) add_motion_loads_and_gauges(random, impactor);
    fill_region(random, impactor.contact_bounds);
  }
  ImpactorContactSetup& contact = setup.contact.impactors;
  fill_fields(random, contact);
  if (contact.detector.as<DetectorKind>() == DetectorKind::published)
    contact.radius_ratio = contact.friction = 0, contact.crushing_pressure.reset();
  else
    contact.detector = contact.variant = {detector_words}, contact.variant = Choice{variant_words};
  if (relaxes)
    contact.crushing_pressure.reset();
  else
    fill_fields(random, setup.contact.fragments);
  if (setup.contact.fragments.law.as<FragmentLaw>() == FragmentLaw::none) setup.contact.fragments = {};
  fill_fields(random, setup.output);
  fill_frames(random, setup.output);
  if (relaxes) setup.output.history_interval.reset();
  ProbeSetup& probe = setup.output.probes.emplace_back();
  fill_fields(random, probe);
  probe.name = "centre", probe.body = "floe-2";
  LineSetup& line = setup.output.lines.emplace_back();
  fill_fields(random, line);
  line.name = "edge", line.body = "plate";
  for (double& time : line.times) time = std::min(time, setup.time.end);
  return setup;
}

}  // namespace

TEST_CASE("setup to text: the plate reads back from its own run.json") {
  const Setup setup = read(fixtures::plate).setup;
  check_same(setup, read(deck::setup_to_text(setup)).setup);
}

TEST_CASE("setup to text: a run with the analytic detector reads back from its own run.json") {
  const Setup setup = read(fixtures::plate_with("detector: swept", "detector: analytic")).setup;
  check_same(setup, read(deck::setup_to_text(setup)).setup);
}

TEST_CASE("setup to text: any setup reads back bitwise identical") {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Setup setup = some_setup(random);
    const std::string text = deck::setup_to_text(setup);
    INFO(text);
    check_same(setup, read(text).setup);
  }
}

TEST_CASE("setup to text: text is escaped as JSON requires, and absent values are omitted") {
  Setup setup = read(fixtures::plate).setup;
  setup.title = "a \"b\" \\ \n é";
  setup.time.step.reset();
  const std::string text = deck::setup_to_text(setup);
  CHECK(text.find(R"("title": "a \"b\" \\ \u000a é")") != std::string::npos);
  CHECK(text.find("\"step\"") == std::string::npos);
  CHECK(text.find("\"time\": {\n    \"end\": 0.0002\n  }") != std::string::npos);
}
