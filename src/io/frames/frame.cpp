#include "io/frames/frame.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "io/frames/read_vtkhdf.hpp"
#include "io/frames/read_vtp.hpp"

namespace perimpact::frames {

namespace {

const FrameArray* named(const std::vector<FrameArray>& arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const FrameArray& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

}  // namespace

const FrameArray* Frame::find(std::string_view name) const { return named(arrays, name); }
const FrameArray* Frame::find_of_vertices(std::string_view name) const { return named(vertex_arrays, name); }

std::vector<output::FrameFile> frames_of(const std::filesystem::path& series) {
  if (series.extension() == ".pvd") return output::frame_files_of(series);
  std::vector<output::FrameFile> frames;
  for (const double time : times_of_vtkhdf(series)) frames.push_back({time, series, frames.size()});
  return frames;
}

Frame read_frame(const output::FrameFile& frame) { return frame.step ? read_vtkhdf(frame.file, *frame.step) : read_vtp(frame.file); }

std::vector<std::array<int, 4>> panels_of(const std::vector<std::int64_t>& corners, const std::vector<std::int64_t>& ends, std::size_t points,
                                          const std::string& where) {
  std::vector<std::array<int, 4>> panels(ends.size(), {-1, -1, -1, -1});
  std::int64_t at = 0;
  for (std::size_t panel = 0; panel < ends.size(); ++panel) {
    const std::int64_t end = ends[panel];
    if ((end - at != 3 && end - at != 4) || end > static_cast<std::int64_t>(corners.size()))
      throw fccda::InputError(where + ": a panel must have three or four corners; use the file as written by the run.");
    for (std::size_t corner = 0; at < end; ++corner, ++at) {
      const std::int64_t point = corners[static_cast<std::size_t>(at)];
      if (point < 0 || point >= static_cast<std::int64_t>(points))
        throw fccda::InputError(where + ": a panel has a corner outside the points of the file; use the file as written by the run.");
      panels[panel][corner] = static_cast<int>(point);
    }
  }
  return panels;
}

}  // namespace perimpact::frames
