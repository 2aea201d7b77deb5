#include "mesh_io/file/contents.hpp"

#include <fstream>

#include "base/error.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {
std::string contents_of(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) throw InputError(file + ": there is no such file; check the path and the folder it is relative to.");
  if (!std::filesystem::is_regular_file(status)) throw InputError(file + ": this is a folder or a device, not a file; give the path of the surface file.");
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  std::ifstream stream(path, std::ios::binary);
  if (problem || !stream) throw InputError(file + ": the file cannot be opened; check its read permission.");
  if (size == 0) throw InputError(file + ": the file is empty; export it again.");
  std::string contents(size, '\0');
  stream.read(contents.data(), static_cast<std::streamsize>(size));
  if (stream.gcount() != static_cast<std::streamsize>(size)) throw InputError(file + ": the file cannot be read to its end; check the disk.");
  return contents;
}

bool is_gzip(const std::filesystem::path& path) { return is_word(path.extension().string(), ".gz"); }

std::filesystem::path unpacked(const std::filesystem::path& path) { return is_gzip(path) ? path.parent_path() / path.stem() : path; }

}  // namespace fccda
