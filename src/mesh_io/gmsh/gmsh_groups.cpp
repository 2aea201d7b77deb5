#include "mesh_io/gmsh/gmsh_groups.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <span>

namespace fccda {
namespace {

/// Element numbers sorted by nodes, so that elements with equal nodes are adjacent, in file order among themselves.
std::vector<std::size_t> by_nodes(const Elements& elements) {
  std::vector<int> nodes = elements.nodes;
  const auto nodes_of = [&](std::size_t e) {
    const std::size_t begin = e == 0 ? 0 : elements.ends[e - 1];
    return std::span(nodes).subspan(begin, elements.ends[e] - begin);
  };
  for (std::size_t e = 0; e < elements.size(); ++e) std::sort(nodes_of(e).begin(), nodes_of(e).end());
  std::vector<std::size_t> order(elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const std::span<int> of_a = nodes_of(a), of_b = nodes_of(b);
    return std::lexicographical_compare(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
  });
  return order;
}

bool have_same_nodes(const Elements& elements, std::size_t a, std::size_t b) {
  const std::span<const int> of_a = elements.nodes_of_element(a), of_b = elements.nodes_of_element(b);
  return elements.kinds[a] == elements.kinds[b] && std::is_permutation(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
}

}  // namespace

void GmshGroups::add(GmshEntity entity, const std::vector<int>& groups, int called) {
  Membership membership{{entity.first, groups, groups.empty() ? called : 0}, !groups.empty() && groups.front() < 0};
  std::vector<int>& tags = membership.label.groups;
  constexpr int least = std::numeric_limits<int>::min();  // cannot be negated; a valid tag nevertheless
  std::transform(tags.begin(), tags.end(), tags.begin(), [](int tag) { return tag == least ? tag : std::abs(tag); });
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  memberships_[entity] = std::move(membership);
}

int GmshGroups::number_of(const GmshLabel& label) {
  const auto [entry, is_new] = numbers_.try_emplace(label, static_cast<int>(labels_.size()));
  if (is_new) labels_.push_back(label);
  return entry->second;
}

int GmshGroups::label_of(GmshEntity entity) {
  const auto found = memberships_.find(entity);
  if (found == memberships_.end()) return number_of({entity.first, {}, entity.second});
  Membership& membership = found->second;
  if (membership.number < 0) membership.number = number_of(membership.label);
  return membership.number;
}

int GmshGroups::label_of(int dimension, int group, int entity) {
  return number_of(group == 0 ? GmshLabel{dimension, {}, entity} : GmshLabel{dimension, {group}, 0});
}

bool GmshGroups::is_reversed(GmshEntity entity) const {
  const auto found = memberships_.find(entity);
  return found != memberships_.end() && found->second.is_reversed;
}

void GmshGroups::join_repeated(Elements& elements) {
  if (labels_.size() < 2) return;
  constexpr int dropped = -1;
  const std::vector<std::size_t> order = by_nodes(elements);
  for (auto begin = order.begin(), end = begin; begin != order.end(); begin = end) {
    const GmshLabel label = labels_[static_cast<std::size_t>(elements.part[*begin])];
    std::set<int> groups(label.groups.begin(), label.groups.end());
    for (end = std::next(begin); end != order.end() && have_same_nodes(elements, *begin, *end); ++end) {
      const std::vector<int>& more = labels_[static_cast<std::size_t>(elements.part[*end])].groups;
      // a duplicate without a group or within one group does not result from group membership: it is kept, as a defect of the mesh
      if (groups.empty() || more.empty() || !groups.insert(more.front()).second) continue;
      elements.part[*end] = dropped;
    }
    elements.part[*begin] = number_of({label.dimension, {groups.begin(), groups.end()}, label.entity});
  }
  Elements kept;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (elements.part[e] != dropped) kept.add(elements.kinds[e], elements.nodes_of_element(e), elements.part[e]);
  kept.vertices = std::move(elements.vertices);
  elements = std::move(kept);
}

std::string GmshGroups::name_of(const GmshLabel& label) const {
  const std::string noun = label.dimension == 3 ? "volume " : "surface ";
  if (label.groups.empty()) return label.entity == 0 ? "" : noun + std::to_string(label.entity);
  constexpr std::size_t longest = 200;  // [bytes] a group takes two bytes in the file, but up to 512 for its name in every label
  std::string all;
  std::set<std::string> seen;
  for (auto group = label.groups.begin(); group != label.groups.end(); ++group) {
    const auto named = names_.find({label.dimension, *group});
    const std::string name = named == names_.end() ? "physical " + noun + std::to_string(*group) : named->second;
    if (!seen.insert(name).second) continue;
    const std::string longer = all.empty() ? name : all + " + " + name;
    if (!all.empty() && longer.size() > longest) return all + " + " + std::to_string(label.groups.end() - group) + " more";
    all = longer;
  }
  return all;
}

void GmshGroups::name_parts(Elements& elements) const {
  std::vector<int> part_of_label(labels_.size(), -1);
  for (int& part : elements.part) {
    int& of_label = part_of_label[static_cast<std::size_t>(part)];
    if (of_label < 0) of_label = elements.part_number(name_of(labels_[static_cast<std::size_t>(part)]));
    part = of_label;
  }
}

}  // namespace fccda
