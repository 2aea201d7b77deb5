#include "perimpact/simulation/shared_state.hpp"

#include <charconv>

namespace perimpact {

const Body* body_of_points(std::string_view name, std::span<const Body> bodies) {
  if (!name.ends_with(".points_inside") && !name.ends_with(".points_in_contact")) return nullptr;
  constexpr std::string_view deforming = ".deforming";  // the detector of a deforming surface
  std::string_view before = name.substr(0, name.rfind('.'));
  if (before.ends_with(deforming)) before.remove_suffix(deforming.size());
  const std::string_view number = before.substr(before.rfind('.') + 1);
  std::size_t body = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), body);
  return error == std::errc() && end == number.data() + number.size() && body < bodies.size() ? &bodies[body] : nullptr;
}

bool is_ends_of_pairs(std::string_view name) { return name == "fragments.pair_ends"; }
bool is_slips_of_pairs(std::string_view name) { return name == "fragments.pair_slips"; }

bool is_counter_of_work(std::string_view name) {
  return name.ends_with(".points_in_bounds") || name.ends_with(".points_tested") || name.ends_with(".panels_tested") || name.ends_with(".entered_inside") ||
         name.find(".rejected_by_") != std::string_view::npos;
}

}  // namespace perimpact
