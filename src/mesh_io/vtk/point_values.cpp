#include "mesh_io/vtk/point_values.hpp"

#include "base/error.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/file/inflate.hpp"
#include "mesh_io/file/words.hpp"
#include "mesh_io/vtk/vtk.hpp"
#include "mesh_io/vtk/vtp.hpp"

namespace fccda {

PointValues read_point_values(const std::filesystem::path& path, std::string_view array) {
  const std::string file = path.string(), extension = unpacked(path).extension().string();
  const bool is_legacy = is_word(extension, ".vtk");
  if (!is_legacy && !is_word(extension, ".vtp") && !is_word(extension, ".vtu"))
    throw InputError(file + ": " + (extension.empty() ? "a file without extension" : shown(extension)) +
                     " is not a supported point format; the formats are .vtk, .vtp and .vtu.");
  const std::string stored = contents_of(path), unpacked = is_gzip(path) ? gunzip(stored, file) : std::string();
  const std::string& contents = is_gzip(path) ? unpacked : stored;
  return is_legacy ? parse_vtk_points(contents, file, array) : parse_vtp_points(contents, file, array);
}

}  // namespace fccda
