#include "perimpact/boundary_conditions/floating/water_columns.hpp"

namespace perimpact {

using fccda::byte_lanes;

WaterColumns::WaterColumns(const Particles& particles, const ListedEights& eights) {
  const Lattice& lattice = *particles.lattice();
  const std::size_t count = lattice.row_slots() * static_cast<std::size_t>(lattice.cells[1]), stacks = count / byte_lanes;
  tops_.assign(count, none);
  layers_.assign(count, 0.0);
  begin_.assign(stacks + 1, 0);
  for (const std::uint32_t eight : eights.numbers()) ++begin_[eight % stacks + 1];
  for (std::size_t s = 0; s < stacks; ++s) begin_[s + 1] += begin_[s];
  members_.resize(eights.count());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t e = 0; e < eights.count(); ++e) members_[next[eights.numbers()[e] % stacks]++] = e;  // layers ascend with the eights
  for (const std::uint32_t place : eights.place_of()) {
    const std::size_t column = column_of(eights.view().slot(place));
    tops_[column] = place, layers_[column] += 1;
  }
  for (std::uint32_t& top : tops_) {
    if (top == none) continue;
    const auto [i, j, layer] = lattice.cell(eights.view().slot(top));
    int above = layer + 1;
    while (lattice.contains(i, j, above) && !particles.is_occupied(lattice.slot(i, j, above))) ++above;
    if (lattice.contains(i, j, above)) top = none;
  }
}

}  // namespace perimpact
