/// State of a body whose window moves: captured before the body is rebuilt at its next cells, and restored slot by slot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/state.hpp"
#include "perimpact/family/family.hpp"

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

/// A visitor that writes captured arrays into the parts of the simulation, of which the moved body, its boundary conditions and the contact of fragments are
/// rebuilt. Arrays over the slots, or over the eights, of this body take over the values of their sources (MovingWindow::sources); new material keeps its
/// initial values, and pairs and points of discarded material are left out. Sums since the beginning (names that end in "_of_eight") stay in their eights, so
/// that their totals include what is discarded. All other arrays are restored as they were.
class MovedState {
 public:
  struct MovedBody {
    std::string name;
    std::size_t index;
    std::size_t first_id;                   ///< of its particles in pairs of the contact of fragments: number of slots of the bodies before it
    std::span<const std::int64_t> sources;  ///< of each slot
    const Family& family;                   ///< rebuilt
  };

  MovedState(const CapturedState& captured, const MovedBody& body);

  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    const std::vector<std::byte>& from = captured_.bytes(name);
    if constexpr (fccda::is_list<std::remove_cvref_t<Values>>) {
      using T = typename std::remove_cvref_t<Values>::value_type;
      const std::vector<std::byte> moved = list(name, from);
      values.resize(moved.size() / sizeof(T));
      copy(moved, std::as_writable_bytes(std::span(values)));
    } else {
      const auto numbers = fccda::numbers_in(values);
      array(name, from, std::as_writable_bytes(numbers), sizeof(numbers[0]));
    }
  }

 private:
  static void copy(std::span<const std::byte> from, std::span<std::byte> to);
  std::vector<std::byte> list(std::string_view name, const std::vector<std::byte>& from);
  void array(std::string_view name, std::span<const std::byte> from, std::span<std::byte> to, std::size_t size_of_number) const;
  static void take_over(std::span<const std::int64_t> sources, std::span<const std::byte> from, std::span<std::byte> to, std::size_t size_of_number);
  void bonds(std::span<const std::byte> from, std::span<std::byte> to) const;
  /// Id of a particle after the move; -1 if it is discarded.
  std::int64_t moved_id(std::uint64_t id) const;

  const CapturedState& captured_;
  MovedBody body_;
  std::vector<std::int64_t> source_eights_;  // of each eight; -1 for new material
  std::vector<std::int64_t> target_of_;      // of each slot before the move; -1 if it is discarded
  std::vector<std::size_t> kept_pairs_;      // of the latest list of pairs
};

}  // namespace perimpact
