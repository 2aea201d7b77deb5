#include "mesh_io/obj.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/add_polygon.hpp"
#include "mesh/part_naming.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {
namespace {

/// Statements without effect on the faces.
constexpr std::string_view without_faces[] = {"vn",  "vt",     "vp",     "s",     "usemtl",   "mtllib",   "l",          "p",
                                              "lod", "maplib", "usemap", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

class Obj {
 public:
  Obj(std::string_view contents, const std::string& file) : words_(contents, file) {}

  Panels parse() {
    for (; !words_.at_end(); words_.skip_line()) {
      const std::string_view statement = words_.next_in_line();
      if (statement == "v") {
        parse_vertex();
      } else if (statement == "f") {
        parse_face();
      } else if (statement == "g" || statement == "o") {
        parts_.begin(words_.rest_of_line());
      } else if (!statement.starts_with('#') && std::find(std::begin(without_faces), std::end(without_faces), statement) == std::end(without_faces)) {
        words_.fail(shown(statement) + " is not a supported statement: surfaces need `v` and `f`; export the file as a polygon mesh.");
      }
    }
    parts_.finish();
    return std::move(out_);
  }

 private:
  void parse_vertex() {
    Vec3d vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] = words_.number(words_.next_in_line(), "vertex " + std::to_string(out_.vertices.size() + 1));
    if (out_.vertices.size() == static_cast<std::size_t>(std::numeric_limits<int>::max())) words_.fail("too many vertices; coarsen the mesh.");
    out_.vertices.push_back(vertex);
  }

  int parse_index(std::string_view word) const {
    const std::string_view digits = word.substr(0, word.find('/'));
    const auto count = static_cast<long long>(out_.vertices.size());
    long long index = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (digits.empty() || end != digits.data() + digits.size() || problem == std::errc::invalid_argument) {
      words_.fail("the face has " + shown(word) + " where a vertex number is expected.");
    }
    const long long from_zero = index > 0 ? index - 1 : count + index;
    if (problem != std::errc{} || index == 0 || from_zero < 0 || from_zero >= count) {
      words_.fail("the face has vertex " + shown(digits) + ", but there are " + std::to_string(count) +
                  " before this line, counted from 1 or back from -1; correct the numbers.");
    }
    return static_cast<int>(from_zero);
  }

  void parse_face() {
    face_.clear();
    for (std::string_view word = words_.next_in_line(); !word.empty() && !word.starts_with('#'); word = words_.next_in_line())
      face_.push_back(parse_index(word));
    if (face_.size() < 3) words_.fail("the face has " + std::to_string(face_.size()) + " vertices, but needs at least three; delete or correct it.");
    if (!add_polygon(out_, face_)) {
      words_.fail("the face with " + std::to_string(face_.size()) +
                  " vertices cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
    }
  }

  Words words_;
  Panels out_;
  PartNaming parts_{out_};
  std::vector<int> face_;
};

}  // namespace

Panels parse_obj(std::string_view contents, const std::string& file) { return Obj(contents, file).parse(); }

}  // namespace fccda
