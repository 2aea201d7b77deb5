#include "perimpact/boundary_conditions/floating/water_columns.hpp"

namespace perimpact {

WaterColumns::WaterColumns(const Particles& particles, std::span<const std::uint32_t> slots) : column_of_(slots.size()), members_(slots.size()) {
  const Lattice& lattice = *particles.lattice();
  const std::size_t along_x = static_cast<std::size_t>(lattice.cells[0]);
  std::vector<std::uint32_t> number(along_x * static_cast<std::size_t>(lattice.cells[1]), none);
  std::vector<std::size_t> sizes;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const auto [i, j, layer] = lattice.cell(slots[k]);
    std::uint32_t& column = number[static_cast<std::size_t>(j) * along_x + static_cast<std::size_t>(i)];
    if (column == none) column = static_cast<std::uint32_t>(sizes.size()), sizes.push_back(0);
    column_of_[k] = column, ++sizes[column];
  }
  begin_.assign(sizes.size() + 1, 0);
  for (std::size_t c = 0; c < sizes.size(); ++c) begin_[c + 1] = begin_[c] + sizes[c];
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t k = 0; k < slots.size(); ++k) members_[next[column_of_[k]]++] = static_cast<std::uint32_t>(k);  // layers ascend with the slots
  tops_.assign(sizes.size(), none);
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    const std::uint32_t highest = members_[begin_[c + 1] - 1];
    const auto [i, j, layer] = lattice.cell(slots[highest]);
    int above = layer + 1;
    while (lattice.contains(i, j, above) && !particles.is_occupied(lattice.slot(i, j, above))) ++above;
    if (!lattice.contains(i, j, above)) tops_[c] = highest;
  }
}

}  // namespace perimpact
