#include "perimpact/moving_window/moved_state.hpp"

#include <algorithm>

#include "base/contract.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace {

/// The slot of the cell `by` cells from that of a slot; none outside the lattice.
std::optional<std::size_t> slot_at(const Lattice& lattice, std::size_t slot, const std::array<int, 3>& by) {
  std::array<int, 3> cell = lattice.cell(slot);
  for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] += by[axis];
  if (!lattice.contains(cell[0], cell[1], cell[2])) return std::nullopt;
  return lattice.slot(cell[0], cell[1], cell[2]);
}

}  // namespace

MovedState::MovedState(const CapturedState& captured, const MovedBody& body) : captured_(captured), body_(body), is_new_(body.particles.slots()) {
  const Lattice& whole = *body_.particles.whole_lattice();
  for (std::size_t slot = 0; slot < is_new_.size(); ++slot) is_new_[slot] = slot_at(whole, body_.particles.share().whole_slot(slot), body_.cells) ? 0 : 1;
}

void MovedState::copy(std::span<const std::byte> from, std::span<std::byte> to) {
  EXPECTS(from.size() == to.size());
  if (!from.empty()) std::memcpy(to.data(), from.data(), from.size());
}

std::optional<std::size_t> MovedState::target(std::size_t whole_slot) const {
  return slot_at(*body_.particles.whole_lattice(), whole_slot, {-body_.cells[0], -body_.cells[1], -body_.cells[2]});
}

std::optional<std::size_t> MovedState::moved_id(std::size_t id) const {
  if (id < body_.first_id || id >= body_.first_id + body_.particles.whole_lattice()->slots()) return id;
  const std::optional<std::size_t> moved = target(id - body_.first_id);
  return moved ? std::optional(*moved + body_.first_id) : std::nullopt;
}

std::vector<std::uint64_t> MovedState::points(std::vector<std::uint64_t> from) const {
  const Share& share = body_.particles.share();
  for (std::uint64_t& point : from) point = share.whole_slot(point);
  std::vector<std::uint64_t> owned;
  for (const std::uint64_t point : share.ranks().join_all(std::span<const std::uint64_t>(from)))
    if (const std::optional<std::size_t> moved = target(point))
      if (const std::optional<std::size_t> slot = share.owned_slot(*moved)) owned.push_back(*slot);
  std::ranges::sort(owned);
  return owned;
}

std::vector<std::uint64_t> MovedState::ends_of_pairs(std::span<const std::uint64_t> from) {
  kept_pairs_.clear();
  std::vector<std::uint64_t> ends;
  for (std::size_t pair = 0; pair < from.size() / EndsOfPairs::per_pair; ++pair) {
    const std::optional<std::size_t> i = moved_id(from[2 * pair]), j = moved_id(from[2 * pair + 1]);
    if (!i || !j) continue;
    kept_pairs_.push_back(pair);
    ends.push_back(*i), ends.push_back(*j);
  }
  return ends;
}

std::vector<double> MovedState::of_kept_pairs(std::span<const double> from, std::size_t per_pair) const {
  std::vector<double> kept;
  if (from.empty()) return kept;  // slips without friction
  for (const std::size_t pair : kept_pairs_) {
    const std::span<const double> numbers = from.subspan(per_pair * pair, per_pair);
    kept.insert(kept.end(), numbers.begin(), numbers.end());
  }
  return kept;
}

std::size_t MovedState::numbers_of_each_particle(std::string_view name, std::size_t numbers, std::size_t slots) const {
  if (!name.starts_with(body_.name + ".")) return 0;
  std::array<std::int64_t, 2> counts{static_cast<std::int64_t>(numbers), static_cast<std::int64_t>(slots)};
  body_.particles.share().ranks().sum(counts);
  return counts[1] == 0 ? 0 : static_cast<std::size_t>(counts[0] / counts[1]);
}

// Bonds to or from new material are intact, and those to discarded material do not exist. `to`: all bonds of the newly built body.
void MovedState::bonds(std::span<const std::uint8_t> from, std::span<std::uint8_t> to, std::size_t per_eight) const {
  std::vector<std::uint8_t> before(to.size());
  body_.particles.share().shift(*body_.particles.lattice(), from, std::span(before), per_eight, body_.cells);
  const std::span<const std::ptrdiff_t> offsets = body_.family.offsets();
  for (std::size_t slot = 0; slot < is_new_.size(); ++slot) {
    if (is_new_[slot] != 0) continue;
    const std::size_t row = body_.family.begin(slot / byte_lanes);
    const auto bit = static_cast<std::uint8_t>(1u << slot % byte_lanes);
    for (std::size_t r = 0; r < offsets.size(); ++r) {
      if ((to[row + r] & bit) == 0) continue;
      const auto neighbour = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(slot) + offsets[r]);
      if (is_new_[neighbour] == 0 && (before[row + r] & bit) == 0) to[row + r] = static_cast<std::uint8_t>(to[row + r] & ~bit);
    }
  }
}

}  // namespace perimpact
