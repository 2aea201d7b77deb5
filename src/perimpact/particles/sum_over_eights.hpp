/// Sums over particles that do not depend on how slots are distributed among threads or processes: plain sums within each *eight*, the slots 8 n … 8 n + 7,
/// and exact sums of these (base/exact_sum.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "base/exact_sum.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// f(0) + f(1) + …, `count` of them, each a double or a struct of doubles with +=. Consecutive k of equal eight_of(k) are summed in order, their sums exactly.
/// Parallel; f is called once for each k and may write data of its index.
template <class EightOf, class F>
auto exact_sum_over_eights(std::size_t count, const EightOf& eight_of, const F& f) {
  using Value = std::decay_t<decltype(f(std::size_t{}))>;
  constexpr std::size_t share_size = 256;
  return fccda::exact_sum_of_shares<Value>(static_cast<std::ptrdiff_t>((count + share_size - 1) / share_size),
                                           [&](std::ptrdiff_t share, fccda::ExactSums<Value>& sums) {
                                             std::size_t k = static_cast<std::size_t>(share) * share_size;
                                             const std::size_t end = std::min(k + share_size, count);
                                             if (k > 0)  // an eight belongs to the share in which it begins
                                               while (k < end && eight_of(k) == eight_of(k - 1)) ++k;
                                             while (k < end) {
                                               const auto eight = eight_of(k);
                                               Value part = f(k);
                                               for (++k; k < count && eight_of(k) == eight; ++k) part += f(k);
                                               sums.add(part);
                                             }
                                           });
}

/// The same for the particles in these slots: f(k) of slots[k]. Slots of an eight must be consecutive, as in ascending order.
template <class F>
auto exact_sum_over_eights(std::span<const std::uint32_t> slots, const F& f) {
  return exact_sum_over_eights(
      slots.size(), [&](std::size_t k) { return slots[k] / fccda::byte_lanes; }, f);
}

/// The same for all particles: f(slot).
template <class F>
auto exact_sum_over_eights(const Particles& particles, const F& f) {
  const std::span<const std::uint32_t> slots = particles.slot_of();
  return exact_sum_over_eights(slots, [&](std::size_t k) { return f(std::size_t{slots[k]}); });
}

}  // namespace perimpact
