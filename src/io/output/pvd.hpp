/// A time series of output frames. ParaView opens `<name>.pvd`, which lists the files `<name>_00000.vtp`, … and their times.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/output/file_list.hpp"

namespace perimpact::output {

/// Adds frames one by one. The list is replaced atomically after each frame, so that it can be opened during the run and never lists a
/// missing file.
class Series {
 public:
  Series(std::filesystem::path folder, std::string name) : folder_(std::move(folder)), name_(std::move(name)) {}
  /// Resumes after the frames of these times [s]: the list is truncated to them, and later frames are removed.
  Series(std::filesystem::path folder, std::string name, std::vector<double> times);

  /// write_frame(path) must write the file, which is then listed with its time [s], or removed where the list cannot be written. Throws what
  /// write_frame throws, and RunError.
  template <class WriteFrame>
  void add(double time, const WriteFrame& write_frame) {
    const std::string file = frame_file(name_, times_.size());
    write_frame(folder_ / file);
    list(time, file);
  }

  const std::vector<double>& times() const { return times_; }  ///< [s] of the frames so far

 private:
  void list(double time, const std::string& file);
  void write_list() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<double> times_;
};

/// An existing frame of a series.
struct FrameFile {
  double time;  ///< [s]
  std::filesystem::path file;
  std::optional<std::size_t> step = {};  ///< in a file that contains the series

  /// "frames/plate_00003.vtp", or "frames/plate.vtkhdf, step 3".
  std::string name() const { return file.string() + (step ? ", step " + std::to_string(*step) : std::string()); }
};

/// The frames that a .pvd file of Series lists, in order. File names must not need XML escapes, which holds for names of bodies and impactors.
/// Throws InputError where the file is not such a list.
std::vector<FrameFile> frame_files_of(const std::filesystem::path& list);

}  // namespace perimpact::output
