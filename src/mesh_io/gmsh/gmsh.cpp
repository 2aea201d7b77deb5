#include "mesh_io/gmsh/gmsh.hpp"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mesh_io/gmsh/gmsh_groups.hpp"
#include "mesh_io/gmsh/gmsh_input.hpp"
#include "mesh_io/gmsh/gmsh_kinds.hpp"
#include "mesh_io/gmsh/gmsh_node_tags.hpp"

namespace fccda {
namespace {

class Gmsh {
 public:
  Gmsh(std::string_view contents, const std::string& file) : in_(contents, file) {}

  Elements parse() {
    for (std::string line = in_.line(); !line.empty(); line = in_.line()) {
      if (!line.starts_with('$') || line.starts_with("$End"))
        in_.fail(shown(line) + " appears where a section such as `$Nodes` is expected; correct the file or export it again.");
      parse_section(line.substr(1));
    }
    if (!has_elements_) in_.fail("the file ends without `$Elements`; it is truncated or contains no mesh: export it again.");
    if (in_.version() == GmshVersion::v2) groups_.join_repeated(out_);
    groups_.name_parts(out_);
    return std::move(out_);
  }

 private:
  bool is_4() const { return in_.version() != GmshVersion::v2; }

  void parse_section(const std::string& name) {
    if (name == "PhysicalNames") {
      parse_physical_names();
    } else if (name == "Entities" && is_4()) {
      parse_entities();
    } else if (name == "PartitionedEntities" && is_4()) {
      parse_partitioned_entities();
    } else if (name == "Nodes") {
      if (has_nodes_) in_.fail("there is a second `$Nodes` section; export each mesh to a separate file.");
      is_4() ? parse_node_blocks() : parse_nodes();
      finish_nodes();
    } else if (name == "Elements") {
      if (!has_nodes_) in_.fail("`$Elements` comes before `$Nodes`; export the file again with Gmsh.");
      has_elements_ = true;
      is_4() ? parse_element_blocks() : in_.is_binary() ? parse_binary_elements() : parse_text_elements();
    } else if (name == "ParametricNodes") {
      in_.fail("the section `$ParametricNodes` is not supported; export the mesh without parametric coordinates (Mesh.SaveParametric 0).");
    } else {
      return in_.skip_section(name);
    }
    in_.end_section(name);
  }

  void parse_physical_names() {
    const std::int64_t count = in_.count_in_line("physical names");
    for (std::int64_t k = 1; k <= count; ++k) {
      in_.begin("physical name", k, count);
      const std::string line = in_.line();
      Words words(line, "");
      int tags[2];
      int found = 0;
      for (std::string_view word = words.next(); found < 2 && !word.empty() && word.front() != '"'; word = words.next()) tags[found++] = in_.integer_of(word);
      const std::size_t open = line.find('"'), close = line.rfind('"');
      if (found == 0 || open == close)
        in_.fail(in_.place() + " is " + shown(line) + ", but must have the form `2 1 \"hull\"`; correct the file or export it again.");
      constexpr std::size_t longest = 512;  // the format allows 127 characters of up to four bytes each
      if (close - open > longest) in_.fail(in_.place() + " is longer than 127 characters; shorten it in Gmsh and export it again.");
      const std::string name = line.substr(open + 1, close - open - 1);
      // version 2.0 did not write the dimension
      for (const int dimension : {2, 3})
        if (found == 1 || tags[0] == dimension) groups_.name(dimension, tags[found - 1], name);
    }
  }

  void parse_entities() {
    const std::array<std::int64_t, 4> counts = entity_counts();
    for (int dimension = 0; dimension < 4; ++dimension) {
      const std::int64_t count = counts[static_cast<std::size_t>(dimension)];
      for (std::int64_t k = 1; k <= count; ++k) {
        in_.begin("entity", k, count);
        const int tag = in_.integer();
        parse_groups({dimension, tag}, tag);
      }
    }
  }

  void parse_partitioned_entities() {
    in_.begin("the beginning of `$PartitionedEntities`");
    in_.count();
    const std::int64_t ghosts = in_.count();
    for (std::int64_t k = 1; k <= ghosts; ++k) {
      in_.begin("ghost entity", k, ghosts);
      in_.integer();
      in_.integer();
    }
    const std::array<std::int64_t, 4> counts = entity_counts();
    for (int dimension = 0; dimension < 4; ++dimension) {
      const std::int64_t count = counts[static_cast<std::size_t>(dimension)];
      for (std::int64_t k = 1; k <= count; ++k) {
        in_.begin("partitioned entity", k, count);
        const int tag = in_.integer(), parent_dimension = in_.integer(), parent = in_.integer();
        skip_integers();  // its partitions
        parse_groups({dimension, tag}, parent_dimension == dimension ? parent : tag);
      }
    }
  }

  std::array<std::int64_t, 4> entity_counts() {
    in_.begin("the beginning of the entities");
    std::array<std::int64_t, 4> counts;
    for (std::int64_t& count : counts) count = in_.count();
    return counts;
  }

  /// Fields after the tag: bounding box, physical groups, bounding entities.
  void parse_groups(GmshEntity entity, int called) {
    const bool is_point = entity.first == 0;
    const int box = is_point && in_.version() == GmshVersion::v4_1 ? 3 : 6;
    for (int k = 0; k < box; ++k) in_.skip_number();
    const std::int64_t count = in_.count();
    std::vector<int> groups;
    for (std::int64_t k = 0; k < count; ++k) groups.push_back(in_.integer());
    if (!is_point) skip_integers();
    groups_.add(entity, groups, called);
  }

  void skip_integers() {
    const std::int64_t count = in_.count();
    for (std::int64_t k = 0; k < count; ++k) in_.integer();
  }

  void parse_nodes() {
    const std::int64_t count = in_.count_in_line("nodes");
    for (std::int64_t k = 1; k <= count; ++k) {
      in_.begin("node", k, count);
      tags_.add(in_.integer());
      parse_vertex();
    }
  }

  void parse_node_blocks() {
    in_.begin("the beginning of `$Nodes`");
    const bool is_4_1 = in_.version() == GmshVersion::v4_1;
    const std::int64_t blocks = in_.count(), total = in_.count();
    if (is_4_1) skip_range();
    for (std::int64_t b = 1; b <= blocks; ++b) {
      in_.begin("block of nodes", b, blocks);
      int dimension = in_.integer(), entity = in_.integer();
      if (!is_4_1) std::swap(dimension, entity);
      const int parametric = in_.integer();
      const std::int64_t count = in_.count();
      if (dimension < 0 || dimension > 3 || parametric < 0 || parametric > 1)
        in_.fail(in_.place() + " begins with an invalid dimension or parametric flag; the file is damaged: export it again.");
      // curves have one parameter, surfaces two and, in version 4.1, volumes three
      const int parameters = parametric == 0 || (dimension == 3 && !is_4_1) ? 0 : dimension;
      const std::int64_t before = static_cast<std::int64_t>(tags_.size());
      if (is_4_1) {
        for (std::int64_t k = 1; k <= count; ++k) {
          in_.begin("node", before + k, total);
          tags_.add(in_.long_integer());
        }
      }
      for (std::int64_t k = 1; k <= count; ++k) {
        in_.begin("node", before + k, total);
        if (!is_4_1) tags_.add(in_.integer());
        parse_vertex();
        for (int p = 0; p < parameters; ++p) in_.skip_number();
      }
    }
    check_total("nodes", static_cast<std::int64_t>(tags_.size()), total);
  }

  void skip_range() {
    in_.long_integer();
    in_.long_integer();
  }

  void check_total(const char* what, std::int64_t found, std::int64_t total) {
    if (found == total) return;
    in_.fail("the blocks contain " + std::to_string(found) + " " + what + ", but the section states " + std::to_string(total) +
             "; the file is damaged: export it again.");
  }

  void parse_vertex() {
    Vec3d vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] = in_.number();
    if (out_.vertices.size() == static_cast<std::size_t>(std::numeric_limits<int>::max())) in_.fail("too many nodes; coarsen the mesh.");
    out_.vertices.push_back(vertex);
  }

  void finish_nodes() {
    has_nodes_ = true;
    if (const auto twice = tags_.finish()) in_.fail("two nodes have the number " + std::to_string(*twice) + "; renumber the mesh in Gmsh and export it again.");
  }

  const GmshKind& kind_of(int type) const {
    if (const GmshKind* kind = gmsh_kind(type)) return *kind;
    in_.fail("elements of Gmsh type " + std::to_string(type) +
             " are not supported, only points, lines, triangles, quads, tetrahedra, hexahedra, prisms and pyramids of first or second order; set "
             "Mesh.ElementOrder to 1 or 2 and export the mesh again.");
  }

  template <class Integer>
  void parse_element_nodes(const GmshKind& kind, const Integer& next_tag, bool is_reversed, int label) {
    if (kind.dimension < 2) {
      for (int n = 0; n < kind.nodes; ++n) next_tag();
      return;
    }
    std::array<int, 27> in_file;
    for (int n = 0; n < kind.nodes; ++n) {
      const std::int64_t tag = next_tag();
      const std::optional<int> node = tags_.find(tag);
      if (!node) in_.fail(in_.place() + " has node `" + std::to_string(tag) + "`, which is not defined; repair the mesh and export it again.");
      in_file[static_cast<std::size_t>(n)] = *node;
    }
    const std::span<const std::uint8_t> order = is_reversed && kind.dimension == 2 ? kind.reversed : kind.order;
    std::array<int, 20> nodes;
    for (std::size_t k = 0; k < order.size(); ++k) nodes[k] = in_file[order[k]];
    out_.add(kind.kind, std::span(nodes).first(order.size()), label);
  }

  /// Tags and nodes of an element of version 2.
  void parse_element(const GmshKind& kind, int tag_count) {
    if (tag_count < 0) in_.fail(in_.place() + " has " + std::to_string(tag_count) + " tags; the file is damaged: export it again.");
    std::array<int, 3> belongs{kind.dimension, 0, 0};  // then its group and its entity; further tags give its partitions
    for (int t = 1; t <= tag_count; ++t) {
      const int tag = in_.integer();
      if (t < 3) belongs[static_cast<std::size_t>(t)] = tag;
    }
    if (belongs != belongs_ && kind.dimension >= 2) {  // most have the label of the previous element
      belongs_ = belongs;
      label_ = groups_.label_of(belongs[0], belongs[1], belongs[2]);
    }
    parse_element_nodes(
        kind, [&] { return in_.integer(); }, false, label_);
  }

  void parse_text_elements() {
    const std::int64_t count = in_.count_in_line("elements");
    for (std::int64_t e = 1; e <= count; ++e) {
      in_.begin("element", e, count);
      in_.long_integer();
      const GmshKind& kind = kind_of(in_.integer());
      parse_element(kind, in_.integer());
    }
  }

  void parse_binary_elements() {
    const std::int64_t count = in_.count_in_line("elements");
    for (std::int64_t e = 1; e <= count;) {
      in_.begin("element", e, count);
      const GmshKind& kind = kind_of(in_.integer());
      const int in_block = in_.integer(), tags = in_.integer();
      if (in_block < 1 || in_block > count - e + 1)
        in_.fail(in_.place() + " begins a block of " + std::to_string(in_block) + "; the count or the file is damaged: export it again.");
      for (const std::int64_t end = e + in_block; e < end; ++e) {
        in_.begin("element", e, count);
        in_.integer();
        parse_element(kind, tags);
      }
    }
  }

  void parse_element_blocks() {
    in_.begin("the beginning of `$Elements`");
    const bool is_4_1 = in_.version() == GmshVersion::v4_1;
    const auto next_tag = [&] { return is_4_1 ? in_.long_integer() : std::int64_t{in_.integer()}; };
    const std::int64_t blocks = in_.count(), total = in_.count();
    if (is_4_1) skip_range();
    std::int64_t e = 1;
    for (std::int64_t b = 1; b <= blocks; ++b) {
      in_.begin("block of elements", b, blocks);
      const int first = in_.integer(), second = in_.integer();
      const GmshKind& kind = kind_of(in_.integer());
      const GmshEntity entity{kind.dimension, is_4_1 ? second : first};
      const bool is_reversed = groups_.is_reversed(entity);
      const int label = groups_.label_of(entity);
      const std::int64_t count = in_.count();
      for (std::int64_t k = 0; k < count; ++k, ++e) {
        in_.begin("element", e, total);
        next_tag();
        parse_element_nodes(kind, next_tag, is_reversed, label);
      }
    }
    check_total("elements", e - 1, total);
  }

  GmshInput in_;
  Elements out_;
  NodeTags tags_;
  GmshGroups groups_;
  std::array<int, 3> belongs_{};  // version 2: dimension, group and entity of the latest surface or solid element
  int label_ = 0;                 // the label of these
  bool has_nodes_ = false, has_elements_ = false;
};

}  // namespace

Elements parse_gmsh(std::string_view contents, const std::string& file) { return Gmsh(contents, file).parse(); }

}  // namespace fccda
