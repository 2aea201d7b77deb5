#include "perimpact/diagnostics/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/parallel.hpp"
#include "mesh/inspect/surface_measures.hpp"

namespace perimpact {

using namespace fccda;

namespace {

std::string at(const Vec3d& place) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", place.x, place.y, place.z); }

/// Speed of the particles relative to a point of the surface (in its local frame) [m/s].
double relative_speed(const Impactor& impactor, const Vec3d& place, const Target& target) {
  const Vec3d arm = impactor.body().pose().to_world(place) - impactor.body().position_of_com();
  return norm(impactor.fastest_velocity() + cross(impactor.fastest_angular_velocity(), arm) - target.velocity);
}

}  // namespace

Diagnosis inside_out(const Impactor& impactor) {
  const SurfaceReport& report = impactor.report_as_given();  // remeshed panels are already oriented outward
  const std::size_t flipped = report.flipped;
  if (flipped == 0) return std::nullopt;
  return fmt::format(
      "The normals of impactor {} point inward in {} of its {} components and were reversed, so that contact is on the outside; to avoid this warning, reverse "
      "them in the source of the surface.",
      impactor.name(), flipped, report.components);
}

Diagnosis goes_through_itself(const Impactor& impactor) {
  if (impactor.crossing_panels() == 0) return std::nullopt;
  return fmt::format(
      "{} panels of impactor {} intersect within one body. {}; `perimpact mesh` writes them to a VTP file.", impactor.crossing_panels(), impactor.name(),
      impactor.surface().is_closed() ? "Contact from outside is detected nevertheless, but doubly enclosed parts count twice in the volume"
                                     : "Where the surface is open, the outer side between them is undefined; repair the fold if contact occurs there");
}

Diagnosis is_cut(const Impactor& impactor) {
  const SurfaceReport& report = impactor.report_as_given();
  if (report.cut_edges == 0) return std::nullopt;
  return fmt::format(
      "The surface of impactor {} is cut along {} non-manifold edges (more than two panels), because the connected panels are ambiguous there. Near these "
      "edges a particle is in contact when its centre crosses a panel, not at the contact radius; delete inner walls if this matters.",
      impactor.name(), report.cut_edges);
}

Diagnosis panels_too_fine(const Impactor& impactor, const Target& target) {
  const double size = median_panel_size(impactor.surface(), impactor.record().panels().faces());
  if (!(size < target.spacing / 4)) return std::nullopt;
  return fmt::format(
      "Half of the panels of impactor {} are smaller than {:.3g} m, less than a quarter of the spacing of body {} ({:.3g} m): this costs time and memory "
      "without more resolution, because pressure is distributed over the face of a particle. Panels of about one spacing suffice unless the surface is more "
      "strongly curved.",
      impactor.name(), size, target.name, target.spacing);
}

Diagnosis panels_too_coarse(const Impactor& impactor, const Target& target) {
  const Facet facet = coarsest_facet(impactor.surface());
  if (!(facet.sagitta > target.spacing / 2)) return std::nullopt;
  return fmt::format(
      "The panels of impactor {} are coarse: at panel {}, at {} of the surface, they bend by {:.0f} degrees and deviate by about {:.2g} m from a smooth curve, "
      "more than half of the spacing of body {} ({:.3g} m). Use smaller panels there if the surface is meant to be curved.",
      impactor.name(), facet.panel, at(facet.place), facet.angle * 180 / std::numbers::pi, facet.sagitta, target.name, target.spacing);
}

Diagnosis panels_of_another_unit(const Impactor& impactor, const Target& target) {
  constexpr double bodies = 100;
  const double body = std::max({target.size.x, target.size.y, target.size.z}), edge = impactor.surface().report().longest_edge;
  if (!(edge > bodies * body)) return std::nullopt;
  return fmt::format(
      "An edge of a panel of impactor {} is {:.3g} m long, {:.0f} times the whole body {} ({:.3g} m). Check the units: a file in millimetres needs scale: "
      "0.001.",
      impactor.name(), edge, edge / body, target.name, body);
}

Diagnosis falls_between(const Impactor& impactor, const Target& target) {
  const Vec3d size = impactor.surface().report().bounds.size();
  std::array<double, 3> extents{size.x, size.y, size.z};
  std::sort(extents.begin(), extents.end());
  const double enough = 2 * target.spacing + target.contact_radius;
  if (!(extents[1] < enough)) return std::nullopt;
  return fmt::format(
      "Impactor {} is only {:.3g} m by {:.3g} m across, and the spacing of body {} is {:.3g} m: it is in contact with few particles at a time, or passes "
      "between them. Use a spacing of at most {:.2g} m, or check the units of the surface.",
      impactor.name(), extents[0], extents[1], target.name, target.spacing, extents[1] / (2 + target.contact_radius / target.spacing));
}

Diagnosis step_through(const Impactor& impactor, const Target& target, double dt) {
  constexpr std::size_t most_rays = 3000;
  const Surface& surface = impactor.surface();
  double fastest = 0;
  for (const Vec3d& vertex : surface.vertices()) fastest = std::max(fastest, relative_speed(impactor, vertex, target));
  const double motion = fastest * dt;
  if (!(motion > 0)) return std::nullopt;

  Thickness thinnest{};
  double excess = 1;  // ratio of motion per step to thickness
  for (const Thickness& part : thicknesses(surface, Bvh(surface), most_rays))
    if (const double times = relative_speed(impactor, part.place, target) * dt / part.thickness; times > excess) excess = times, thinnest = part;
  if (excess > 1)
    return fmt::format(
        "The relative motion per step of {:.3g} s between impactor {} and body {} is {:.2g} m at panel {}, at {} of the surface, where the thickness is only "
        "{:.2g} m: particles pass through it within a step. Use a time step of at most {:.2g} s.",
        dt, impactor.name(), target.name, excess * thinnest.thickness, thinnest.panel, at(thinnest.place), thinnest.thickness,
        std::min(dt / excess, dt * target.spacing / motion));
  if (motion > target.spacing)
    return fmt::format(
        "The relative motion per step of {:.3g} s between impactor {} and body {} is {:.2g} m, more than a spacing ({:.3g} m): particles are displaced past "
        "their neighbours. Use a time step of at most {:.2g} s.",
        dt, impactor.name(), target.name, motion, target.spacing, dt * target.spacing / motion);
  return std::nullopt;
}

std::size_t particles_behind(const Impactor& impactor, const Particles& particles) {
  const Surface& surface = impactor.surface();
  if (surface.is_closed()) return 0;
  const Bvh bvh(surface);
  constexpr std::size_t block = 4096;
  const auto slots = particles.slot_of();
  std::vector<std::size_t> behind((slots.size() + block - 1) / block, 0);
  parallel_for_uneven(static_cast<std::ptrdiff_t>(behind.size()), [&](std::ptrdiff_t k) {
    const std::size_t begin = static_cast<std::size_t>(k) * block, end = std::min(begin + block, slots.size());
    std::size_t tested = 0;
    int guess = -1;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3d place = impactor.body().pose().to_body(particles.position.at(slots[i]));
      const auto closest = bvh.closest(place, Bvh::no_cap, guess, tested);
      if (!closest) continue;
      guess = closest->triangle;
      const auto triangle = static_cast<std::size_t>(closest->triangle);
      if (surface.is_boundary_edge(triangle, closest->feature)) continue;
      behind[static_cast<std::size_t>(k)] += dot(place - closest->point, surface.pseudonormal(triangle, closest->feature)) < 0;
    }
  });
  const auto own = std::accumulate(behind.begin(), behind.end(), std::int64_t{0});
  return static_cast<std::size_t>(particles.share().ranks().sum(own));
}

Diagnosis starts_behind(const Impactor& impactor, const Target& target, const Particles& particles) {
  const std::size_t behind = particles_behind(impactor, particles);
  if (behind == 0) return std::nullopt;
  return fmt::format(
      "{} of the {} particles of body {} start behind the open surface of impactor {}, on the side opposite to its normals, and have no contact with it. If "
      "they should be outside, set orientation: normals or reversed; if the surface represents a solid, close it.",
      behind, particles.size_of_body(), target.name, impactor.name());
}

std::vector<KindAndSentence> diagnose(const Impactor& impactor, const Target& target, double dt) {
  std::vector<KindAndSentence> all;
  const auto add = [&](std::string_view kind, Diagnosis found) {
    if (found) all.push_back({kind, std::move(*found)});
  };
  add("too fine", panels_too_fine(impactor, target));
  add("too coarse", panels_too_coarse(impactor, target));
  add("another unit", panels_of_another_unit(impactor, target));
  add("falls between", falls_between(impactor, target));
  add("step through", step_through(impactor, target, dt));
  return all;
}

}  // namespace perimpact
