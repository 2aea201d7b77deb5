/// The slots of a boundary condition as eights, on which kernels act pack by pack. Its numbers of particles are arrays by *place*: place 8 e + l is slot
/// 8 n + l of the body, where n is the eight with the number e in the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/host_device.hpp"
#include "base/pack.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

/// Eights in a list, as kernels see them.
struct EightsView {
  const std::uint32_t* numbers;  ///< n of each eight
  const std::uint8_t* lanes;     ///< of each: bit l for slot 8 n + l

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(numbers), visit(lanes);
  }
  FCCDA_HD std::size_t slot(std::size_t place) const { return std::size_t{numbers[place / fccda::byte_lanes]} * fccda::byte_lanes + place % fccda::byte_lanes; }
};

/// Those of the bits of an eight that belong to the pack at this place.
template <class Pack>
FCCDA_HD unsigned bits_at(const std::uint8_t* of_eights, std::size_t place) {
  return fccda::pack_bits<Pack>(of_eights[place / fccda::byte_lanes], place % fccda::byte_lanes);
}

/// [m³] of the particles of a pack.
template <class Pack>
FCCDA_HD Pack volume_of_pack(const ParticlesView& particles, std::size_t slot) {
  return particles.volumes ? fccda::load<Pack>(particles.volumes + slot) : Pack(particles.cell_volume);
}

class ListedEights {
 public:
  ListedEights() = default;
  /// `slots` ascending.
  explicit ListedEights(std::span<const std::uint32_t> slots) : places_(slots.size()) {
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const auto eight = static_cast<std::uint32_t>(slots[k] / fccda::byte_lanes);
      if (numbers_.empty() || numbers_.back() != eight) numbers_.push_back(eight), lanes_.push_back(0);
      const std::size_t lane = slots[k] % fccda::byte_lanes;
      lanes_.back() = static_cast<std::uint8_t>(lanes_.back() | 1u << lane);
      places_[k] = static_cast<std::uint32_t>((numbers_.size() - 1) * fccda::byte_lanes + lane);
    }
  }

  std::size_t count() const { return numbers_.size(); }
  std::size_t places() const { return numbers_.size() * fccda::byte_lanes; }
  std::size_t place(std::size_t k) const { return places_[k]; }  ///< of the slot with the number k in the list
  std::span<const std::uint32_t> place_of() const { return places_; }
  std::span<const std::uint32_t> numbers() const { return numbers_; }
  std::span<const std::uint8_t> lanes() const { return lanes_; }
  /// Calls visit(span) for each array of the view.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    visit(numbers()), visit(lanes());
  }
  EightsView view() const { return {numbers_.data(), lanes_.data()}; }

 private:
  std::vector<std::uint32_t> places_, numbers_;
  std::vector<std::uint8_t> lanes_;
};

/// Numbers of listed particles by place, visited in the order of their slots; what the visitor writes is copied back.
template <class T, class Visit>
void visit_by_slot(std::span<const std::uint32_t> places, std::size_t components, const T& at, const Visit& visit) {
  std::vector<std::remove_reference_t<decltype(at(std::size_t{}, std::size_t{}))>> numbers;
  for (const std::uint32_t place : places)
    for (std::size_t c = 0; c < components; ++c) numbers.push_back(at(place, c));
  visit(std::span(numbers));
  auto number = numbers.begin();
  for (const std::uint32_t place : places)
    for (std::size_t c = 0; c < components; ++c) at(place, c) = *number++;
}

/// Sum of the numbers of the lanes of an eight, in order: the plain sum within an eight, those of other lanes being 0.
FCCDA_HD inline double sum_of_lanes(const double* numbers) {
  double sum = numbers[0];
  for (std::size_t lane = 1; lane < fccda::byte_lanes; ++lane) sum += numbers[lane];
  return sum;
}

}  // namespace perimpact
