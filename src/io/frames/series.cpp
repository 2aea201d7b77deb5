#include "io/frames/series.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/frames/read_vtkhdf.hpp"

namespace perimpact::frames {

namespace {

std::string vtkhdf_file(const std::string& name) { return name + ".vtkhdf"; }

}  // namespace

Series::Series(const std::filesystem::path& folder, const std::string& name, FrameFormat format, std::vector<double> times)
    : series_(std::in_place_type<output::Series>, folder, name) {
  if (format == FrameFormat::vtkhdf)
    series_.emplace<VtkhdfSeries>(folder / vtkhdf_file(name), std::move(times));
  else
    series_.emplace<output::Series>(folder, name, std::move(times));
}

void Series::add(double time, const std::function<void(const Sink&)>& write_frame) {
  if (auto* const whole = std::get_if<VtkhdfSeries>(&series_)) return write_frame([&](const output::PolyData& frame) { whole->add(frame, time); });
  std::get<output::Series>(series_).add(time, [&](const std::filesystem::path& path) {
    write_frame([&](output::PolyData frame) {
      frame.time = time;
      output::write_vtp(path, frame, output::Compression::zlib);
    });
  });
}

void Series::sync() const {
  if (const auto* const whole = std::get_if<VtkhdfSeries>(&series_)) whole->sync();  // files of single frames are on disk when they have been written
}

const std::vector<double>& Series::times() const {
  return std::visit([](const auto& series) -> const std::vector<double>& { return series.times(); }, series_);
}

void Series::list(output::FileList& files, const std::string& name, FrameFormat format, std::size_t last) {
  if (format == FrameFormat::vtkhdf) return files.add("frames/" + vtkhdf_file(name));
  files.add("frames/" + name + ".pvd");
  files.add_frames("frames/" + name, last);
}

void Series::expect(const std::filesystem::path& folder, const std::string& name, FrameFormat format, std::size_t count) {
  const auto refuse = [](const std::filesystem::path& path, std::string_view fault) {
    throw fccda::InputError(fmt::format("{} {}, so the run cannot be resumed; restore it, or replace the run by a new one.", path.string(), fault));
  };
  if (count > 0 && !std::filesystem::exists(folder)) refuse(folder, "is missing");
  if (format == FrameFormat::vtkhdf) {
    const std::filesystem::path file = folder / vtkhdf_file(name);
    if (count > 0 && !std::filesystem::exists(file)) refuse(file, "is missing");
    if (count > 0 && times_of_vtkhdf(file).size() < count) refuse(file, "has fewer frames than when the checkpoint was written");
    return;
  }
  for (std::size_t frame = 0; frame < count; ++frame) {
    const std::filesystem::path file = folder / output::frame_file(name, frame);
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(file, missing);
    if (missing) refuse(file, "is missing");
    if (size == 0) refuse(file, "is shorter than when the checkpoint was written");
  }
}

}  // namespace perimpact::frames
