#include "mesh_io/keyword/abaqus.hpp"
#include "mesh_io/file/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_set>
#include <utility>

#include "mesh_io/file/words.hpp"
#include "mesh_io/keyword/abaqus_model.hpp"
#include "mesh_io/keyword/abaqus_syntax.hpp"
#include "mesh_io/keyword/abaqus_types.hpp"
#include "mesh_io/keyword/fortran_number.hpp"
#include "mesh_io/keyword/repeated_nodes.hpp"

namespace fccda {
namespace {

using Id = NumberedMesh::Id;

constexpr std::string_view makers[] = {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYMMETRICMODELGENERATION", "IMPORT", "MANIFEST"};
constexpr std::size_t most_values = 16;  // per line; an element with more nodes continues after a full line even without a trailing comma

class AbaqusFile {
 public:
  AbaqusFile(std::string_view contents, const std::string& file) : lines_(contents, file) {}

  Elements parse() {
    bool has_keyword = false;
    while (lines_.next()) {
      if (is_abaqus_comment(lines_.line())) continue;
      if (is_abaqus_keyword(lines_.line())) {
        end_element();
        has_keyword = true;
        keyword_ = abaqus_keyword(lines_);
        start_block();
      } else if (!has_keyword && !trimmed(lines_.line()).empty()) {
        lines_.fail(shown(trimmed(lines_.line())) + " appears where a keyword such as *NODE is expected; this is not an Abaqus input file.");
      } else {
        parse_line();
      }
    }
    end_element();
    for (const auto& [is_open, what] : {std::pair{in_instance_, "*END INSTANCE"}, {in_assembly_, "*END ASSEMBLY"}, {part_ != nullptr, "*END PART"}})
      if (is_open) lines_.fail(std::string("the file ends before ") + what + "; it is truncated: export it again.");
    return mesh_of(std::move(model_), lines_);
  }

 private:
  enum class Block : std::uint8_t { skipped, nodes, elements, set, system, instance };

  AbaqusMesh& here() { return in_instance_ ? model_.instances.back().own : part_ != nullptr ? *part_ : in_assembly_ ? model_.assembly : model_.flat; }

  const std::string& required(std::string_view parameter) const {
    const std::string* value = keyword_.find(parameter);
    if (value == nullptr || value->empty()) lines_.fail("*" + excerpt(keyword_.name) + " needs " + std::string(parameter) + "=; correct the keyword.");
    return *value;
  }

  void start_block() {
    block_ = Block::skipped;
    const std::string& name = keyword_.name;
    if (name == "INCLUDE" || ((name == "NODE" || name == "ELEMENT") && keyword_.find("INPUT") != nullptr)) {
      lines_.fail("*" + name + " refers to another file, but only this one is read; insert the lines of that file here.");
    } else if (std::find(std::begin(makers), std::end(makers), name) != std::end(makers)) {
      lines_.fail("*" + name + " generates nodes or elements that are not in the file; export the mesh with all nodes and elements listed.");
    } else if (name == "NODE") {
      start_nodes();
    } else if (name == "ELEMENT") {
      start_elements();
    } else if (name == "ELSET") {
      start_set();
    } else if (name == "SYSTEM") {
      block_ = Block::system;
    } else if (name == "SURFACE") {
      check_surface();
    } else {
      open_or_close();
    }
  }

  void open_or_close() {
    const std::string& name = keyword_.name;
    const auto expect = [&](bool is_right) {
      if (!is_right) lines_.fail("*" + name + " is not allowed here; parts cannot contain parts, and instances must be inside an assembly.");
    };
    if (name == "PART") {
      expect(part_ == nullptr && !in_assembly_);
      const auto [part, is_new] = model_.parts.try_emplace(capitals(required("NAME")), required("NAME"), AbaqusMesh{});
      if (!is_new) lines_.fail("part " + excerpt(required("NAME")) + " is already defined; rename one of the two.");
      part_ = &part->second.second;
    } else if (name == "ENDPART") {
      expect(part_ != nullptr);
      part_ = nullptr;
    } else if (name == "ASSEMBLY") {
      expect(part_ == nullptr && !in_assembly_);
      in_assembly_ = model_.has_assembly = true;
    } else if (name == "ENDASSEMBLY") {
      expect(in_assembly_ && !in_instance_);
      in_assembly_ = false;
    } else if (name == "INSTANCE") {
      expect(in_assembly_ && !in_instance_);
      if (keyword_.find("INSTANCE") != nullptr || keyword_.find("LIBRARY") != nullptr)
        lines_.fail("this instance is imported from another analysis, but only this file is read; export the mesh itself.");
      if (!instances_.insert(capitals(required("NAME"))).second)
        lines_.fail("instance " + excerpt(required("NAME")) + " is already defined; rename one of the two.");
      model_.instances.push_back({required("NAME"), required("PART"), lines_.number()});
      in_instance_ = true;
      block_ = Block::instance;
      lines_of_instance_ = 0;
    } else if (name == "ENDINSTANCE") {
      expect(in_instance_);
      in_instance_ = false;
    }
  }

  /// Element-based surfaces add no geometry and are skipped; analytical surfaces (revolved or extruded lines) are refused.
  void check_surface() {
    const std::string* type = keyword_.find("TYPE");
    if (type == nullptr) return;
    const std::string kind = capitals(*type);
    if (kind == "REVOLUTION" || kind == "CYLINDER" || kind == "SEGMENTS")
      lines_.fail("*SURFACE of TYPE=" + excerpt(kind) + " is an analytical surface, which is not supported; mesh it with R3D4 or S4, or delete it.");
  }

  void start_nodes() {
    const std::string* system = keyword_.find("SYSTEM");
    if (system != nullptr && capitals(*system) != "R")
      lines_.fail("nodes in SYSTEM=" + excerpt(*system) + " are not supported, only in SYSTEM=R; export Cartesian coordinates.");
    block_ = Block::nodes;
  }

  void start_elements() {
    const std::string& name = required("TYPE");
    type_ = abaqus_type(capitals(name));
    if (type_.use == AbaqusType::Use::plane)
      lines_.fail("elements of type " + excerpt(name) + " are two-dimensional and cannot form a 3-D surface; delete them.");
    if (type_.use == AbaqusType::Use::unknown)
      lines_.fail("elements of type " + excerpt(name) + " are not supported; delete them, or export them as shells (S3, S4) or solids (C3D4 to C3D20).");
    if (type_.use == AbaqusType::Use::skipped) return;
    const std::string* set = keyword_.find("ELSET");
    group_ = set == nullptr || set->empty() ? 0 : here().group_number(*set);
    block_ = Block::elements;
  }

  void start_set() {
    const std::string &name = required("ELSET"), empty;
    const std::string* instance = keyword_.find("INSTANCE");
    const bool is_own = keyword_.find("INTERNAL") == nullptr && !name.starts_with('_');
    here().sets.push_back({name, instance != nullptr ? *instance : empty, {}, is_own});
    is_generated_ = keyword_.find("GENERATE") != nullptr;
    block_ = Block::set;
  }

  void parse_line() {
    split_abaqus_values(lines_.line(), values_);
    if (block_ == Block::instance) return parse_placement();
    if (std::all_of(values_.values.begin(), values_.values.end(), [](std::string_view value) { return value.empty(); })) return;
    switch (block_) {
      case Block::nodes:
        return parse_node();
      case Block::elements:
        return parse_element();
      case Block::set:
        return is_generated_ ? parse_generated() : parse_members();
      case Block::system:
        lines_.fail("*SYSTEM transforms the nodes that follow, which is not supported; export the coordinates in the global system.");
      default:
        return;
    }
  }

  std::string_view value(std::size_t k) const { return k < values_.values.size() ? values_.values[k] : std::string_view{}; }

  double number(std::size_t k, const std::string& what) const {
    if (value(k).empty()) return 0;
    const std::optional<double> number = fortran_real(value(k));
    if (!number) lines_.fail(what + " has " + shown(value(k)) + " where a finite number is expected; correct the file or export it again.");
    return *number;
  }

  Id positive(std::string_view word, const std::string& what, std::string_view belongs) const {
    const std::optional<Id> id = fortran_integer(word);
    if (!id || *id <= 0) lines_.fail(what + " has " + shown(word) + " where " + std::string(belongs) + " is expected; correct the file or export it again.");
    return *id;
  }

  void parse_node() {
    const Id id = positive(value(0), "*NODE", "a node number");
    const std::string name = "node " + std::to_string(id);
    const auto coordinate = [&](std::size_t k) { return number(k, name); };
    here().mesh.add_node(id, {coordinate(1), coordinate(2), coordinate(3)}, lines_.number());
  }

  void parse_element() {
    std::size_t k = 0;
    if (!is_in_element_) {
      element_ = positive(value(k++), "*ELEMENT", "an element number");
      element_name_ = "element " + std::to_string(element_);
      element_line_ = lines_.number();
      nodes_.clear();
      is_in_element_ = true;
    }
    for (; k < values_.values.size(); ++k) nodes_.push_back(positive(value(k), element_name_, "a node number"));
    if (nodes_.size() < type_.nodes && (values_.goes_on || values_.values.size() == most_values)) return;
    end_element();
  }

  void end_element() {
    if (!is_in_element_) return;
    is_in_element_ = false;
    if (nodes_.size() != type_.nodes) {
      lines_.fail_at(element_line_, element_name_ + " has " + std::to_string(nodes_.size()) + " nodes, but its type " + required("TYPE") + " needs " +
                                        std::to_string(type_.nodes) + "; correct the element.");
    }
    if (!repeats_nodes(nodes_)) return here().mesh.add_element(element_, type_.kind, nodes_, 0, group_, element_line_);
    std::optional<NumberedShape> shape;
    if (type_.kind == ElementKind::polygon) {
      shape = surface_without_repeats(nodes_);
    } else if (type_.use == AbaqusType::Use::solid && nodes_.size() <= 8) {
      shape = solid_without_repeats(nodes_);
    }
    if (!shape) lines_.fail_at(element_line_, element_name_ + " repeats nodes and does not reduce to a supported element; correct or delete it.");
    here().mesh.add_element(element_, shape->kind, shape->all(), 0, group_, element_line_);
  }

  void parse_members() {
    AbaqusSet& set = here().sets.back();
    for (const std::string_view word : values_.values) {
      if (word.empty()) continue;
      if (!fortran_integer(word)) {
        set.is_own = false;  // the entry is the name of another set
        continue;
      }
      const Id id = positive(word, "*ELSET", "an element number");
      if (!set.members.empty() && set.members.back().step == 1 && set.members.back().last == id - 1) {
        set.members.back().last = id;
      } else {
        set.members.push_back({id, id, 1});
      }
    }
  }

  void parse_generated() {
    const auto at = [&](std::size_t k) { return positive(value(k), "*ELSET", "an element number"); };
    const Id step = value(2).empty() ? 1 : positive(value(2), "*ELSET", "an increment");
    here().sets.back().members.push_back({at(0), at(1), step});
  }

  void parse_placement() {
    AbaqusInstance& instance = model_.instances.back();
    const std::string what = "instance " + instance.name;
    const auto vector = [&](std::size_t k) { return Vec3d{number(k, what), number(k + 1, what), number(k + 2, what)}; };
    const bool is_blank = std::all_of(values_.values.begin(), values_.values.end(), [](std::string_view value) { return value.empty(); });
    const int line = lines_of_instance_++;
    if (line == 0) {
      instance.translation = vector(0);
    } else if (line == 1) {
      const Vec3d from = vector(0), axis = vector(3) - from;
      const double degrees = std::remainder(number(6, what), 360.0);
      if (degrees == 0) return;
      const double length = norm(axis);
      if (!(length > 0 && std::isfinite(length))) lines_.fail(what + " is rotated about an axis defined by two equal points; correct the two points.");
      instance.axis_point = from;
      instance.turn = Quaternion::from_rotation(degrees * std::numbers::pi / 180 * (axis / length));
    } else if (!is_blank) {
      lines_.fail(what + " has a third line, but only a translation and a rotation are supported; delete it.");
    }
  }

  Lines lines_;
  AbaqusModel model_;
  AbaqusMesh* part_ = nullptr;
  std::unordered_set<std::string> instances_;  // their names, in capitals
  bool in_assembly_ = false, in_instance_ = false;

  AbaqusKeyword keyword_;
  Block block_ = Block::skipped;
  AbaqusType type_;
  int group_ = 0;
  int lines_of_instance_ = 0;
  bool is_generated_ = false;  // for the current set; cached, since it is needed for each line and a keyword may have arbitrarily many parameters

  AbaqusValues values_;
  bool is_in_element_ = false;
  Id element_ = 0;
  std::string element_name_;  // for messages
  std::size_t element_line_ = 0;
  std::vector<Id> nodes_;
};

}  // namespace

Elements parse_abaqus(std::string_view contents, const std::string& file) { return AbaqusFile(contents, file).parse(); }

}  // namespace fccda
