#include "perimpact/particles/particles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace {

constexpr std::size_t cloud_row = 64;  // slots per work item of a thread

std::vector<std::uint8_t> marked(const Lattice& lattice, const std::function<bool(const Vec3d&)>& inside) {
  std::vector<std::uint8_t> marks(lattice.slots(), 0);
  for (std::size_t slot = 0; slot < marks.size(); ++slot) {
    const auto [i, j, k] = lattice.cell(slot);
    marks[slot] = lattice.contains(i, j, k) && inside(lattice.centre(slot)) ? 1 : 0;
  }
  return marks;
}

}  // namespace

Particles::Particles(const Lattice& lattice, int reach, Density density, std::span<const std::uint8_t> inside, Share share)
    : share_(std::move(share)),
      lattice_(lattice),
      slots_(lattice.slots()),
      row_slots_(lattice.row_slots()),
      slack_(static_cast<std::size_t>(lattice.offset(reach, reach, lattice.thickness ? 0 : reach)) + fccda::byte_lanes),
      density_(density),
      inertia_(density.of_inertia()),
      spacing_(lattice.spacing),
      thickness_(lattice.thickness),
      cell_volume_(lattice.cell_volume()),
      occupied_(slots_ / fccda::byte_lanes, 0) {
  EXPECTS(inside.size() == slots_);
  mark_owned_eights();
  position = velocity = force_density = VectorArray(slots_, slack_);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(lattice.rows()), [&](std::ptrdiff_t row) {
    const std::size_t begin = static_cast<std::size_t>(row) * row_slots_;
    for (std::size_t slot = begin; slot < begin + row_slots_; ++slot) {
      position.set(slot, reference(slot));
      if (inside[slot] != 0) occupied_[slot / 8] = static_cast<std::uint8_t>(occupied_[slot / 8] | (1u << (slot % 8)));
    }
  });
  number_particles();
}

Particles::Particles(const Lattice& lattice, int reach, Density density, const std::function<bool(const Vec3d&)>& inside)
    : Particles(lattice, reach, density, marked(lattice, inside)) {}

Particles::Particles(const Cloud& cloud, Density density, const Share& share)
    : share_(share),
      slots_(share.is_whole() ? fccda::in_eights(cloud.points.size()) : share.eights().size() * fccda::byte_lanes),
      row_slots_(cloud_row),
      slack_(0),
      density_(density),
      inertia_(density.of_inertia()),
      spacing_(spacing_of(cloud)),
      thickness_(cloud.thickness),
      occupied_(slots_ / fccda::byte_lanes, 0) {
  EXPECTS(!cloud.points.empty() && cloud.points.size() == cloud.volumes.size());
  mark_owned_eights();
  position = velocity = force_density = VectorArray(slots_, slack_);
  reference_.resize(slots_, cloud.points.back());
  volumes_.resize(slots_, 0.0);
  if (!cloud.numbers.empty()) numbers_.resize(slots_, 0);
  for (std::size_t slot = 0; slot < slots_; ++slot) {
    if (const std::size_t point = share_.whole_slot(slot); point < cloud.points.size()) {
      reference_[slot] = cloud.points[point];
      volumes_[slot] = cloud.volumes[point];
      if (!cloud.numbers.empty()) numbers_[slot] = cloud.numbers[point];
      occupied_[slot / 8] = static_cast<std::uint8_t>(occupied_[slot / 8] | (1u << (slot % 8)));
    }
    position.set(slot, reference_[slot]);
  }
  number_particles();
}

void Particles::mark_owned_eights() {
  if (share_.is_whole()) return;
  owned_eights_.assign(slots_ / fccda::byte_lanes, 0);
  for (const SlotRun& run : share_.owned())
    std::fill_n(owned_eights_.begin() + static_cast<std::ptrdiff_t>(run.first / fccda::byte_lanes), run.count / fccda::byte_lanes, std::uint8_t{1});
}

void Particles::number_particles() {
  std::size_t count = 0;
  for (std::size_t eight = 0; eight < occupied_.size(); ++eight)
    if (is_owned_eight(eight)) count += static_cast<std::size_t>(std::popcount(occupied_[eight]));
  slot_of_.clear();
  slot_of_.reserve(count);
  for (std::size_t eight = 0; eight < occupied_.size(); ++eight)
    if (is_owned_eight(eight))
      fccda::for_each_bit(occupied_[eight], [&](std::size_t lane) { slot_of_.push_back(static_cast<std::uint32_t>(eight * fccda::byte_lanes + lane)); });
}

void Particles::move_lattice(const std::array<int, 3>& first) {
  EXPECTS(lattice_);
  share_ = share_.at(first);
  lattice_->first = first;
  if (!share_.is_whole()) lattice_->first = share_.lattice().first;
  for (std::size_t slot = 0; slot < slots_; ++slot) position.set(slot, reference(slot));
}

void Particles::refresh_ghosts() {
  begin_refresh_ghosts();
  share_.complete_refresh();
}

void Particles::begin_refresh_ghosts() {
  share_.begin_refresh(
      {position.component(0), position.component(1), position.component(2), velocity.component(0), velocity.component(1), velocity.component(2)});
}

double Particles::total_mass() const {
  if (lattice_) return static_cast<double>(size_of_body()) * material_mass(0);
  return density_.material * exact_sum_over_eights(*this, [&](std::size_t slot) { return volume(slot); });
}

double Particles::size_of(std::size_t slot) const { return lattice_ ? spacing_ : size_of_volume(volumes_[slot], thickness_); }

Vec3d extent(const Particles& particles) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::array<double, 6> most{none, none, none, none, none, none};  // of the coordinates, and of the negative ones
  for (const std::uint32_t slot : particles.slot_of()) {
    const Vec3d X = particles.reference(slot);
    for (std::size_t c = 0; c < 3; ++c) most[c] = std::max(most[c], X[c]), most[3 + c] = std::max(most[3 + c], -X[c]);
  }
  particles.share().ranks().max(most);
  Vec3d size;
  for (std::size_t c = 0; c < 3; ++c) size[c] = most[c] + most[3 + c] + particles.spacing();
  return size;
}

void Particles::remove(std::span<const std::size_t> slots) {
  for (const std::size_t slot : slots) {
    occupied_[slot / 8] = static_cast<std::uint8_t>(occupied_[slot / 8] & ~(1u << (slot % 8)));
    velocity.set(slot, {});  // value of slots without a particle
  }
  if (share_.is_whole()) {
    std::erase_if(slot_of_, [&](std::uint32_t slot) { return std::binary_search(slots.begin(), slots.end(), std::size_t{slot}); });
    return;
  }
  std::vector<std::uint8_t> marks(slots_);
  for (std::size_t slot = 0; slot < slots_; ++slot) marks[slot] = is_occupied(slot) ? 1 : 0;
  share_.refresh({marks.data()});
  for (std::size_t slot = 0; slot < slots_; ++slot)
    if (marks[slot] == 0) occupied_[slot / 8] = static_cast<std::uint8_t>(occupied_[slot / 8] & ~(1u << (slot % 8)));
  number_particles();
}

}  // namespace perimpact
