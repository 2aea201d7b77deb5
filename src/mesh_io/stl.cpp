#include "mesh_io/stl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "mesh/part_naming.hpp"
#include "mesh_io/file/number_type.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {
namespace {

constexpr std::size_t header_bytes = 80, count_bytes = 4, start = header_bytes + count_bytes;
constexpr std::size_t triangle_bytes = 50;  // normal, three vertices, two bytes of attributes
constexpr std::size_t normal_bytes = 12;

template <class T>
T little_endian(const char* bytes) {
  return number_at<T>(bytes, std::endian::little);
}

void add_triangle(Panels& out, const Vec3d (&corners)[3]) {
  const int first = static_cast<int>(out.vertices.size());
  out.vertices.insert(out.vertices.end(), std::begin(corners), std::end(corners));
  out.add_triangle(first, first + 1, first + 2);
}

std::uint64_t binary_count(std::string_view contents) { return little_endian<std::uint32_t>(contents.data() + header_bytes); }

bool has_binary_length(std::string_view contents) { return contents.size() >= start && contents.size() == start + triangle_bytes * binary_count(contents); }

/// Text contains no zero bytes; the triangle count of a binary file does, below 16 million triangles.
bool looks_like_text(std::string_view contents) {
  Words words(contents, "");
  return is_word(words.next(), "solid") && contents.substr(0, start).find('\0') == std::string_view::npos;
}

Panels parse_binary(std::string_view contents, const std::string& file) {
  if (contents.size() < start) {
    throw InputError(file + ": " + std::to_string(contents.size()) + " bytes are too few for an STL file, which begins with `solid` or has " +
                     std::to_string(start) + " bytes before its first triangle; export it again.");
  }
  const std::uint64_t count = binary_count(contents);
  const std::string of_count = " of " + std::to_string(count);
  const std::uint64_t needed = start + triangle_bytes * count;
  if (contents.size() < needed) {
    throw InputError(file + ": the file ends in triangle " + std::to_string((contents.size() - start) / triangle_bytes + 1) + of_count +
                     "; it is truncated or not an STL file: export it again.");
  }
  if (contents.size() > needed) {
    throw InputError(file + ": " + std::to_string(contents.size() - needed) + " bytes follow the last" + of_count +
                     " triangles; the count or the file is damaged: export it again.");
  }
  if (3 * count > std::numeric_limits<int>::max()) throw InputError(file + ": " + std::to_string(count) + " triangles are too many; coarsen the mesh.");

  Panels out;
  out.vertices.reserve(3 * count);
  out.panels.reserve(count);
  for (std::uint64_t t = 0; t < count; ++t) {
    const char* at = contents.data() + start + t * triangle_bytes + normal_bytes;
    Vec3d corners[3];
    for (Vec3d& corner : corners) {
      corner = {little_endian<float>(at), little_endian<float>(at + 4), little_endian<float>(at + 8)};
      at += 12;
      if (!is_finite(corner)) {
        throw InputError(file + ": triangle " + std::to_string(t + 1) + of_count +
                         " has a coordinate that is not a finite number; repair the mesh and export it again.");
      }
    }
    add_triangle(out, corners);
  }
  return out;
}

class TextStl {
 public:
  TextStl(std::string_view contents, const std::string& file) : words_(contents, file) {}

  Panels parse() {
    while (!words_.at_end()) {
      expect("solid");
      parts_.begin(words_.rest_of_line());
      words_.skip_line();
      for (;;) {
        const std::string_view word = words_.next();
        if (is_word(word, "endsolid")) break;
        if (word.empty())
          words_.fail("the file ends after " + std::to_string(out_.panels.size()) + " triangles without `endsolid`; it is truncated: export it again.");
        if (!is_word(word, "facet"))
          words_.fail(shown(word) + " follows " + std::to_string(out_.panels.size()) + " triangles, where `facet` or `endsolid` is expected.");
        parse_facet();
      }
      words_.skip_line();
    }
    parts_.finish();
    return std::move(out_);
  }

 private:
  std::string triangle() const { return "triangle " + std::to_string(out_.panels.size() + 1); }

  void expect(std::string_view keyword) {
    const std::string_view word = words_.next();
    if (is_word(word, keyword)) return;
    if (word.empty()) words_.fail("the file ends in " + triangle() + "; it is truncated: export it again.");
    words_.fail(triangle() + " has " + shown(word) + " where `" + std::string(keyword) + "` is expected.");
  }

  void parse_facet() {
    expect("normal");
    for (int k = 0; k < 3; ++k) words_.next();
    expect("outer");
    expect("loop");
    Vec3d corners[3];
    const std::string what = triangle();
    for (Vec3d& corner : corners) {
      expect("vertex");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (words_.at_end()) expect("vertex coordinate");
        corner[axis] = words_.number(words_.next(), what);
      }
    }
    expect("endloop");
    expect("endfacet");
    if (out_.vertices.size() > std::numeric_limits<int>::max() - 3) words_.fail("too many triangles; coarsen the mesh.");
    add_triangle(out_, corners);
  }

  Words words_;
  Panels out_;
  PartNaming parts_{out_};
};

}  // namespace

Panels parse_stl(std::string_view contents, const std::string& file) {
  const bool is_text = !has_binary_length(contents) && looks_like_text(contents);
  return is_text ? TextStl(contents, file).parse() : parse_binary(contents, file);
}

}  // namespace fccda
