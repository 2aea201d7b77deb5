/// Nodes and elements with arbitrary solver numbering; elements may precede their nodes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh_io/file/elements.hpp"
#include "mesh_io/keyword/lines.hpp"

namespace fccda {

class NumberedMesh {
 public:
  using Id = std::int64_t;

  /// `line`: line of the definition, for messages.
  void add_node(Id id, const Vec3d& place, std::size_t line);

  /// `family`: numbers of different families are independent, as those of shells and solids in LS-DYNA. `group`: index of the future part, from
  /// 0.
  void add_element(Id id, ElementKind kind, std::span<const Id> element_nodes, int family, int group, std::size_t line);

  /// Sorts by number; call after the last node and element and before the functions below. Merges duplicates: nodes with equal coordinates, and
  /// elements with equal nodes. Throws InputError through `lines` where a duplicate number has a different definition.
  void finish(const Lines& lines);

  std::size_t size() const { return groups_.size(); }  ///< elements
  int group(std::size_t element) const { return groups_[element]; }
  std::size_t entries() const { return node_ids_.size() + nodes_.size(); }  ///< nodes plus corners: the size of a copy

  Id id(std::size_t element) const { return element_ids_[element]; }

  /// The elements numbered from first to last, in ascending order; requires that all elements are of one family.
  std::span<const std::size_t> elements_between(Id first, Id last) const;

  /// Appends the nodes, transformed by `moved`, and the elements, with the part numbers in `parts` (one per element). Throws InputError through
  /// `lines` where an element has an undefined node.
  void append_to(Elements& out, const std::function<Vec3d(const Vec3d&)>& moved, std::span<const int> parts, const Lines& lines) const;

 private:
  std::span<const Id> nodes_of_element(std::size_t element) const;
  std::size_t find_node(Id id) const;  // its index, or node_ids_.size()
  void sort_nodes(const Lines& lines);
  void sort_elements(const Lines& lines);
  bool are_alike(std::size_t element, std::size_t other) const;

  std::vector<Id> node_ids_;
  std::vector<std::size_t> node_lines_;
  std::vector<Vec3d> places_;

  std::vector<Id> element_ids_;
  std::vector<std::size_t> element_lines_;
  std::vector<ElementKind> kinds_;
  std::vector<std::uint8_t> families_;
  std::vector<int> groups_;
  std::vector<std::size_t> ends_;
  std::vector<Id> nodes_;
  std::vector<std::size_t> by_number_;  // elements
  std::vector<bool> is_repeat_;
};

}  // namespace fccda
