#include "io/deck/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "io/deck/consistency_boundary.hpp"
#include "io/deck/consistency_fragments.hpp"
#include "io/deck/consistency_frames.hpp"
#include "io/deck/consistency_impactor.hpp"
#include "io/deck/consistency_material.hpp"
#include "io/deck/consistency_solid.hpp"
#include "io/deck/deck_file.hpp"
#include "io/deck/did_you_mean.hpp"
#include "io/deck/schema.hpp"
#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/distinct_words.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact::deck {

namespace fs = std::filesystem;

namespace {

void check_time(const TimeSetup& time, const Places& places) {
  if (time.step && *time.step > time.end)
    refuse(places.of("time.step"), fmt::format("step is {} s, longer than the whole run of {} s; use a smaller step or a later end.", *time.step, time.end));
}

/// Tables of one object have the name of another: fragments/sheet_end.csv is the second table of the body sheet, and would be the first of sheet_end.
template <class Named>
void expect_other_tables(std::span<const Named> all, std::string_view kind, std::string_view folder, std::initializer_list<std::string_view> endings,
                         const Places& places) {
  for (const Named& one : all)
    for (const std::string_view ending : endings)
      for (const Named& other : all)
        if (other.name == one.name + std::string(ending))
          refuse(places.of(fmt::format("{}.{}", kind, other.name)),
                 fmt::format("{}/{}.csv is already a table of {}; choose a name that does not end in {}.", folder, other.name, one.name, ending));
}

/// Names of bodies, impactors and probes are prefixes of columns in history.csv, as is total.
void check_names(const Setup& setup, const Places& places) {
  std::set<std::string> taken = {"total"};
  const auto take = [&](const std::string& path, const std::string& name) {
    if (!taken.insert(name).second)
      refuse(places.of(path),
             fmt::format("the name {} is already in use; bodies, impactors, probes and total share the columns of history.csv, so choose another.", name));
  };
  for (const BodySetup& body : setup.bodies) take("bodies." + body.name, body.name);
  for (const ImpactorSetup& impactor : setup.impactors) take("impactors." + impactor.name, impactor.name);
  for (const ProbeSetup& probe : setup.output.probes) take("output.probes." + probe.name, probe.name);
  expect_other_tables<BodySetup>(setup.bodies, "bodies", "fragments", {"_end", "_channel_x", "_channel_y"}, places);
  expect_other_tables<ImpactorSetup>(setup.impactors, "impactors", "pressure_area", {"_at_peak"}, places);
}

void apply_published(BodySetup& body, const std::string& path, const Places& places) {
  if (!body.published) return;
  for (const std::string_view key : set_by_published) {
    if (places.has(fmt::format("{}.{}", path, key)))
      refuse(places.of(fmt::format("{}.{}", path, key)), fmt::format("{} is given together with published: true, which sets it; remove one of the two.", key));
  }
  body.family.index = static_cast<int>(FamilyRule::madenci_oterkus);
  body.normalisation.index = static_cast<int>(Normalisation::continuum);
  body.surface_correction.index = static_cast<int>(SurfaceCorrection::none);
}

void check_body(BodySetup& body, bool is_quasi_static, const fs::path& folder, const Places& places) {
  const std::string path = "bodies." + body.name;
  apply_published(body, path, places);
  make_material_consistent(body, is_quasi_static, places);
  make_shape_consistent(body, folder, places);
}

void check_bounds(const ContactBoundsSetup& bounds, const std::string& path, const Places& places) {
  if (bounds.on_exceed.word() == "clip" && std::holds_alternative<std::monostate>(bounds.shape))
    refuse(places.of(path + ".on_exceed"), "on_exceed is clip, but there are no contact bounds that the surface could exceed; give them, or remove on_exceed.");
  for_each_alternative(bounds.shape, [&]<class Shape>(const Shape&) {
    if (const auto* shape = std::get_if<Shape>(&bounds.shape)) shape->check({fmt::format("{}.{}", path, Shape::name), places});
  });
}

bool is_fitted(const ContactBoundsSetup& bounds) {
  bool is = false;
  for_each_alternative(bounds.shape, [&]<class Shape>(const Shape&) {
    if (const auto* shape = std::get_if<Shape>(&bounds.shape)) is = shape->is_fitted();
  });
  return is;
}

void check_impactor(const ImpactorSetup& impactor, const Places& places) {
  const std::string path = "impactors." + impactor.name;
  check_bounds(impactor.contact_bounds, path + ".contact_bounds", places);
  const auto refuse_here = [&](const std::string& sentence) { refuse(places.of(path + ".free_dofs"), sentence); };
  const auto expect_known = [&](const std::string& direction) {
    if (std::find(std::begin(degree_words), std::end(degree_words), direction) == std::end(degree_words))
      refuse_here(fmt::format("free_dofs contains \"{}\", which is not a degree of freedom; known are {}.", direction, fmt::join(degree_words, ", ")));
  };
  check_distinct("free_dofs", impactor.free_dofs, expect_known, refuse_here);
}

/// Far from the origin, coordinates are rounded to more than the displacements of particles.
void check_positions(const Setup& setup, const Places& places) {
  double spacing = std::numeric_limits<double>::infinity();
  for (const BodySetup& body : setup.bodies)
    if (body.spacing) spacing = std::min(spacing, *body.spacing);
  if (!std::isfinite(spacing)) return;
  constexpr double rounding = 2.2e-16, fine_enough = 1e-6;                  // of the spacing
  const double furthest = std::max(1.0, fine_enough * spacing / rounding);  // within a metre even atoms are resolved
  const auto check = [&](const std::string& path, const Vec3d& position) {
    const double distance = std::max({std::fabs(position.x), std::fabs(position.y), std::fabs(position.z)});
    if (distance <= furthest) return;
    refuse(places.of(path + ".position"),
           fmt::format("position is {:.3g} m from the origin, where coordinates are rounded to {:.1g} m, more than a millionth of the spacing of {:.4g} m; use "
                       "positions within {:.2g} m of the origin, or check the unit.",
                       distance, distance * rounding, spacing, furthest));
  };
  for (const BodySetup& body : setup.bodies) check("bodies." + body.name, body.position);
  for (const ImpactorSetup& impactor : setup.impactors) check("impactors." + impactor.name, impactor.position);
}

void check_contact(Setup& setup, const Places& places) {
  ImpactorContactSetup& contact = setup.contact.impactors;
  const std::string path = "contact.impactors.";
  const auto detector = contact.detector.as<DetectorKind>();
  if (detector == DetectorKind::published) {
    if (!places.has(path + "radius_ratio")) contact.radius_ratio = 0;
    if (contact.radius_ratio != 0)
      refuse(places.of(path + "radius_ratio"),
             fmt::format("radius_ratio is {}, but the published detector treats particles as points; set radius_ratio: 0, or detector: swept.",
                         contact.radius_ratio));
    if (contact.friction != 0)
      refuse(places.of(path + "friction"),
             fmt::format("friction is {}, but the published detector is frictionless, as in the FCCDA paper; set friction: 0, or detector: swept.",
                         contact.friction));
  } else if (contact.variant.word() != "corrected") {
    refuse(places.of(path + "variant"),
           fmt::format("variant is {}, but only the published detector has variants, and detector is {}; remove variant, or set detector: published.",
                       contact.variant.word(), contact.detector.word()));
  }
  if (contact.crushing_pressure && detector != DetectorKind::swept)
    refuse(places.of(path + "crushing_pressure"),
           fmt::format("crushing_pressure changes the contact radius of particles, which detector {} keeps; remove it, or set detector: swept.",
                       contact.detector.word()));
  if (contact.crushing_pressure && contact.radius_ratio == 0)
    refuse(places.of(path + "crushing_pressure"),
           "crushing_pressure acts on the material within the contact radius of a particle, but radius_ratio is 0; remove one of the two.");
  if (detector != DetectorKind::analytic) return;
  for (const ImpactorSetup& impactor : setup.impactors) {
    if (!std::holds_alternative<CylinderSurface>(impactor.surface) && !std::holds_alternative<SphereSurface>(impactor.surface))
      refuse(places.of(path + "detector"),
             fmt::format("detector is analytic, which supports cylinders and spheres only, but the surface of {} is of another kind; set detector: swept.",
                         impactor.name));
    if (is_fitted(impactor.contact_bounds))
      refuse(places.of("impactors." + impactor.name + ".contact_bounds"),
             "contact_bounds are fitted to the panels of the surface, but the analytic detector uses the exact shape; give a box, or set detector: swept.");
  }
}

void check_body_name(const std::string& name, const Setup& setup, const std::string& path, const Places& places) {
  std::vector<std::string> names;
  for (const BodySetup& body : setup.bodies) names.push_back(body.name);
  if (std::find(names.begin(), names.end(), name) == names.end())
    refuse(places.of(path + ".body"), fmt::format("body is \"{}\", but there is no such body; {}", name, suggestion(name, names)));
}

void check_output(const Setup& setup, const Places& places) {
  check_frames(setup, places);
  for (const ProbeSetup& probe : setup.output.probes) check_body_name(probe.body, setup, "output.probes." + probe.name, places);
  for (const LineSetup& line : setup.output.lines) {
    const std::string path = "output.lines." + line.name;
    check_body_name(line.body, setup, path, places);
    if (line.from == line.to) refuse(places.of(path + ".to"), fmt::format("to equals from, so {} has zero length; move one of the two points.", line.name));
    for (const double time : line.times) {
      if (time > setup.time.end)
        refuse(places.of(path + ".times"),
               fmt::format("times contains {} s, but the run ends at {} s; use earlier times or a later end.", time, setup.time.end));
    }
  }
}

}  // namespace

void make_consistent(Setup& setup, const Places& places, const fs::path& folder, const SurfacesInMemory& surfaces) try {
  check_time(setup.time, places);
  check_names(setup, places);
  find_surfaces(setup, folder, surfaces, places);
  check_positions(setup, places);
  const bool is_quasi_static = setup.time.relax.has_value();
  for (BodySetup& body : setup.bodies) check_body(body, is_quasi_static, folder, places);
  for (BodySetup& body : setup.bodies) make_boundary_conditions_consistent(body, is_quasi_static, folder, places);
  check_relaxation(setup, places);
  for (const ImpactorSetup& impactor : setup.impactors) check_impactor(impactor, places);
  for (ImpactorSetup& impactor : setup.impactors) make_impactor_consistent(impactor, setup.contact.impactors.detector.as<DetectorKind>(), folder, places);
  check_contact(setup, places);
  setup.contact.fragments.is_chosen = places.has("contact.fragments.law");
  check_fragments(setup.contact.fragments, places);
  check_output(setup, places);
} catch (const SetupError& error) {
  refuse(places.of(error.key()), error.what());
}

}  // namespace perimpact::deck
