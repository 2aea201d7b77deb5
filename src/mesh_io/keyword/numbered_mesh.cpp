#include "mesh_io/keyword/numbered_mesh.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

#include "base/contract.hpp"

namespace fccda {
namespace {

template <class T>
std::vector<T> in_order(const std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> out;
  out.reserve(order.size());
  for (const std::size_t k : order) out.push_back(values[k]);
  return out;
}

}  // namespace

void NumberedMesh::add_node(Id id, const Vec3d& place, std::size_t line) {
  node_ids_.push_back(id);
  places_.push_back(place);
  node_lines_.push_back(line);
}

void NumberedMesh::add_element(Id id, ElementKind kind, std::span<const Id> element_nodes, int family, int group, std::size_t line) {
  element_ids_.push_back(id);
  kinds_.push_back(kind);
  nodes_.insert(nodes_.end(), element_nodes.begin(), element_nodes.end());
  ends_.push_back(nodes_.size());
  families_.push_back(static_cast<std::uint8_t>(family));
  groups_.push_back(group);
  element_lines_.push_back(line);
}

void NumberedMesh::finish(const Lines& lines) {
  sort_nodes(lines);
  sort_elements(lines);
}

void NumberedMesh::sort_nodes(const Lines& lines) {
  std::vector<std::size_t> order(node_ids_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!std::is_sorted(node_ids_.begin(), node_ids_.end()))
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return node_ids_[a] < node_ids_[b]; });
  std::size_t kept = 0;
  for (const std::size_t k : order) {
    if (kept > 0 && node_ids_[order[kept - 1]] == node_ids_[k]) {
      const std::size_t first = order[kept - 1];
      if (places_[first] == places_[k]) continue;
      lines.fail_at(node_lines_[k], "node " + std::to_string(node_ids_[k]) + " has different coordinates on line " + std::to_string(node_lines_[first]) +
                                        "; renumber one of the two.");
    }
    order[kept++] = k;
  }
  order.resize(kept);
  node_ids_ = in_order(node_ids_, order);
  places_ = in_order(places_, order);
  node_lines_ = {};  // later messages do not refer to node lines
}

void NumberedMesh::sort_elements(const Lines& lines) {
  by_number_.resize(size());
  std::iota(by_number_.begin(), by_number_.end(), std::size_t{0});
  const auto number = [&](std::size_t e) { return std::tuple(families_[e], element_ids_[e]); };
  const auto is_before = [&](std::size_t a, std::size_t b) { return number(a) < number(b); };
  if (!std::is_sorted(by_number_.begin(), by_number_.end(), is_before)) std::stable_sort(by_number_.begin(), by_number_.end(), is_before);
  is_repeat_.assign(size(), false);
  std::size_t first = 0;  // first element with the same number
  for (std::size_t k = 1; k < by_number_.size(); ++k) {
    const std::size_t element = by_number_[k], other = by_number_[first];
    if (number(element) != number(other)) {
      first = k;
    } else if (are_alike(element, other)) {
      is_repeat_[element] = true;
    } else {
      lines.fail_at(element_lines_[element], "element " + std::to_string(element_ids_[element]) + " is defined differently on line " +
                                                 std::to_string(element_lines_[other]) + "; renumber one of the two.");
    }
  }
  std::erase_if(by_number_, [&](std::size_t e) { return is_repeat_[e]; });
}

bool NumberedMesh::are_alike(std::size_t element, std::size_t other) const {
  const std::span<const Id> a = nodes_of_element(element), b = nodes_of_element(other);
  return kinds_[element] == kinds_[other] && groups_[element] == groups_[other] && std::equal(a.begin(), a.end(), b.begin(), b.end());
}

std::span<const NumberedMesh::Id> NumberedMesh::nodes_of_element(std::size_t element) const {
  const std::size_t begin = element == 0 ? 0 : ends_[element - 1];
  return std::span(nodes_).subspan(begin, ends_[element] - begin);
}

std::size_t NumberedMesh::find_node(Id id) const {
  if (node_ids_.empty() || id < node_ids_.front() || id > node_ids_.back()) return node_ids_.size();
  // sorted ids differ by at least one, which bounds the index of `id`; without gaps the bound is exact
  const std::uint64_t farthest = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(node_ids_.front());
  if (farthest < node_ids_.size() && node_ids_[farthest] == id) return farthest;
  const auto found = std::lower_bound(node_ids_.begin(), node_ids_.end(), id);
  return *found == id ? static_cast<std::size_t>(found - node_ids_.begin()) : node_ids_.size();
}

std::span<const std::size_t> NumberedMesh::elements_between(Id first, Id last) const {
  const auto begin = std::lower_bound(by_number_.begin(), by_number_.end(), first, [&](std::size_t e, Id number) { return element_ids_[e] < number; });
  const auto end = std::upper_bound(begin, by_number_.end(), last, [&](Id number, std::size_t e) { return number < element_ids_[e]; });
  return {begin, end};
}

void NumberedMesh::append_to(Elements& out, const std::function<Vec3d(const Vec3d&)>& moved, std::span<const int> parts, const Lines& lines) const {
  EXPECTS(parts.size() == size());
  const std::size_t base = out.vertices.size();
  if (base + places_.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) lines.fail("too many nodes; coarsen the mesh.");
  for (std::size_t n = 0; n < places_.size(); ++n) {
    out.vertices.push_back(moved(places_[n]));
    if (!is_finite(out.vertices.back()))
      lines.fail("node " + std::to_string(node_ids_[n]) +
                 " is transformed to coordinates that are not finite; correct the node or the transformation of its instance.");
  }
  std::vector<int> vertices;
  for (std::size_t e = 0; e < size(); ++e) {
    if (is_repeat_[e]) continue;
    vertices.clear();
    for (const Id id : nodes_of_element(e)) {
      const std::size_t node = find_node(id);
      if (node == node_ids_.size()) {
        lines.fail_at(element_lines_[e], "element " + std::to_string(element_ids_[e]) + " has node " + std::to_string(id) +
                                             ", which is not defined; correct the element or add the node.");
      }
      vertices.push_back(static_cast<int>(base + node));
    }
    out.add(kinds_[e], vertices, parts[e]);
  }
}

}  // namespace fccda
