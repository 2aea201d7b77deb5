#include "fccda/surface/read/read_panels.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fccda/core/error.hpp"
#include "fccda/surface/read/obj.hpp"
#include "fccda/surface/read/stl.hpp"
#include "fccda/surface/read/words.hpp"

namespace fccda {
namespace {

struct Format {
  std::string_view extension;
  Panels (*parse)(std::string_view contents, const std::string& file);
};
constexpr Format formats[] = {{".stl", parse_stl}, {".obj", parse_obj}};

/// How many letters must be put in, left out or changed to make one word of the other (Levenshtein).
std::size_t letters_apart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, changed});
    }
  }
  return row.back();
}

[[noreturn]] void refuse_format(const std::string& file, const std::string& extension) {
  std::string sentence = file + ": " + (extension.empty() ? "a file without extension" : shown(extension)) + " is no format of surfaces that can be read";
  for (const Format& format : formats) {
    constexpr std::size_t slip = 1;
    if (!extension.empty() && letters_apart(extension, format.extension) <= slip) sentence += "; did you mean `" + std::string(format.extension) + "`?";
  }
  sentence += sentence.ends_with('?') ? " The formats are" : "; the formats are";
  for (const Format& format : formats) sentence += (&format == formats ? " " : " and ") + std::string(format.extension);
  throw InputError(sentence + ".");
}

std::string contents_of(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) throw InputError(file + ": there is no such file; check the path and the folder it starts from.");
  if (!std::filesystem::is_regular_file(status)) throw InputError(file + ": this is no file but a folder or a device; give the file of the surface.");
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  std::ifstream stream(path, std::ios::binary);
  if (problem || !stream) throw InputError(file + ": the file cannot be opened; check that you may read it.");
  if (size == 0) throw InputError(file + ": the file is empty; write it again.");
  std::string contents(size, '\0');
  stream.read(contents.data(), static_cast<std::streamsize>(size));
  if (stream.gcount() != static_cast<std::streamsize>(size)) throw InputError(file + ": the file cannot be read to its end; check the disk.");
  return contents;
}

}  // namespace

Panels read_panels(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string extension = path.extension().string();
  const auto format = std::find_if(std::begin(formats), std::end(formats), [&](const Format& f) { return is_word(extension, f.extension); });
  if (format == std::end(formats)) refuse_format(file, extension);
  Panels panels = format->parse(contents_of(path), file);
  if (panels.panels.empty()) throw InputError(file + ": the file holds no triangles or faces; check what was exported.");
  return panels;
}

}  // namespace fccda
