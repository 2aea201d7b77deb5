/// The series of output frames of a body or impactor, in either format.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "io/frames/vtkhdf.hpp"
#include "io/output/pvd.hpp"
#include "io/output/vtp.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::frames {

/// Takes a frame; its arrays need to exist only during the call.
using Sink = std::function<void(const output::PolyData&)>;

class Series {
 public:
  /// Resumes after the frames of these times [s], of which there are none in a new run.
  Series(const std::filesystem::path& folder, const std::string& name, FrameFormat format, std::vector<double> times = {});

  /// Adds what write_frame passes to the sink, at `time` [s]. Throws RunError where it cannot be written; earlier frames are intact.
  void add(double time, const std::function<void(const Sink&)>& write_frame);
  void sync() const;                         ///< flushes everything to disk
  const std::vector<double>& times() const;  ///< [s] of the frames so far

  /// Adds the files that a series with the frames 0 … last may write, as paths from the results folder.
  static void list(output::FileList& files, const std::string& name, FrameFormat format, std::size_t last);
  /// Checks that the series of a run to be resumed has at least `count` frames. Throws InputError where that is not so.
  static void expect(const std::filesystem::path& folder, const std::string& name, FrameFormat format, std::size_t count);

 private:
  std::variant<output::Series, VtkhdfSeries> series_;
};

}  // namespace perimpact::frames
