#include "tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "arguments.hpp"
#include "base/error.hpp"
#include "io/deck/key_path.hpp"
#include "io/deck/overrides.hpp"
#include "mesh.hpp"
#include "words.hpp"

namespace perimpact::python {

namespace {

using deck::YamlNode;
using Surfaces = deck::SurfacesInMemory;

YamlNode word(std::string text, const std::string& place) {
  return {.kind = YamlNode::Kind::word, .place = place, .text = std::move(text), .items = {}, .entries = {}};
}

/// Recursion guard: deep nesting and self-referencing lists raise Python's RecursionError.
class Deeper {
 public:
  Deeper() {
    if (Py_EnterRecursiveCall(" in a set-up") != 0) throw py::error_already_set();
  }
  ~Deeper() { Py_LeaveRecursiveCall(); }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;
};

YamlNode tree_at(const py::handle& value, const std::string& place, Surfaces& surfaces);

YamlNode map_of(const py::dict& map, const std::string& path, const std::string& place, Surfaces& surfaces) {
  YamlNode node{.kind = YamlNode::Kind::map, .place = place, .text = {}, .items = {}, .entries = {}};
  for (const auto& [key, value] : map) {
    if (!py::isinstance<py::str>(key)) deck::refuse(place, fmt::format("{} is a key, but keys must be strings.", std::string(py::str(key))));
    const std::string name = py::cast<std::string>(key);
    const std::string inner = path.empty() ? name : path + "." + name;
    node.entries.push_back({.key = name, .place = inner, .value = tree_at(value, inner, surfaces)});
  }
  return node;
}

YamlNode list_of(const py::handle& list, const std::string& place, Surfaces& surfaces) {
  YamlNode node{.kind = YamlNode::Kind::list, .place = place, .text = {}, .items = {}, .entries = {}};
  std::size_t number = 0;
  for (const py::handle item : list) node.items.push_back(tree_at(item, fmt::format("{}[{}]", place, number++), surfaces));
  return node;
}

constexpr const char* whole = "the set-up";

YamlNode tree_at(const py::handle& value, const std::string& place, Surfaces& surfaces) {
  const Deeper deeper;
  if (value.is_none()) return {.kind = YamlNode::Kind::nothing, .place = place, .text = {}, .items = {}, .entries = {}};
  if (PyBool_Check(value.ptr())) return word(value.ptr() == Py_True ? "true" : "false", place);
  if (py::isinstance<py::str>(value)) return word(py::cast<std::string>(value), place);
  if (py::isinstance<Mesh>(value))
    return word(surfaces.emplace(value.cast<const Mesh&>().named_panels().name(), value.cast<const Mesh&>().named_panels()).first->first, place);
  if (py::isinstance<py::dict>(value)) return map_of(py::reinterpret_borrow<py::dict>(value), place == whole ? "" : place, place, surfaces);
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) return list_of(value, place, surfaces);
  if (PyFloat_Check(value.ptr())) return word(py::repr(py::float_(PyFloat_AsDouble(value.ptr()))), place);  // shortest text that reads back to the same double
  if (py::hasattr(value, "tolist")) return tree_at(value.attr("tolist")(), place, surfaces);                // NumPy arrays and scalars
  if (PyIndex_Check(value.ptr())) return word(py::str(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()))), place);
  if (py::hasattr(value, "__fspath__")) return word(py::str(value.attr("__fspath__")()), place);
  deck::refuse(place, fmt::format("this is a {}, but a set-up consists of dicts, lists, numbers, strings and meshes.",
                                  std::string(py::str(py::type::handle_of(value).attr("__name__")))));
}

}  // namespace

deck::YamlNode tree_of(const py::handle& value, const std::string& place, deck::SurfacesInMemory& surfaces) { return tree_at(value, place, surfaces); }

void change(deck::YamlNode& tree, const py::dict& changes, deck::SurfacesInMemory& surfaces) {
  for (const auto& [key, value] : changes) {
    const std::string path = name_in(key, "set", "keys of the deck, such as \"time.end\"");
    const std::vector<std::string_view> keys = deck::keys_of(path);
    if (std::find(keys.begin(), keys.end(), std::string_view()) != keys.end())
      throw fccda::InputError(fmt::format("set[\"{}\"]: a key consists of names with dots between them, such as \"time.end\".", path));
    const std::string place = std::string(deck::override_mark) + path;  // by which the reader recognises overrides
    worded([&] {
      if (py::isinstance<py::str>(value))
        deck::set_value(tree, path, std::string_view(py::cast<std::string>(value)), place);
      else
        deck::set_value(tree, path, tree_of(value, place, surfaces), place);
    });
  }
}

}  // namespace perimpact::python
