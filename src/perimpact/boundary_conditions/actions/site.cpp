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

fccda::TimeTable BoundarySite::factor(const std::vector<double>& times, const std::vector<double>& factors) const {
  if (times.empty() && factors.empty()) return fccda::TimeTable(1);
  return table(key, times, factors);
}

fccda::TimeTable BoundarySite::table(const std::string& key, const std::vector<double>& times, const std::vector<double>& values) {
  try {
    return fccda::TimeTable(times, values);
  } catch (const fccda::InputError& error) {
    throw SetupError(key, error.what());
  }
}

std::vector<std::uint32_t> outermost(const Lattice& lattice, std::span<const std::uint32_t> slots, const BodyFace& face) {
  std::map<std::array<int, 2>, std::uint32_t> last_of_row;
  for (const std::uint32_t slot : slots) {
    const std::array<int, 3> cell = lattice.cell(slot);
    const std::array<int, 2> row = {cell[(face.axis + 1) % 3], cell[(face.axis + 2) % 3]};
    const auto [found, is_first] = last_of_row.try_emplace(row, slot);
    if (!is_first && face.sign * (cell[face.axis] - lattice.cell(found->second)[face.axis]) > 0) found->second = slot;
  }
  std::vector<std::uint32_t> all;
  for (const auto& entry : last_of_row) all.push_back(entry.second);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace perimpact
