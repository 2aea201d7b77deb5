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

/// Speed of the particles relative to a place of the surface (in its own frame) [m/s].
double relative_speed(const Impactor& impactor, const Vec3d& place, const Target& target) {
  const Vec3d arm = impactor.body().pose().to_world(place) - impactor.body().position_of_com();
  return norm(impactor.fastest_velocity() + cross(impactor.fastest_angular_velocity(), arm) - target.velocity);
}

}  // namespace

Diagnosis inside_out(const Impactor& impactor) {
  const SurfaceReport& report = impactor.report_as_given();  // changed panels are turned outward already
  const std::size_t flipped = report.flipped;
  if (flipped == 0) return std::nullopt;
  return fmt::format(
      "The panels of impactor {} point inward in {} of its {} components; these were turned over, so that the outside is struck. If the program that "
      "made the surface should know, turn its normals there.",
      impactor.name(), flipped, report.components);
}

Diagnosis goes_through_itself(const Impactor& impactor) {
  if (impactor.crossing_panels() == 0) return std::nullopt;
  return fmt::format("{} panels of impactor {} go through one another within one body. {}; `perimpact mesh` writes a picture of them.",
                     impactor.crossing_panels(), impactor.name(),
                     impactor.surface().is_closed()
                         ? "Contact from outside is found all the same, but what is enclosed twice counts double in the volume"
                         : "Where the surface is open it is not known whether its front is outside between them; mend the fold if anything strikes there");
}

Diagnosis is_cut(const Impactor& impactor) {
  const SurfaceReport& report = impactor.report_as_given();
  if (report.cut_edges == 0) return std::nullopt;
  return fmt::format(
      "The surface of impactor {} is cut along {} edges of more than two panels, because it could not be told which panels hang together there. Near these "
      "edges a particle is struck when its centre crosses a panel, not at the contact radius; delete inner walls if that matters.",
      impactor.name(), report.cut_edges);
}

Diagnosis panels_too_fine(const Impactor& impactor, const Target& target) {
  const double size = median_panel_size(impactor.surface(), impactor.record().panels().faces());
  if (!(size < target.spacing / 4)) return std::nullopt;
  return fmt::format(
      "Half of the panels of impactor {} are smaller than {:.3g} m, less than a quarter of the spacing of body {} ({:.3g} m): that costs time and memory and "
      "resolves nothing, because pressure is spread over the face of a particle. Panels of about one spacing are enough where the surface is not curved more "
      "tightly.",
      impactor.name(), size, target.name, target.spacing);
}

Diagnosis panels_too_coarse(const Impactor& impactor, const Target& target) {
  const Facet facet = coarsest_facet(impactor.surface());
  if (!(facet.sagitta > target.spacing / 2)) return std::nullopt;
  return fmt::format(
      "The panels of impactor {} are coarse: at panel {}, at {} of the surface, they bend by {:.0f} degrees and lie about {:.2g} m off the curve they "
      "stand for, more than half of the spacing of body {} ({:.3g} m). Take smaller panels there, if it is meant to be round.",
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
      "Impactor {} is only {:.3g} m by {:.3g} m across, and the spacing of body {} is {:.3g} m: it meets few particles at a time, or falls between them. "
      "Take a spacing of at most {:.2g} m, or check the units of the surface.",
      impactor.name(), extents[0], extents[1], target.name, target.spacing, extents[1] / (2 + target.contact_radius / target.spacing));
}

Diagnosis step_through(const Impactor& impactor, const Target& target, double dt) {
  constexpr std::size_t most_rays = 3000;
  const Surface& surface = impactor.surface();
  double fastest = 0;
  for (const Vec3d& vertex : surface.vertices()) fastest = std::max(fastest, relative_speed(impactor, vertex, target));
  const double way = fastest * dt;
  if (!(way > 0)) return std::nullopt;

  Thickness thinnest{};
  double excess = 1;  // how many times the way is as long as the part is thick
  for (const Thickness& part : thicknesses(surface, Bvh(surface), most_rays))
    if (const double times = relative_speed(impactor, part.place, target) * dt / part.thickness; times > excess) excess = times, thinnest = part;
  if (excess > 1)
    return fmt::format(
        "In one step of {:.3g} s impactor {} and body {} move {:.2g} m against each other at panel {}, at {} of the surface, where it is only {:.2g} m thick: "
        "particles pass right through it within a step. Take a time step of at most {:.2g} s.",
        dt, impactor.name(), target.name, excess * thinnest.thickness, thinnest.panel, at(thinnest.place), thinnest.thickness,
        std::min(dt / excess, dt * target.spacing / way));
  if (way > target.spacing)
    return fmt::format(
        "In one step of {:.3g} s impactor {} and body {} move {:.2g} m against each other, more than a spacing ({:.3g} m): particles are thrown over their "
        "neighbours. Take a time step of at most {:.2g} s.",
        dt, impactor.name(), target.name, way, target.spacing, dt * target.spacing / way);
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
    std::size_t asked = 0;
    int guess = -1;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3d place = impactor.body().pose().to_body(particles.position.at(slots[i]));
      const auto closest = bvh.closest(place, Bvh::no_cap, guess, asked);
      if (!closest) continue;
      guess = closest->triangle;
      const auto triangle = static_cast<std::size_t>(closest->triangle);
      if (surface.is_boundary_edge(triangle, closest->feature)) continue;
      behind[static_cast<std::size_t>(k)] += dot(place - closest->point, surface.pseudonormal(triangle, closest->feature)) < 0;
    }
  });
  return std::accumulate(behind.begin(), behind.end(), std::size_t{0});
}

Diagnosis starts_behind(const Impactor& impactor, const Target& target, const Particles& particles) {
  const std::size_t behind = particles_behind(impactor, particles);
  if (behind == 0) return std::nullopt;
  return fmt::format(
      "{} of the {} particles of body {} start behind the open surface of impactor {}, on the side that its normals point away from, and do not feel it. "
      "Where they should be outside, turn the surface with outside: normals or reversed; where it stands for a solid, close it, so that its inside is known.",
      behind, particles.size(), target.name, impactor.name());
}

std::vector<std::string> diagnose(const Impactor& impactor, const Target& target, double dt) {
  std::vector<std::string> sentences;
  for (const Diagnosis& diagnosis : {panels_too_fine(impactor, target), panels_too_coarse(impactor, target), panels_of_another_unit(impactor, target),
                                     falls_between(impactor, target), step_through(impactor, target, dt)})
    if (diagnosis) sentences.push_back(*diagnosis);
  return sentences;
}

}  // namespace perimpact
