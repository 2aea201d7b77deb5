#include "mesh_io/ply.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "mesh/add_polygon.hpp"
#include "mesh_io/ply_header.hpp"

namespace fccda {
namespace {

class Ply {
 public:
  Ply(std::string_view contents, const std::string& file) : file_(file), words_(contents, file), header_(parse_ply_header(words_)) {}

  Panels parse() {
    for (const PlyElement& element : header_.elements) {
      check_room(element);
      element_ = &element;
      if (element.name == "vertex") {
        parse_vertices(element);
      } else if (element.name == "face") {
        parse_faces(element);
      } else if (element.name == "tristrips" && element.count > 0) {
        fail("triangle strips (`tristrips`) are not supported in PLY; export faces.");
      } else {
        skip(element);
      }
    }
    if (!words_.at_end()) fail("there is data after the last element; a count or the file is damaged: export it again.");
    add_faces();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    if (header_.is_text()) words_.fail(sentence);
    throw InputError(file_ + ": " + sentence);
  }

  /// Name of the current element for messages.
  std::string here() const { return excerpt(element_->name) + " " + std::to_string(number_ + 1); }

  [[noreturn]] void fail_at_end() const {
    fail("the file ends in " + here() + " of " + std::to_string(element_->count) + "; it is truncated or a count is damaged: export it again.");
  }

  /// Checks a count against the file size before memory is allocated or a loop over a huge count begins.
  void check_room(const PlyElement& element) const {
    const std::size_t least = element.least_bytes(header_.is_text());
    if (least == 0 || element.count <= (words_.remaining() + 1) / least) return;  // the last number of a text may lack a trailing space
    fail("the header states " + std::to_string(element.count) + " of `" + excerpt(element.name) + "`, more than the " + std::to_string(words_.remaining()) +
         " bytes after it can hold; the file is truncated or the count is damaged: export it again.");
  }

  double number(NumberType type) {
    if (header_.is_text()) {
      const std::string_view word = words_.next();
      if (word.empty()) fail_at_end();
      return words_.number(word, here());
    }
    const std::string_view bytes = words_.bytes(size_of(type));
    if (bytes.size() < size_of(type)) fail_at_end();
    const double value = real_at(bytes.data(), type, *header_.order);
    if (!std::isfinite(value)) fail(here() + " has a number that is not finite; repair the mesh and export it again.");
    return value;
  }

  void skip_numbers(NumberType type, std::size_t count) {
    if (!header_.is_text()) {
      if (words_.remaining() / size_of(type) < count) fail_at_end();
      words_.bytes(count * size_of(type));
      return;
    }
    for (std::size_t k = 0; k < count; ++k)
      if (words_.next().empty()) fail_at_end();
  }

  std::size_t length_of_list(const PlyProperty& property) {
    const double length = number(*property.count);
    if (length < 0 || length != std::floor(length))
      fail(here() + " has a list whose count is negative or not an integer; correct the file or export it again.");
    if (length > static_cast<double>(words_.remaining())) fail_at_end();
    return static_cast<std::size_t>(length);
  }

  void skip(const PlyProperty& property) { skip_numbers(property.type, property.count ? length_of_list(property) : 1); }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (number_ = 0; number_ < element.count; ++number_)
      for (const PlyProperty& property : element.properties) skip(property);
  }

  void parse_vertices(const PlyElement& element) {
    const std::vector<PlyProperty>& properties = element.properties;
    std::size_t place[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view name = std::string_view("xyz").substr(axis, 1);
      const auto found = std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& p) { return p.name == name && !p.count; });
      if (found == properties.end()) fail("the element `vertex` has no property `" + std::string(name) + "`; export the file again with x, y and z.");
      place[axis] = static_cast<std::size_t>(found - properties.begin());
    }
    out_.vertices.reserve(element.count);
    for (number_ = 0; number_ < element.count; ++number_) {
      Vec3d vertex;
      for (std::size_t p = 0; p < properties.size(); ++p) {
        const auto axis = static_cast<std::size_t>(std::find(std::begin(place), std::end(place), p) - std::begin(place));
        axis < 3 ? void(vertex[axis] = number(properties[p].type)) : skip(properties[p]);
      }
      out_.vertices.push_back(vertex);
    }
  }

  void parse_faces(const PlyElement& element) {
    if (element.count == 0) return;
    const std::vector<PlyProperty>& properties = element.properties;
    const auto corners = std::find_if(properties.begin(), properties.end(),
                                      [](const PlyProperty& p) { return p.count && (p.name == "vertex_indices" || p.name == "vertex_index"); });
    if (corners == properties.end()) fail("the element `face` has no list `vertex_indices`; export the file again.");
    const PlyElement* vertices = header_.element("vertex");
    vertex_count_ = vertices ? vertices->count : 0;
    if (vertex_count_ > static_cast<std::size_t>(std::numeric_limits<int>::max())) fail("too many vertices; coarsen the mesh.");
    ends_.reserve(element.count);
    for (number_ = 0; number_ < element.count; ++number_)
      for (auto property = properties.begin(); property != properties.end(); ++property) property == corners ? parse_corners(*property) : skip(*property);
  }

  void parse_corners(const PlyProperty& property) {
    const std::size_t length = length_of_list(property);
    if (length < 3) fail(here() + " has " + std::to_string(length) + " vertices, but needs at least three; delete or correct it.");
    for (std::size_t k = 0; k < length; ++k) {
      const double vertex = number(property.type);
      if (vertex < 0 || vertex >= static_cast<double>(vertex_count_) || vertex != std::floor(vertex)) {
        fail(here() + " has a vertex number outside the range of the " + std::to_string(vertex_count_) +
             ", counted from 0; correct the file or export it again.");
      }
      corners_.push_back(static_cast<int>(vertex));
    }
    ends_.push_back(corners_.size());
  }

  /// Called at the end, since faces may precede the vertices that their triangulation needs.
  void add_faces() {
    std::size_t begin = 0;
    for (std::size_t f = 0; f < ends_.size(); begin = ends_[f++]) {
      const std::size_t count = ends_[f] - begin;
      if (add_polygon(out_, std::span(corners_).subspan(begin, count))) continue;
      throw InputError(file_ + ": face " + std::to_string(f + 1) + " with " + std::to_string(count) +
                       " vertices cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
    }
  }

  const std::string& file_;
  Words words_;
  PlyHeader header_;
  const PlyElement* element_ = nullptr;
  std::size_t number_ = 0;  // of the current element, from 0
  std::size_t vertex_count_ = 0;
  Panels out_;
  std::vector<int> corners_;
  std::vector<std::size_t> ends_;  // end of each face in corners_
};

}  // namespace

Panels parse_ply(std::string_view contents, const std::string& file) { return Ply(contents, file).parse(); }

}  // namespace fccda
