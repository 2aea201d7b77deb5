#include "mesh_io/keyword/lsdyna.hpp"
#include "mesh_io/file/text.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh_io/file/words.hpp"
#include "mesh_io/keyword/fortran_number.hpp"
#include "mesh_io/keyword/lsdyna_cards.hpp"
#include "mesh_io/keyword/lsdyna_keywords.hpp"
#include "mesh_io/keyword/numbered_mesh.hpp"
#include "mesh_io/keyword/repeated_nodes.hpp"

namespace fccda {
namespace {

using Id = NumberedMesh::Id;
using Kind = LsdynaBlock::Kind;

// card columns in standard format
constexpr int node_columns[] = {8, 16, 16, 16};
constexpr int element_columns[] = {8, 8, 8, 8, 8, 8, 8, 8, 8, 8};
constexpr int part_columns[] = {10, 10, 10, 10, 10, 10, 10, 10};

class LsdynaFile {
 public:
  LsdynaFile(std::string_view contents, const std::string& file) : lines_(contents, file) {}

  Elements parse() {
    bool has_keyword = false;
    while (block_.kind != Kind::end && lines_.next()) {
      const std::string_view line = lines_.line();
      if (line.starts_with('$')) continue;
      if (line.starts_with('*')) {
        if (is_due_) fail_in_element("ends before its last card; it is truncated: export the file again.");
        start_block();
        has_keyword = true;
      } else if (!has_keyword && !trimmed(line).empty()) {
        lines_.fail(shown(trimmed(line)) + " appears where a keyword such as *KEYWORD is expected; this is not an LS-DYNA file.");
      } else {
        parse_line();
      }
    }
    if (is_due_) fail_in_element("ends before its last card; it is truncated: export the file again.");
    return mesh();
  }

 private:
  void start_block() {
    keyword_ = lsdyna_keyword(lines_.line(), default_width_);
    block_ = lsdyna_block(keyword_.name);
    card_ = 0;
    switch (block_.kind) {
      case Kind::usual_width:
        default_width_ = lsdyna_usual_width(keyword_);
        return;
      case Kind::include:
        lines_.fail("*" + excerpt(keyword_.name) + " refers to another file, but only this one is read; insert the lines of that file here.");
      case Kind::maker:
        lines_.fail("*" + excerpt(keyword_.name) + " moves nodes or copies elements, which is not supported; export the resulting mesh.");
      case Kind::other:
        lines_.fail("*" + excerpt(keyword_.name) + " is not supported; export the surface as *ELEMENT_SHELL or *ELEMENT_SOLID with ordinary nodes.");
      default:
        return;
    }
  }

  /// `card_` counts the cards of one element or part from 0; it is 0 again when the next one may begin.
  void parse_line() {
    const bool is_blank = trimmed(lines_.line()).empty();
    switch (block_.kind) {
      case Kind::nodes:
        if (!is_blank) parse_node();
        return;
      case Kind::shells:
      case Kind::solids:
      case Kind::thick_shells:
        if (card_ == 0 && is_blank) return;
        return parse_card_of_element();
      case Kind::parts:
      case Kind::part:
        return parse_card_of_part();
      default:
        return;
    }
  }

  LsdynaCard card(std::span<const int> columns) const { return {lines_, columns, keyword_.width}; }

  Id positive(Id id, const std::string& what) const {
    if (id <= 0) lines_.fail(what + " is " + std::to_string(id) + ", but numbers begin with 1; correct the file or export it again.");
    return id;
  }

  void parse_node() {
    const LsdynaCard fields = card(node_columns);
    const Id id = positive(fields.integer(0, "*NODE"), "the node number");
    const std::string name = "node " + std::to_string(id);
    const auto coordinate = [&](std::size_t k) { return fields.real(k, name); };
    nodes_and_elements_.add_node(id, {coordinate(1), coordinate(2), coordinate(3)}, lines_.number());
  }

  [[noreturn]] void fail_in_element(const std::string& what) const { lines_.fail_at(element_line_, element_name_ + " " + what); }

  void parse_card_of_element() {
    if (card_ == 0) {
      begin_element();
    } else if (card_ == 1 && has_second_card_) {
      const LsdynaCard fields = card(element_columns);
      for (std::size_t k = 0; k < LsdynaCard::most; ++k) nodes_.push_back(fields.integer(k, element_name_));
    }
    ++card_;
    if (card_ == 1 + (has_second_card_ ? 1 : 0)) add_element();
    is_due_ = card_ < cards_of_element_;
    if (!is_due_) card_ = 0;
  }

  void begin_element() {
    const LsdynaCard fields = card(element_columns);
    element_line_ = lines_.number();
    element_ = positive(fields.integer(0, "*" + keyword_.name), "the element number");
    element_name_ = "element " + std::to_string(element_);
    part_ = fields.integer(1, element_name_);
    nodes_.clear();
    for (std::size_t k = 2; k < LsdynaCard::most; ++k) nodes_.push_back(fields.integer(k, element_name_));
    const bool has_nodes = std::any_of(nodes_.begin(), nodes_.end(), [](Id id) { return id != 0; });
    has_second_card_ = block_.kind == Kind::solids && !has_nodes;
    if (has_second_card_) nodes_.clear();
    const bool has_middle_nodes = block_.kind == Kind::shells && nodes_[4] != 0;
    cards_of_element_ = 1 + (has_second_card_ ? 1 : 0) + block_.more_cards + (block_.has_thickness ? (has_middle_nodes ? 2 : 1) : 0);
  }

  void add_element() {
    while (!nodes_.empty() && nodes_.back() == 0) nodes_.pop_back();
    for (const Id id : nodes_)
      if (id <= 0) fail_in_element("has " + std::to_string(id) + " among its nodes; correct the element.");
    const std::size_t count = nodes_.size();
    if (block_.kind == Kind::shells) {
      if (count == 8 && !repeats_nodes(nodes_)) return add(ElementKind::quad_8, nodes_);
      if (count == 3 || count == 4) return add(surface_without_repeats(nodes_));
    } else {
      if (count == 10 && !repeats_nodes(nodes_)) return add(ElementKind::tetrahedron_10, nodes_);
      if (count == 4 || count == 8) return add(solid_without_repeats(nodes_));
    }
    refuse_shape();
  }

  void add(const std::optional<NumberedShape>& shape) {
    if (!shape) refuse_shape();
    add(shape->kind, shape->all());
  }

  void add(ElementKind kind, std::span<const Id> ids) {
    const auto [entry, is_new] = groups_.try_emplace(part_, static_cast<int>(parts_.size()));
    if (is_new) parts_.push_back(part_);
    nodes_and_elements_.add_element(element_, kind, ids, static_cast<int>(block_.kind), entry->second, element_line_);
  }

  [[noreturn]] void refuse_shape() const {
    fail_in_element(block_.kind == Kind::shells
                        ? "has nodes that do not form a triangle or a quad (with mid-side nodes on all sides of a quad or on none); correct or delete it."
                        : "has nodes that do not form a tetrahedron, pyramid, wedge, hexahedron or ten-node tetrahedron; correct or delete it.");
  }

  void parse_card_of_part() {
    if (card_ == 0) {
      heading_ = printable(trimmed(lines_.line()));
      more_cards_of_part_ = block_.more_cards;
    } else if (card_ == 1) {
      headings_.try_emplace(card(part_columns).integer(0, "*" + keyword_.name), heading_);
    } else if (card_ == 2 && block_.has_inertia && card(part_columns).integer(4, "*" + keyword_.name) == 1) {
      ++more_cards_of_part_;  // the system in which the inertia is given
    }
    ++card_;
    if (block_.kind == Kind::parts && card_ == 2 + more_cards_of_part_) card_ = 0;
  }

  std::vector<std::string> names_of_parts() const {
    std::unordered_map<std::string, int> times;
    for (const auto& [id, heading] : headings_) ++times[heading];
    const auto is_unique = [&](const std::string& heading) {
      const bool is_number = heading.starts_with("part ") && fortran_integer(std::string_view(heading).substr(5));  // may be the default name of another part
      return !heading.empty() && !is_number && times[heading] == 1;
    };
    std::vector<std::string> names;
    for (const Id id : parts_) {
      const auto heading = headings_.find(id);
      names.push_back(heading != headings_.end() && is_unique(heading->second) ? heading->second : "part " + std::to_string(id));
    }
    return names;
  }

  Elements mesh() {
    nodes_and_elements_.finish(lines_);
    Elements out;
    std::vector<int> part_of_group;
    for (const std::string& name : names_of_parts()) part_of_group.push_back(out.part_number(name));
    std::vector<int> parts;
    for (std::size_t e = 0; e < nodes_and_elements_.size(); ++e) parts.push_back(part_of_group[static_cast<std::size_t>(nodes_and_elements_.group(e))]);
    nodes_and_elements_.append_to(
        out, [](const Vec3d& place) { return place; }, parts, lines_);
    return out;
  }

  Lines lines_;
  NumberedMesh nodes_and_elements_;
  std::unordered_map<Id, int> groups_;  // of elements, by the number of their part
  std::vector<Id> parts_;               // by group
  std::map<Id, std::string> headings_;

  LsdynaWidth default_width_ = LsdynaWidth::standard;
  LsdynaKeyword keyword_;
  LsdynaBlock block_;
  int card_ = 0;

  bool is_due_ = false;  // whether more cards of the element follow
  bool has_second_card_ = false;
  int cards_of_element_ = 0;
  Id element_ = 0, part_ = 0;
  std::string element_name_;  // for messages
  std::size_t element_line_ = 0;
  std::vector<Id> nodes_;

  std::string heading_;
  int more_cards_of_part_ = 0;
};

}  // namespace

Elements parse_lsdyna(std::string_view contents, const std::string& file) { return LsdynaFile(contents, file).parse(); }

}  // namespace fccda
