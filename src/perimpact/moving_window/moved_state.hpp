/// State of a body whose window moves: captured before the body is rebuilt at its next cells, and restored cell by cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/pack.hpp"
#include "base/state.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

/// A visitor (base/state.hpp) that copies all arrays.
class CapturedState {
 public:
  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    const auto bytes = std::as_bytes(std::span(fccda::numbers_in(values)));
    arrays_.insert_or_assign(std::string(name), std::vector<std::byte>(bytes.begin(), bytes.end()));
  }
  const std::vector<std::byte>& bytes(std::string_view name) const { return arrays_.at(std::string(name)); }

 private:
  std::map<std::string, std::vector<std::byte>> arrays_;
};

/// A visitor that writes captured arrays back into the simulation, in which the moved body, its boundary conditions and the contact between fragments have been
/// rebuilt. Arrays over the slots, or over the eights, of this body, and lists of numbers of its particles, take over the values of the cells that its cells
/// move to; new material keeps its initial values, and pairs and points of discarded material are left out. Sums since the beginning stay in their eights.
/// All other arrays are restored as they were. Collective: state that comes from another rank is sent.
class MovedState {
 public:
  struct MovedBody {
    std::string name;
    std::size_t index;
    std::size_t first_id;        ///< of its particles in pairs of the contact of fragments: number of slots of the bodies before it, on all ranks
    std::array<int, 3> cells;    ///< by which it moves, MovingWindow::cells_of(moves)
    const Particles& particles;  ///< rebuilt
    const Family& family;        ///< rebuilt
  };

  MovedState(const CapturedState& captured, const MovedBody& body);

  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    const std::vector<std::byte>& from = captured_.bytes(name);
    if constexpr (requires { values.body; }) {
      values.assign(values.body == body_.index ? points(numbers_of<std::uint64_t>(from)) : numbers_of<std::uint64_t>(from));
    } else if constexpr (std::is_same_v<std::remove_cvref_t<Values>, EndsOfPairs>) {
      values.assign(ends_of_pairs(of_all_ranks<std::uint64_t>(from)));
    } else if constexpr (std::is_same_v<std::remove_cvref_t<Values>, NumbersOfPairs>) {
      values.assign(of_kept_pairs(of_all_ranks<double>(from), values.per_pair));
    } else if constexpr (fccda::is_list<std::remove_cvref_t<Values>>) {
      values.resize(from.size() / sizeof(typename std::remove_cvref_t<Values>::value_type));
      copy(from, std::as_writable_bytes(std::span(values)));
    } else {
      const auto numbers = fccda::numbers_in(values);
      using T = typename decltype(numbers)::value_type;
      if constexpr (requires { values.per_eight; }) {
        if (values.share == &body_.particles.share() && values.kind != OfEights::sums)
          return eights(values.kind, numbers_of<T>(from), numbers, values.per_eight.each);
      } else if constexpr (requires { values.slots; }) {
        if (const std::size_t each = numbers_of_each_particle(name, numbers.size(), values.slots.size()); each != 0)
          return of_particles(numbers_of<T>(from), numbers, values.slots, each);
      }
      copy(from, std::as_writable_bytes(numbers));
    }
  }

 private:
  template <class T>
  static std::vector<T> numbers_of(std::span<const std::byte> bytes) {
    std::vector<T> numbers(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
  }
  template <class T>
  std::vector<T> of_all_ranks(std::span<const std::byte> own) const {
    return body_.particles.share().ranks().join_all(std::span<const T>(numbers_of<T>(own)));
  }
  static void copy(std::span<const std::byte> from, std::span<std::byte> to);
  std::vector<std::uint64_t> points(std::vector<std::uint64_t> from) const;
  std::vector<std::uint64_t> ends_of_pairs(std::span<const std::uint64_t> from);
  /// `from`: `per_pair` numbers of each of the pairs that ends_of_pairs() received.
  std::vector<double> of_kept_pairs(std::span<const double> from, std::size_t per_pair) const;
  /// `per_eight` numbers of each eight slots of the body.
  template <class T>
  void eights(OfEights kind, const std::vector<T>& from, std::span<T> to, std::size_t per_eight) const {
    const Share& share = body_.particles.share();
    if constexpr (std::is_same_v<T, std::uint8_t>)
      if (kind == OfEights::bonds) return bonds(from, to, per_eight);
    share.shift(*body_.particles.lattice(), std::span<const T>(from), to, per_eight, body_.cells);
    if (std::is_floating_point_v<T> && per_eight == fccda::byte_lanes) share.refresh({to.data()});
  }
  /// A list of `each` numbers of particles of the body. Those of a particle that was not in the list are 0.
  template <class T>
  void of_particles(const std::vector<T>& from, std::span<T> to, std::span<const std::uint32_t> slots, std::size_t each) const {
    std::vector<T> before(body_.particles.slots()), after(before.size());
    for (std::size_t c = 0; c < each; ++c) {
      for (std::size_t k = 0; k < slots.size(); ++k) before[slots[k]] = from[k * each + c], after[slots[k]] = to[k * each + c];
      body_.particles.share().shift(*body_.particles.lattice(), std::span<const T>(before), std::span<T>(after), fccda::byte_lanes, body_.cells);
      for (std::size_t k = 0; k < slots.size(); ++k) to[k * each + c] = after[slots[k]];
    }
  }
  /// Number of values that this list has for each particle; 0 if it does not belong to this body. `numbers`, `slots`: on this rank. Collective.
  std::size_t numbers_of_each_particle(std::string_view name, std::size_t numbers, std::size_t slots) const;
  void bonds(std::span<const std::uint8_t> from, std::span<std::uint8_t> to, std::size_t per_eight) const;
  /// Slot after the move that receives the state of `whole_slot` before it, on the lattice of the whole body; none if that state is discarded.
  std::optional<std::size_t> target(std::size_t whole_slot) const;
  /// Id of a particle after the move; none if it is discarded.
  std::optional<std::size_t> moved_id(std::size_t id) const;

  const CapturedState& captured_;
  MovedBody body_;
  std::vector<std::uint8_t> is_new_;     // 1 for each slot of new material
  std::vector<std::size_t> kept_pairs_;  // of the latest list of pairs
};

}  // namespace perimpact
