#include "io/output/surface_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/output/file.hpp"

namespace perimpact::output {
namespace {

using fccda::Surface;
using fccda::Vec3d;

bool has_parts(const Surface& surface) { return surface.part_names().size() > 1 || !surface.part_names()[0].empty(); }

/// Calls open(part name), triangle(number)… and close(part name) for each part with triangles, in the order of the parts.
template <class Open, class Triangle, class Close>
void visit_parts(const Surface& surface, const Open& open, const Triangle& triangle, const Close& close) {
  std::vector<std::vector<std::size_t>> members(surface.part_names().size());
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    members[static_cast<std::size_t>(surface.part_of_panel(surface.triangles()[t].panel))].push_back(t);
  for (std::size_t part = 0; part < members.size(); ++part) {
    if (members[part].empty()) continue;
    open(surface.part_names()[part]);
    for (const std::size_t t : members[part]) triangle(t);
    close(surface.part_names()[part]);
  }
}

std::string stl_text(const Surface& surface) {
  std::string text;
  const auto out = std::back_inserter(text);
  visit_parts(
      surface, [&](const std::string& part) { fmt::format_to(out, "solid {}\n", part); },
      [&](std::size_t t) {
        const Vec3d& n = surface.normal(t);
        fmt::format_to(out, "facet normal {:.9g} {:.9g} {:.9g}\nouter loop\n", n.x, n.y, n.z);
        for (std::size_t c = 0; c < 3; ++c)
          fmt::format_to(out, "vertex {:.17g} {:.17g} {:.17g}\n", surface.corner(t, c).x, surface.corner(t, c).y, surface.corner(t, c).z);
        text += "endloop\nendfacet\n";
      },
      [&](const std::string& part) { fmt::format_to(out, "endsolid {}\n", part); });
  return text;
}

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string stl_binary(const Surface& surface) {
  constexpr std::size_t header_bytes = 80, triangle_bytes = 50;
  std::string bytes = "repaired by perimpact, metres";
  bytes.reserve(header_bytes + 4 + triangle_bytes * surface.triangles().size());
  bytes.resize(header_bytes, ' ');
  append(bytes, static_cast<std::uint32_t>(surface.triangles().size()));
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    for (const Vec3d& v : {surface.normal(t), surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)})
      for (std::size_t axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(v[axis]));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string obj_text(const Surface& surface) {
  std::string text = "# repaired by perimpact, metres\n";
  const auto out = std::back_inserter(text);
  for (const Vec3d& v : surface.vertices()) fmt::format_to(out, "v {:.17g} {:.17g} {:.17g}\n", v.x, v.y, v.z);
  visit_parts(
      surface,
      [&](const std::string& part) {
        if (has_parts(surface)) fmt::format_to(out, "g {}\n", part);
      },
      [&](std::size_t t) {
        const auto& v = surface.triangles()[t].vertex;
        fmt::format_to(out, "f {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1);
      },
      [](const std::string&) {});
  return text;
}

[[noreturn]] void refuse_extension(const std::filesystem::path& path) {
  throw fccda::InputError(fmt::format("{}: surfaces are written as .stl or .obj; give the file one of these extensions.", path.string()));
}

}  // namespace

void expect_surface_file(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension != ".stl" && extension != ".obj") refuse_extension(path);
  expect_place_for(path);
}

void write_surface(const std::filesystem::path& path, const Surface& surface) {
  const std::string extension = path.extension().string();
  if (extension == ".stl") return write_whole_file(path, has_parts(surface) ? stl_text(surface) : stl_binary(surface));
  if (extension == ".obj") return write_whole_file(path, obj_text(surface));
  refuse_extension(path);
}

}  // namespace perimpact::output
