/// What a detector remembers of the sides of points from step to step: which entered where contact is ignored, and which were in contact with
/// an open surface. This is state: the next step depends on it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fccda/detect/path_test.hpp"

namespace fccda {

/// Records of single points, by their numbers, in ascending order.
class SideRecord {
 public:
  /// Changes of a share of the points, for parallel loops.
  struct Changes {
    std::vector<std::uint64_t> entering, leaving, in_contact;  ///< numbers of points
    std::uint64_t entered_before = 0;                          ///< of those entering

    void clear() { entering.clear(), leaving.clear(), in_contact.clear(), entered_before = 0; }  ///< for the next step

    /// Notes the result of one point. `entered`: before this step.
    void note(std::size_t point, const PathResult& result, bool entered, bool open) {
      if (result.leaves) leaving.push_back(point);
      if (result.enters && (!entered || result.leaves)) entering.push_back(point), entered_before += !result.is_first_entry;
      if (result.in_contact_as_ball && open) in_contact.push_back(point);
    }
  };

  bool has_entered(std::size_t point) const { return contains(entered_, point); }  ///< and is not outside again
  /// With an open surface, in the previous step or in this one so far.
  bool was_in_contact(std::size_t point) const { return contains(in_contact_before_, point) || contains(in_contact_, point); }
  bool was_renumbered() const { return renumbered_ != 0; }        ///< the entered points are determined again in this step
  std::uint64_t entered_count() const { return entered_count_; }  ///< number of entries so far

  void begin(std::size_t point_count);                                 ///< begins a step
  void begin_again();                                                  ///< repeats the step in progress from its start
  std::span<const std::uint64_t> changed() const { return changed_; }  ///< points that entered or left in this step
  void add(std::span<const Changes* const> of_shares);                 ///< the changes that a loop over points found, in order of the shares
  void end() { renumbered_ = 0; }                                      ///< all points have been evaluated
  void press(std::size_t point);                                       ///< the point counts as in contact
  void renumber();                                                     ///< the points were renumbered: all records of single ones are lost

  /// Calls visit(name, list of points or number); the visitor may write (base/state.hpp).
  template <class Self, class Visitor>
  static void visit_state(Self& self, Visitor& visit) {
    visit(std::string_view("points_inside"), self.entered_);
    visit(std::string_view("points_in_contact"), self.in_contact_);
    visit(std::string_view("renumbered"), self.renumbered_);
  }
  /// The same for what is only counted.
  template <class Visitor>
  void visit_record(Visitor& visit) {
    visit(std::string_view("entered_inside"), entered_count_);
  }

 private:
  static bool contains(const std::vector<std::uint64_t>& numbers, std::size_t point) { return std::binary_search(numbers.begin(), numbers.end(), point); }

  std::vector<std::uint64_t> entered_;  // points that entered where contact is ignored: state
  std::uint64_t entered_count_ = 0;
  // Recorded for open surfaces only: points in contact in the previous step, and in this step so far. The latter is state.
  std::vector<std::uint64_t> in_contact_before_, in_contact_;
  std::uint64_t renumbered_ = 0;  // state

  // Saved for begin_again().
  std::vector<std::uint64_t> entered_at_t0_, changed_;
  std::uint64_t entered_count_at_t0_ = 0, renumbered_at_t0_ = 0;
};

}  // namespace fccda
