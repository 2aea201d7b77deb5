/// Part names of Gmsh elements: the physical groups of their entity, or else the entity itself.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// A point, curve, surface or volume of the geometry: its dimension and tag.
using GmshEntity = std::pair<int, int>;

/// Physical groups and entity of an element. Elements with equal labels form one part.
struct GmshLabel {
  int dimension = 0;
  std::vector<int> groups;  ///< tags of the physical groups, ascending, each once
  int entity = 0;           ///< tag of the entity where there is no group; 0: no entity either
  friend auto operator<=>(const GmshLabel&, const GmshLabel&) = default;
};

class GmshGroups {
 public:
  /// Names the physical group with that tag.
  void name(int dimension, int group, std::string name) { names_[{dimension, group}] = std::move(name); }

  /// Physical groups of an entity, in file order; a negative tag marks an entity that is reversed in the group. `called` is the
  /// entity whose tag names the elements that have no group: the entity itself, or the parent of a partition.
  void add(GmshEntity entity, const std::vector<int>& groups, int called);

  /// The number of the label of the entity's elements; one number per label.
  int label_of(GmshEntity entity);
  /// The same for elements in one group (0: none), where the file gives the group per element.
  int label_of(int dimension, int group, int entity);

  /// Whether the entity is reversed in its first group.
  bool is_reversed(GmshEntity entity) const;

  /// Merges the repeated elements of version 2, which lists an element once per group. `elements`: with labels as parts.
  void join_repeated(Elements& elements);

  /// Replaces labels by part names. Several groups are joined, "deck + hull", up to 200 bytes: "deck + hull + 12 more". Labels with equal
  /// names form one part.
  void name_parts(Elements& elements) const;

 private:
  struct Membership {
    GmshLabel label;
    bool is_reversed;
    int number = -1;  // of the label, cached: many blocks may belong to an entity with many groups
  };

  int number_of(const GmshLabel& label);
  std::string name_of(const GmshLabel& label) const;

  std::map<std::pair<int, int>, std::string> names_;  // of groups, by dimension and tag
  std::map<GmshEntity, Membership> memberships_;
  std::map<GmshLabel, int> numbers_;
  std::vector<GmshLabel> labels_;
};

}  // namespace fccda
