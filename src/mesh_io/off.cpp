#include "mesh_io/off.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "mesh/add_polygon.hpp"
#include "mesh_io/file/whole_number.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {
namespace {

/// The first word, split around `OFF`.
struct Keyword {
  std::string_view before;  ///< ST, C, N, 4, n: the attributes of each vertex
  std::string_view behind;  ///< the vertex count where it directly follows the word
};

class Off {
 public:
  Off(std::string_view contents, const std::string& file) : words_(contents, file) {}

  Panels parse() {
    parse_counts();
    for (std::size_t v = 0; v < vertices_; ++v) parse_vertex();
    for (face_ = 1; face_ <= faces_; ++face_) parse_face();
    const std::string_view rest = first_of_line();
    if (!rest.empty())
      words_.fail(shown(rest) + " follows the last of " + std::to_string(faces_) + " faces; the count or the file is damaged: export it again.");
    return std::move(out_);
  }

 private:
  /// The first word of the next line that is not empty or a comment; empty at the end of the file.
  std::string_view first_of_line() {
    std::string_view word = words_.next();
    for (; word.starts_with('#'); word = words_.next()) words_.skip_line();
    return word;
  }

  Keyword keyword(std::string_view word) const {
    const std::size_t at = word.find("OFF");
    if (at == std::string_view::npos)
      words_.fail("an OFF file begins with `OFF`, but this one with " + shown(word) + "; the contents do not match the file extension.");
    Keyword out{word.substr(0, at), word.substr(at + 3)};
    if (out.before.find_first_of("4n") != std::string_view::npos)
      words_.fail(shown(word) + " has vertices with other than three coordinates; export the file in three dimensions.");
    std::string_view kinds = out.before;
    for (const std::string_view kind : {"ST", "C", "N"})
      if (kinds.starts_with(kind)) kinds.remove_prefix(kind.size());
    if (!kinds.empty()) words_.fail(shown(word) + " is not a supported OFF header; supported are OFF and its prefixes ST, C and N.");
    return out;
  }

  void parse_counts() {
    const std::string_view behind = keyword(first_of_line()).behind;
    std::string_view vertices = behind.empty() ? words_.next_in_line() : behind;
    if (vertices == "BINARY") words_.fail("binary OFF is not supported; export the file as text or as PLY.");
    if (vertices.empty() || vertices.starts_with('#')) words_.skip_line(), vertices = first_of_line();
    vertices_ = count_number(words_, vertices, "the count of vertices");
    faces_ = count_number(words_, words_.next_in_line(), "the count of faces");
    words_.skip_line();
    check_room(vertices_, 6, "vertices");  // bytes of "0 0 0\n"
    check_room(faces_, 8, "faces");        // of "3 0 1 2\n"
    if (vertices_ > static_cast<std::size_t>(std::numeric_limits<int>::max())) words_.fail("too many vertices; coarsen the mesh.");
    out_.vertices.reserve(vertices_);
    out_.panels.reserve(faces_);
  }

  void check_room(std::size_t count, std::size_t least, const char* what) const {
    if (count <= (words_.remaining() + 1) / least) return;  // the last line may lack a line end
    words_.fail("the header states " + std::to_string(count) + " " + what + ", more than the " + std::to_string(words_.remaining()) +
                " bytes after this line can hold; the file is truncated or the count is damaged: export it again.");
  }

  void parse_vertex() {
    const std::string vertex = "vertex " + std::to_string(out_.vertices.size() + 1);
    std::string_view word = first_of_line();
    if (word.empty()) words_.fail("the file ends before " + vertex + " of " + std::to_string(vertices_) + "; it is truncated: export it again.");
    Vec3d at;
    for (std::size_t axis = 0; axis < 3; ++axis, word = words_.next_in_line()) at[axis] = words_.number(word, vertex);
    words_.skip_line();
    out_.vertices.push_back(at);
  }

  void parse_face() {
    const std::string face = "face " + std::to_string(face_);
    const std::string_view first = first_of_line();
    if (first.empty()) words_.fail("the file ends before " + face + " of " + std::to_string(faces_) + "; it is truncated: export it again.");
    const std::size_t count = count_number(words_, first, face);
    if (count < 3) words_.fail(face + " has " + std::to_string(count) + " vertices, but needs at least three; delete or correct it.");
    corners_.clear();
    for (std::size_t k = 0; k < count; ++k) corners_.push_back(parse_corner(face));
    words_.skip_line();
    if (add_polygon(out_, corners_)) return;
    words_.fail(face + " with " + std::to_string(count) +
                " vertices cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
  }

  int parse_corner(const std::string& face) {
    const std::int64_t vertex = whole_number(words_, words_.next_in_line(), face);
    if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices_)) {
      words_.fail(face + " has vertex " + std::to_string(vertex) + ", but there are " + std::to_string(vertices_) + ", counted from 0; correct the numbers.");
    }
    return static_cast<int>(vertex);
  }

  Words words_;
  Panels out_;
  std::size_t vertices_ = 0, faces_ = 0;  // as stated in the file
  std::size_t face_ = 1;                  // current face, from 1
  std::vector<int> corners_;
};

}  // namespace

Panels parse_off(std::string_view contents, const std::string& file) { return Off(contents, file).parse(); }

}  // namespace fccda
