#include "mesh_io/read_panels.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "mesh_io/choose_parts.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/file/elements.hpp"
#include "mesh_io/file/inflate.hpp"
#include "mesh_io/file/words.hpp"
#include "mesh_io/gmsh/cad.hpp"
#include "mesh_io/gmsh/gmsh.hpp"
#include "mesh_io/keyword/abaqus.hpp"
#include "mesh_io/keyword/lsdyna.hpp"
#include "mesh_io/obj.hpp"
#include "mesh_io/off.hpp"
#include "mesh_io/ply.hpp"
#include "mesh_io/stl.hpp"
#include "mesh_io/vtk/vtk.hpp"
#include "mesh_io/vtk/vtp.hpp"

namespace fccda {
namespace {

using PanelsParser = Panels (*)(std::string_view contents, const std::string& file);
using ElementsParser = Elements (*)(std::string_view contents, const std::string& file);

struct Format {
  std::string_view extension;
  std::variant<PanelsParser, ElementsParser> parse;
};
const Format formats[] = {
    {".stl", parse_stl}, {".obj", parse_obj},  {".ply", parse_ply},    {".off", parse_off},  {".vtk", parse_vtk},    {".vtp", parse_vtp},
    {".vtu", parse_vtp}, {".msh", parse_gmsh}, {".inp", parse_abaqus}, {".k", parse_lsdyna}, {".key", parse_lsdyna}, {".dyn", parse_lsdyna},
};

/// Formats that an external program meshes.
constexpr std::string_view cad_extensions[] = {".step", ".stp", ".iges", ".igs"};

[[noreturn]] void refuse_format(const std::string& file, const std::string& extension) {
  std::vector<std::string> extensions;
  for (const Format& format : formats) extensions.emplace_back(format.extension);
  extensions.insert(extensions.end(), std::begin(cad_extensions), std::end(cad_extensions));
  std::string sentence = file + ": " + (extension.empty() ? "a file without extension" : shown(extension)) + " is not a supported surface format";
  constexpr std::size_t slip = 1;
  const std::string_view meant = nearest_word(extension, extensions);
  const bool is_slip = !meant.empty() && edits_between(extension, meant) <= slip;
  sentence += is_slip ? "; did you mean `" + std::string(meant) + "`? The formats are" : "; the formats are";
  for (const std::string& one : extensions) sentence += (&one == &extensions.front() ? " " : &one == &extensions.back() ? " and " : ", ") + one;
  throw InputError(sentence + ".");
}

const Format& format_of(const std::filesystem::path& file) {
  const std::string extension = unpacked(file).extension().string();
  const auto format = std::find_if(std::begin(formats), std::end(formats), [&](const Format& f) { return is_word(extension, f.extension); });
  if (format == std::end(formats)) refuse_format(file.string(), extension);
  return *format;
}

bool is_cad(const std::filesystem::path& file) {
  const std::string extension = unpacked(file).extension().string();
  return std::any_of(std::begin(cad_extensions), std::end(cad_extensions), [&](std::string_view cad) { return is_word(extension, cad); });
}

Panels chosen(Panels panels, std::span<const std::string> parts, const std::string& file) {
  keep_parts(panels, parts, file);
  return panels;
}
Panels chosen(Elements elements, std::span<const std::string> parts, const std::string& file) {
  keep_parts(elements, parts, file);
  return panels_of(std::move(elements), file);
}

Panels expect_panels(Panels panels, const std::string& file) {
  if (panels.panels.empty()) throw InputError(file + ": the file contains no triangles or faces; check the export.");
  return panels;
}

}  // namespace

Panels parse_panels(std::string_view contents, const std::filesystem::path& file, std::span<const std::string> parts) {
  const std::string name = file.string();
  const Format& format = format_of(file);
  const std::string unpacked = is_gzip(file) ? gunzip(contents, name) : std::string();
  const std::string_view bytes = is_gzip(file) ? std::string_view(unpacked) : contents;
  return expect_panels(std::visit([&](auto parse) { return chosen(parse(bytes, name), parts, name); }, format.parse), name);
}

Panels read_panels(const std::filesystem::path& path, std::span<const std::string> parts) {
  if (is_cad(path)) return expect_panels(chosen(read_cad(path), parts, path.string()), path.string());
  format_of(path);  // report an unknown format before searching for the file
  return parse_panels(contents_of(path), path, parts);
}

Elements read_elements(const std::filesystem::path& path, std::span<const std::string> parts) {
  const std::string name = path.string();
  std::string known;
  for (const Format& format : formats) {
    const auto* parse = std::get_if<ElementsParser>(&format.parse);
    if (!parse) continue;
    if (!is_word(unpacked(path).extension().string(), format.extension)) {
      known += (known.empty() ? "" : ", ") + std::string(format.extension);
      continue;
    }
    const std::string contents = contents_of(path);
    Elements elements = (*parse)(is_gzip(path) ? gunzip(contents, name) : contents, name);
    keep_parts(elements, parts, name);
    return elements;
  }
  throw InputError(name + ": this format has no cells; the mesh formats are " + known + ".");
}

}  // namespace fccda
