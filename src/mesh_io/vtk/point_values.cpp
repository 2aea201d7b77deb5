#include "mesh_io/vtk/point_values.hpp"

#include "base/error.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/file/inflate.hpp"
#include "mesh_io/file/words.hpp"
#include "mesh_io/vtk/vtk.hpp"
#include "mesh_io/vtk/vtp.hpp"

namespace fccda {

namespace {

/// Calls read(contents, is_legacy) with the decompressed contents.
template <class Read>
auto with_contents(const std::filesystem::path& path, const Read& read) {
  const std::string file = path.string(), extension = unpacked(path).extension().string();
  const bool is_legacy = is_word(extension, ".vtk");
  if (!is_legacy && !is_word(extension, ".vtp") && !is_word(extension, ".vtu"))
    throw InputError(file + ": " + (extension.empty() ? "a file without extension" : shown(extension)) +
                     " is not a supported point format; the formats are .vtk, .vtp and .vtu.");
  const std::string stored = contents_of(path), unpacked = is_gzip(path) ? gunzip(stored, file) : std::string();
  return read(is_gzip(path) ? unpacked : stored, is_legacy);
}

}  // namespace

PointValues read_point_values(const std::filesystem::path& path, std::string_view array) {
  return with_contents(path, [&, file = path.string()](const std::string& contents, bool is_legacy) {
    return is_legacy ? parse_vtk_points(contents, file, array) : parse_vtp_points(contents, file, array);
  });
}

PointData read_point_arrays(const std::filesystem::path& path, const ArrayFilter& is_wanted) {
  return with_contents(path, [&, file = path.string()](const std::string& contents, bool is_legacy) {
    return is_legacy ? parse_vtk_arrays(contents, file, is_wanted) : parse_vtp_arrays(contents, file, is_wanted);
  });
}

}  // namespace fccda
