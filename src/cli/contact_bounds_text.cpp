#include "cli/contact_bounds_text.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string_view>
#include <type_traits>

#include "cli/row.hpp"
#include "io/results/contact_bounds_report.hpp"

namespace perimpact {

namespace {

std::string place(const Vec3d& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

/// One row for each fact.
template <class Bounds>
std::string details(const Bounds& bounds) {
  std::string rows;
  if constexpr (requires { bounds.visit_facts([](std::string_view, const auto&) {}); })
    bounds.visit_facts([&]<class Value>(std::string_view name, const Value& value) {
      const std::string label = fmt::format("bounds {}", name);
      if constexpr (std::is_same_v<Value, Vec3d>)
        rows += row(label.c_str(), place(value));
      else
        rows += row(label.c_str(), fmt::format("{:.4g}", static_cast<double>(value)));
    });
  return rows;
}

std::string details(const fccda::BoxUnion& region) { return region.boxes().size() > 1 ? row("boxes of bounds", fmt::format("{}", region.boxes().size())) : ""; }

std::string details(const fccda::CylinderSectors& region) {
  const fccda::CylinderSectors::Shape& shape = region.shape();
  std::string text = row("bounds cylinder", fmt::format("axis {} through {} m, radius {:.4g} m, length {:.4g} m", place(shape.axis), place(shape.point),
                                                        shape.radius, shape.length));
  constexpr double degree = std::numbers::pi / 180;
  return text + row("bounds sectors", shape.has_gaps() ? fmt::format("hub radius {:.4g} m, {} sectors of {:.4g} deg, the first from {:.4g} deg",
                                                                     shape.hub_radius, shape.blades, shape.sector_angle / degree, shape.start_angle / degree)
                                                       : "no gaps: the whole cylinder");
}

std::string volume(const Impactor& impactor) {
  const double volume = std::visit([](const auto& its) { return its.volume(); }, impactor.region().region);
  const auto share = share_of_bounding_box(impactor);
  if (!share) return fmt::format("{:.4g} m3", volume);
  if (*share > 1) return fmt::format("{:.4g} m3, {:.3g} times the bounding box of the surface", volume, *share);
  return fmt::format("{:.4g} m3, {:.0f} % less than the bounding box of the surface", volume, 100 * (1 - *share));
}

}  // namespace

std::string contact_bounds_text(const Impactor& impactor) {
  const fccda::ContactBounds& region = impactor.region().region;
  if (std::holds_alternative<fccda::Unbounded>(region)) return row("contact bounds", "none: contact on the whole surface");
  std::string text = row("contact bounds", bounds_kind(region));
  if (!impactor.region().fitted.empty()) text += row("bounds fitted", impactor.region().fitted);
  text += std::visit([](const auto& its) { return details(its); }, region);
  text += row("bounds volume", volume(impactor));
  if (std::visit([](const auto& its) { return its.clips(); }, region)) text += row("bounds clip", "part of the surface lies outside and has no contact");
  return text;
}

}  // namespace perimpact
