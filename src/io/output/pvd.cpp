#include "io/output/pvd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "io/output/xml.hpp"

namespace perimpact::output {

Series::Series(std::filesystem::path folder, std::string name, std::vector<double> times)
    : folder_(std::move(folder)), name_(std::move(name)), times_(std::move(times)) {
  if (!times_.empty()) write_list();
  std::error_code none_left;
  for (std::size_t frame = times_.size(); std::filesystem::remove(folder_ / frame_file(name_, frame), none_left);) ++frame;
}

void Series::write_list() const {
  std::string entries;
  for (std::size_t frame = 0; frame < times_.size(); ++frame)
    entries += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", times_[frame], xml_attribute(frame_file(name_, frame)));
  write_whole_file(folder_ / (name_ + ".pvd"),
                   "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + entries + "  </Collection>\n</VTKFile>\n");
}

void Series::list(double time, const std::string& file) {
  times_.push_back(time);
  try {
    write_list();
  } catch (...) {  // an unlisted frame would never be shown
    times_.pop_back();
    std::error_code ignored;
    std::filesystem::remove(folder_ / file, ignored);
    throw;
  }
}

std::vector<FrameFile> frame_files_of(const std::filesystem::path& list) {
  std::ifstream file(list, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto value = [&](std::size_t tag, std::string_view attribute) -> std::string_view {
    const std::size_t end = std::min(text.find('>', tag), text.size()), at = text.find(attribute, tag);
    if (at == std::string::npos || at > end) return {};
    const std::size_t first = at + attribute.size();
    return std::string_view(text).substr(first, text.find('"', first) - first);
  };
  std::vector<FrameFile> frames;
  for (std::size_t tag = 0; (tag = text.find("<DataSet ", tag)) != std::string::npos; ++tag) {
    const std::string_view time = value(tag, "timestep=\""), name = value(tag, "file=\"");
    FrameFile frame{.time = 0, .file = list.parent_path() / name};
    const auto [behind, error] = std::from_chars(time.data(), time.data() + time.size(), frame.time);
    if (error != std::errc() || behind != time.data() + time.size() || name.empty()) break;
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) throw fccda::InputError(fmt::format("{} lists no frames with their times; use the file as written by the run.", list.string()));
  return frames;
}

}  // namespace perimpact::output
