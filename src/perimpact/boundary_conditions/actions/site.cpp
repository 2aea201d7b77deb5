#include "perimpact/boundary_conditions/actions/site.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

std::vector<std::uint32_t> BoundarySite::slots(const std::string& particle_set) const {
  if (particle_set.empty()) return {of.particles.slot_of().begin(), of.particles.slot_of().end()};
  const std::vector<std::size_t> slots = of.slots_of(particle_set, key + ".particle_set");
  return {slots.begin(), slots.end()};
}

fccda::PiecewiseLinear BoundarySite::factor(const std::vector<double>& times, const std::vector<double>& factors) const {
  if (times.empty() && factors.empty()) return fccda::PiecewiseLinear(1);
  return table(key, times, factors);
}

fccda::PiecewiseLinear BoundarySite::table(const std::string& key, const std::vector<double>& times, const std::vector<double>& values) {
  try {
    return fccda::PiecewiseLinear(times, values);
  } catch (const fccda::InputError& error) {
    throw SetupError(key, error.what());
  }
}

namespace {

/// Particle of a lattice row along an axis.
struct OfRow {
  std::array<int, 2> row;  // the other two cells, on the lattice of the whole body
  int cell;                // along the axis
};

}  // namespace

std::vector<std::uint32_t> outermost(const Particles& particles, std::span<const std::uint32_t> slots, const BodyFace& face) {
  const Lattice& lattice = *particles.lattice();
  const auto of_row = [&](std::uint32_t slot) {
    std::array<int, 3> cell = lattice.cell(slot);
    for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] += lattice.first[axis];
    return OfRow{{cell[(face.axis + 1) % 3], cell[(face.axis + 2) % 3]}, cell[face.axis]};
  };
  std::map<std::array<int, 2>, int> last;  // of each row
  const auto include = [&](const OfRow& one) {
    const auto [found, is_first] = last.try_emplace(one.row, one.cell);
    if (!is_first && face.sign * (one.cell - found->second) > 0) found->second = one.cell;
  };
  for (const std::uint32_t slot : slots) include(of_row(slot));
  std::vector<OfRow> own;
  for (const auto& [row, cell] : last) own.push_back({row, cell});
  for (const OfRow& one : particles.share().ranks().join_all(std::span<const OfRow>(own))) include(one);
  std::vector<std::uint32_t> all;
  for (const std::uint32_t slot : slots)
    if (const OfRow one = of_row(slot); last.at(one.row) == one.cell) all.push_back(slot);
  return all;
}

}  // namespace perimpact
