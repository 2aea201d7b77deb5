#include "io/results/contact_bounds_report.hpp"

#include <vector>

#include "fccda/contact_bounds/boxes.hpp"
#include "io/results/json_vector.hpp"

namespace perimpact {

using output::Json;

namespace {

/// The facts of all bounds but boxes, which may be many.
Json json_of(double value) { return value; }
Json json_of(int value) { return value; }
Json json_of(bool value) { return value; }
Json json_of(const Vec3d& value) { return json_vector(value); }

template <class Bounds>
void describe(const Bounds& bounds, Json& json) {
  if constexpr (requires { bounds.visit_facts([](std::string_view, const auto&) {}); })
    bounds.visit_facts([&](std::string_view name, const auto& value) { json[std::string(name)] = json_of(value); });
}

void describe(const fccda::BoxUnion& region, Json& json) {
  std::size_t number = 0;
  for (const fccda::Box& box : region.boxes()) {
    Json& its = json["boxes"][std::to_string(++number)];
    its["low [m]"] = json_vector(box.low);
    its["high [m]"] = json_vector(box.high);
  }
}

}  // namespace

std::string bounds_kind(const fccda::ContactBounds& region) {
  if (std::holds_alternative<fccda::Unbounded>(region)) return "none";
  if (const auto* boxes = std::get_if<fccda::BoxUnion>(&region); boxes && boxes->boxes().size() == 1) return "box";
  return std::visit([](const auto& its) { return std::string(its.name); }, region);
}

std::optional<double> share_of_bounding_box(const Impactor& impactor) {
  const fccda::ContactBounds& region = impactor.region().region;
  const double whole = fccda::volume_of(impactor.surface().report().bounds);
  if (std::holds_alternative<fccda::Unbounded>(region) || whole == 0) return std::nullopt;
  return std::visit([](const auto& its) { return its.volume(); }, region) / whole;
}

Json contact_bounds_report(const Impactor& impactor) {
  const fccda::ContactBounds& region = impactor.region().region;
  Json json = Json::object();
  json["kind"] = bounds_kind(region);
  if (std::holds_alternative<fccda::Unbounded>(region)) return json;
  if (!impactor.region().fitted.empty()) json["fitted"] = impactor.region().fitted;
  json["clips"] = std::visit([](const auto& its) { return its.clips(); }, region);
  json["volume [m3]"] = std::visit([](const auto& its) { return its.volume(); }, region);
  if (const auto share = share_of_bounding_box(impactor)) json["share_of_bounding_box"] = *share;
  std::visit([&](const auto& its) { describe(its, json); }, region);
  return json;
}

}  // namespace perimpact
