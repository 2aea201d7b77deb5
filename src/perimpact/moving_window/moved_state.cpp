#include "perimpact/moving_window/moved_state.hpp"

#include <cstring>

#include "base/contract.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace {

template <class T>
std::vector<T> numbers_of(std::span<const std::byte> bytes) {
  std::vector<T> numbers(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& numbers) {
  const auto bytes = std::as_bytes(std::span(numbers));
  return {bytes.begin(), bytes.end()};
}

bool get_bit(std::span<const std::byte> bytes, std::size_t row, std::size_t lane) { return (std::to_integer<unsigned>(bytes[row]) >> lane) & 1u; }

}  // namespace

MovedState::MovedState(const CapturedState& captured, const MovedBody& body) : captured_(captured), body_(body), target_of_(body.sources.size(), -1) {
  for (std::size_t slot = 0; slot < body_.sources.size(); slot += byte_lanes) {
    EXPECTS(body_.sources[slot] < 0 || body_.sources[slot] % static_cast<std::int64_t>(byte_lanes) == 0);
    source_eights_.push_back(body_.sources[slot] < 0 ? -1 : body_.sources[slot] / static_cast<std::int64_t>(byte_lanes));
  }
  for (std::size_t slot = 0; slot < body_.sources.size(); ++slot)
    if (body_.sources[slot] >= 0) target_of_[static_cast<std::size_t>(body_.sources[slot])] = static_cast<std::int64_t>(slot);
}

void MovedState::copy(std::span<const std::byte> from, std::span<std::byte> to) {
  EXPECTS(from.size() == to.size());
  if (!from.empty()) std::memcpy(to.data(), from.data(), from.size());
}

std::int64_t MovedState::moved_id(std::uint64_t id) const {
  if (id < body_.first_id || id >= body_.first_id + target_of_.size()) return static_cast<std::int64_t>(id);
  const std::int64_t target = target_of_[id - body_.first_id];
  return target < 0 ? -1 : target + static_cast<std::int64_t>(body_.first_id);
}

std::vector<std::byte> MovedState::list(std::string_view name, const std::vector<std::byte>& from) {
  const std::string detector = "." + std::to_string(body_.index) + ".";
  if (name.find(detector) != std::string_view::npos && (name.ends_with(".points_inside") || name.ends_with(".points_in_contact"))) {
    std::vector<std::uint64_t> points;
    for (const std::uint64_t point : numbers_of<std::uint64_t>(from))
      if (const std::int64_t target = target_of_.at(point); target >= 0) points.push_back(static_cast<std::uint64_t>(target));
    return bytes_of(points);
  }
  if (name == "fragments.pair_ends") {
    kept_pairs_.clear();
    std::vector<std::uint64_t> ends;
    const std::vector<std::uint64_t> before = numbers_of<std::uint64_t>(from);
    for (std::size_t pair = 0; pair < before.size() / 2; ++pair) {
      const std::int64_t i = moved_id(before[2 * pair]), j = moved_id(before[2 * pair + 1]);
      if (i < 0 || j < 0) continue;
      kept_pairs_.push_back(pair);
      ends.push_back(static_cast<std::uint64_t>(i)), ends.push_back(static_cast<std::uint64_t>(j));
    }
    return bytes_of(ends);
  }
  if (name == "fragments.pair_slips" && !from.empty()) {
    std::vector<double> slips;
    const std::vector<double> before = numbers_of<double>(from);
    for (const std::size_t pair : kept_pairs_)
      slips.insert(slips.end(), before.begin() + static_cast<std::ptrdiff_t>(3 * pair), before.begin() + static_cast<std::ptrdiff_t>(3 * pair + 3));
    return bytes_of(slips);
  }
  return from;
}

void MovedState::take_over(std::span<const std::int64_t> sources, std::span<const std::byte> from, std::span<std::byte> to, std::size_t size_of_number) {
  for (std::size_t k = 0; k < sources.size(); ++k)
    if (sources[k] >= 0) std::memcpy(to.data() + k * size_of_number, from.data() + static_cast<std::size_t>(sources[k]) * size_of_number, size_of_number);
}

void MovedState::array(std::string_view name, std::span<const std::byte> from, std::span<std::byte> to, std::size_t size_of_number) const {
  EXPECTS(from.size() == to.size());
  const std::size_t slots = body_.sources.size();
  const bool is_own = name.starts_with(body_.name + ".");
  if (is_own && name.ends_with(".bonds")) return bonds(from, to);
  const std::size_t count = to.size() / size_of_number;
  const bool is_of_body = is_own && name.find('.', body_.name.size() + 1) == std::string_view::npos;  // not of one of its boundary conditions
  if (is_of_body && count == source_eights_.size() && !name.ends_with("_of_eight")) return take_over(source_eights_, from, to, size_of_number);
  const bool is_of_contact = name.starts_with("fragments." + std::to_string(body_.index) + ".");
  if ((is_own || is_of_contact) && count == slots) return take_over(body_.sources, from, to, size_of_number);
  copy(from, to);
}

// Bonds to or from new material are intact, and those to discarded material do not exist. `to`: all bonds of the newly built body.
void MovedState::bonds(std::span<const std::byte> from, std::span<std::byte> to) const {
  const std::span<const std::ptrdiff_t> offsets = body_.family.offsets();
  for (std::size_t slot = 0; slot < body_.sources.size(); ++slot) {
    if (body_.sources[slot] < 0) continue;
    const auto source = static_cast<std::size_t>(body_.sources[slot]);
    const std::size_t row = body_.family.begin(slot / byte_lanes), row_of_source = body_.family.begin(source / byte_lanes), lane = slot % byte_lanes;
    for (std::size_t r = 0; r < offsets.size(); ++r) {
      if (!get_bit(to, row + r, lane)) continue;
      const auto neighbour = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(slot) + offsets[r]);
      if (body_.sources[neighbour] >= 0 && !get_bit(from, row_of_source + r, source % byte_lanes)) to[row + r] &= ~(std::byte{1} << lane);
    }
  }
}

}  // namespace perimpact
