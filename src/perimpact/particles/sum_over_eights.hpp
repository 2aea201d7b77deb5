/// Sums over particles that do not depend on how slots are distributed among threads or processes: plain sums within each *eight*, the slots 8 n … 8 n + 7,
/// and exact sums of these (base/exact_sum.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "base/exact_sum.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// The values of sums to which each rank has added its terms, by one reduction. Collective.
template <class Value>
std::vector<Value> values_of_all(Ranks& ranks, std::span<fccda::ExactSums<Value>> all) {
  if (ranks.size() > 1) {
    std::vector<std::int64_t> limbs;
    for (fccda::ExactSums<Value>& sums : all)
      for (fccda::ExactSum& sum : sums.of_members()) limbs.insert(limbs.end(), sum.limbs().begin(), sum.limbs().end());
    ranks.sum(limbs);
    auto from = limbs.begin();
    for (fccda::ExactSums<Value>& sums : all)
      for (fccda::ExactSum& sum : sums.of_members())
        for (std::int64_t& limb : sum.limbs()) limb = *from++;
  }
  std::vector<Value> values;
  for (const fccda::ExactSums<Value>& sums : all) values.push_back(sums.value());
  return values;
}

/// The same of one.
template <class Value>
Value value_of_all(Ranks& ranks, fccda::ExactSums<Value> sums) {
  return values_of_all(ranks, std::span(&sums, 1)).front();
}

/// The messages of value_of_all().
template <class Value>
constexpr Traffic reduction_of_sums() {
  return reduction_of(static_cast<std::int64_t>(sizeof(Value) / sizeof(double) * fccda::ExactSum::limb_count));
}

/// Exact sum of numbers of all ranks. Collective.
inline double exact_sum(Ranks& ranks, std::span<const double> numbers) { return value_of_all(ranks, fccda::exact_sum(numbers)); }

/// f(0) + f(1) + …, where f(e) is the plain sum over one of `count` eights: their exact sum, over all ranks; collective. Parallel, as exact_sum_over_eights().
template <class F>
auto exact_sum_of_eights(Ranks& ranks, std::size_t count, const F& f) {
  using Value = std::decay_t<decltype(f(std::size_t{}))>;
  constexpr std::size_t share_size = 32;
  return value_of_all(ranks, fccda::exact_sum_of_shares<Value>(static_cast<std::ptrdiff_t>((count + share_size - 1) / share_size),
                                                               [&](std::ptrdiff_t share, fccda::ExactSums<Value>& sums) {
                                                                 const std::size_t begin = static_cast<std::size_t>(share) * share_size;
                                                                 for (std::size_t e = begin; e < std::min(begin + share_size, count); ++e) sums.add(f(e));
                                                               }));
}

/// f(0) + f(1) + …, `count` of them, each a double or a struct of doubles with +=. Consecutive k of equal eight_of(k) are summed in order, their sums exactly.
/// Parallel; f is called once for each k and may write data of its index. The sum over all ranks; collective.
template <class EightOf, class F>
auto exact_sum_over_eights(Ranks& ranks, std::size_t count, const EightOf& eight_of, const F& f) {
  using Value = std::decay_t<decltype(f(std::size_t{}))>;
  constexpr std::size_t share_size = 256;
  const auto own = fccda::exact_sum_of_shares<Value>(static_cast<std::ptrdiff_t>((count + share_size - 1) / share_size),
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
  return value_of_all(ranks, own);
}

/// The same for the particles in these slots: f(k) of slots[k]. Slots of an eight must be consecutive, as in ascending order.
template <class F>
auto exact_sum_over_eights(Ranks& ranks, std::span<const std::uint32_t> slots, const F& f) {
  return exact_sum_over_eights(
      ranks, slots.size(), [&](std::size_t k) { return slots[k] / fccda::byte_lanes; }, f);
}

/// The same for all particles of the body: f(slot).
template <class F>
auto exact_sum_over_eights(const Particles& particles, const F& f) {
  const std::span<const std::uint32_t> slots = particles.slot_of();
  return exact_sum_over_eights(particles.share().ranks(), slots, [&](std::size_t k) { return f(std::size_t{slots[k]}); });
}

}  // namespace perimpact
