/// What elements of Gmsh are called: by the physical groups of the entity they mesh, or else by that entity.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// A point, curve, surface or volume of the geometry, known by dimension and tag.
using GmshEntity = std::pair<int, int>;

/// Where an element belongs. Elements of one label are one part.
struct GmshLabel {
  int dimension = 0;
  std::vector<int> groups;  ///< tags of the physical groups, ascending, each once
  int entity = 0;           ///< tag of the entity where there is no group; 0: nor an entity
  friend auto operator<=>(const GmshLabel&, const GmshLabel&) = default;
};

class GmshGroups {
 public:
  /// The name of the physical group with that tag.
  void name(int dimension, int group, std::string name) { names_[{dimension, group}] = std::move(name); }

  /// Physical groups of an entity, in the order of the file; a negative tag says that the group holds the entity turned over. `called` is the
  /// entity whose tag names the elements where there are none: the entity itself, or the one that it is a partition of.
  void add(GmshEntity entity, const std::vector<int>& groups, int called);

  /// The label of the entity's elements, numbered; one number a label.
  int label_of(GmshEntity entity);
  /// That of elements in one group (0: in none), where the file says so element by element.
  int label_of(int dimension, int group, int entity);

  /// Is the entity turned over by the first of its groups?
  bool is_reversed(GmshEntity entity) const;

  /// Version 2 lists an element once for each of its groups. Makes one of those: `elements` with labels as parts.
  void join_repeated(Elements& elements);

  /// Puts part names in place of labels. Of several groups all names, "deck + hull", or as many as fit into 200 bytes: "deck + hull + 12 more".
  /// Labels that are called the same are one part.
  void name_parts(Elements& elements) const;

 private:
  struct Membership {
    GmshLabel label;
    bool is_reversed;
    int number = -1;  // of the label, once one asked: many blocks may belong to an entity of many groups
  };

  int number_of(const GmshLabel& label);
  std::string name_of(const GmshLabel& label) const;

  std::map<std::pair<int, int>, std::string> names_;  // of groups, by dimension and tag
  std::map<GmshEntity, Membership> memberships_;
  std::map<GmshLabel, int> numbers_;
  std::vector<GmshLabel> labels_;
};

}  // namespace fccda
