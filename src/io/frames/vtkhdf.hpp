/// A series of output frames in one file of the format VTKHDF 2.0, type PolyData, with time steps, which ParaView reads from 5.12 on.
///
/// Format: https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/
///
/// Cells and arrays marked is_constant are stored once; PartOffsets, CellOffsets and ConnectivityIdOffsets are therefore 0 in every step. Where the
/// number of points varies, each step is a part with cells of its own. All
/// other arrays grow by whole chunks with each step, shuffled and deflated, so that a step may begin a few rows behind the end of the previous
/// one: PointOffsets, PointDataOffsets and CellDataOffsets state where it begins.
///
/// A reader finds a step through the attribute NSteps of the group Steps and the length of Steps/Values. Their headers lie in the first page of
/// the file, which is written last and at once (hdf5/staged.hpp); the indices of chunks are of the kind that SWMR is built on (extensible
/// arrays), in which an entry leaves earlier ones as they are. So the file can be read after every single write: a process that is killed, or a
/// full disk, leaves all earlier steps.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/hdf5/storage.hpp"
#include "io/output/vtp.hpp"

namespace perimpact::frames {

/// Writes a file with one step into empty storage. Throws RunError, with `file`, where that fails.
void create_vtkhdf(hdf5::Storage& storage, const std::string& file, const output::PolyData& frame, double time);

/// Appends a step of the same arrays, points and cells; where these vary, only of the same arrays. Throws RunError where that fails; the file then has the
/// steps that it had.
void append_vtkhdf(hdf5::Storage& storage, const std::string& file, const output::PolyData& frame, double time);

/// Truncates a file to its first `steps`, at least one; space before the last index of chunks stays unused. Throws RunError where that fails.
void truncate_vtkhdf(hdf5::Storage& storage, const std::string& file, std::size_t steps);

/// A series that grows by steps.
class VtkhdfSeries {
 public:
  /// Starts a series, or resumes it after the steps of these times [s]; later steps are removed.
  VtkhdfSeries(std::filesystem::path file, std::vector<double> times);

  void add(const output::PolyData& frame, double time);        ///< throws RunError
  void sync() const;                                           ///< flushes everything to disk
  const std::vector<double>& times() const { return times_; }  ///< [s]

 private:
  std::filesystem::path file_;
  std::vector<double> times_;
};

}  // namespace perimpact::frames
