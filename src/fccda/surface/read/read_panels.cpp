#include "fccda/surface/read/read_panels.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fccda/core/error.hpp"
#include "fccda/core/nearest_word.hpp"
#include "fccda/surface/read/cad.hpp"
#include "fccda/surface/read/choose_parts.hpp"
#include "fccda/surface/read/contents.hpp"
#include "fccda/surface/read/elements.hpp"
#include "fccda/surface/read/gmsh.hpp"
#include "fccda/surface/read/obj.hpp"
#include "fccda/surface/read/stl.hpp"
#include "fccda/surface/read/words.hpp"

namespace fccda {
namespace {

using PanelsParser = Panels (*)(std::string_view contents, const std::string& file);
using ElementsParser = Elements (*)(std::string_view contents, const std::string& file);
using ElementsReader = Elements (*)(const std::filesystem::path& path);  // where another program reads the file

struct Format {
  std::string_view extension;
  std::variant<PanelsParser, ElementsParser, ElementsReader> parse;
};
const Format formats[] = {{".stl", parse_stl}, {".obj", parse_obj}, {".msh", parse_gmsh}, {".step", read_cad},
                          {".stp", read_cad},  {".iges", read_cad}, {".igs", read_cad}};

[[noreturn]] void refuse_format(const std::string& file, const std::string& extension) {
  std::vector<std::string> extensions;
  for (const Format& format : formats) extensions.emplace_back(format.extension);
  std::string sentence = file + ": " + (extension.empty() ? "a file without extension" : shown(extension)) + " is no format of surfaces that can be read";
  constexpr std::size_t slip = 1;
  const std::string_view meant = nearest_word(extension, extensions);
  const bool is_slip = !meant.empty() && edits_between(extension, meant) <= slip;
  sentence += is_slip ? "; did you mean `" + std::string(meant) + "`? The formats are" : "; the formats are";
  for (const std::string& one : extensions) sentence += (&one == &extensions.front() ? " " : &one == &extensions.back() ? " and " : ", ") + one;
  throw InputError(sentence + ".");
}

const Format& format_of(const std::filesystem::path& path) {
  const std::filesystem::path plain = is_gzip(path) ? path.stem() : path;
  const std::string extension = plain.extension().string();
  const auto format = std::find_if(std::begin(formats), std::end(formats), [&](const Format& f) { return is_word(extension, f.extension); });
  if (format == std::end(formats)) refuse_format(path.string(), extension);
  return *format;
}

template <class Parser>
auto parsed(Parser parse, const std::filesystem::path& path) {
  return parse(contents_of(path), path.string());
}
Elements parsed(ElementsReader read, const std::filesystem::path& path) { return read(path); }

Panels chosen(Panels panels, std::span<const std::string> parts, const std::string& file) {
  keep_parts(panels, parts, file);
  return panels;
}
Panels chosen(Elements elements, std::span<const std::string> parts, const std::string& file) {
  keep_parts(elements, parts, file);
  return panels_of(std::move(elements), file);
}

}  // namespace

Panels read_panels(const std::filesystem::path& path, std::span<const std::string> parts) {
  const std::string file = path.string();
  const Format& format = format_of(path);
  Panels panels = std::visit([&](auto parse) { return chosen(parsed(parse, path), parts, file); }, format.parse);
  if (panels.panels.empty()) throw InputError(file + ": the file holds no triangles or faces; check what was exported.");
  return panels;
}

}  // namespace fccda
