#include "mesh_io/gmsh/cad.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/file/words.hpp"
#include "mesh_io/gmsh/cad_program.hpp"
#include "mesh_io/gmsh/gmsh.hpp"

namespace fccda {
namespace {

constexpr double metres_per_millimetre = 0.001;
constexpr const char* panels_around_a_circle = "36";
constexpr const char* sewing_tolerance = "0.001";  // [mm]

bool is_iges(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return is_word(extension, ".igs") || is_word(extension, ".iges");
}

/// Checks the file type first, since the error of gmsh for other files gives no reason.
void check_kind(const std::filesystem::path& path) {
  const std::string file = path.string();
  if (is_gzip(path)) throw InputError(file + ": compressed CAD files are not supported; decompress the file with gunzip and give its name without .gz.");
  const std::string contents = contents_of(path);
  constexpr std::size_t letter_column = 72;  // of the 80 of each line of IGES; S: the start section
  if (is_iges(path) && (contents.size() <= letter_column || contents[letter_column] != 'S'))
    throw InputError(file + ": this is not an IGES file: its first line has no S in column 73; export it again, as STEP if possible.");
  if (!is_iges(path) && Words(contents, file).next().substr(0, 12) != "ISO-10303-21")
    throw InputError(file + ": this is not a STEP file: it does not begin with `ISO-10303-21`; export it again.");
}

/// The reason for a failure: the last error of OpenCASCADE, which is more specific, or else that of gmsh.
std::string last_error(const std::string& output) {
  constexpr std::string_view of_gmsh = "Error   : ", of_opencascade = "ERR ", stars = "****";
  std::string general, exact;
  Words words(output, "");
  for (; !words.at_end(); words.skip_line()) {
    const std::string line = words.rest_of_line();
    if (line.starts_with(of_gmsh)) general = line.substr(of_gmsh.size());
    const std::size_t begin = line.find(of_opencascade);  // between colour codes and asterisks
    if (begin == std::string::npos) continue;
    exact = line.substr(begin + of_opencascade.size());
    exact.resize(std::min(exact.find(stars), exact.size()));
    exact.resize(exact.find_last_not_of(' ') + 1);
  }
  return exact.empty() ? general : exact;
}

void check_end(const ProgramEnd& end, const std::string& file) {
  const std::string advice = "; repair the file in gmsh or another CAD program and export it again, or export STL.";
  if (end.signal == SIGINT) throw InputError(file + ": meshing with gmsh was interrupted.");
  if (end.signal != 0) throw InputError(file + ": gmsh crashed while reading or meshing this file (" + strsignal(end.signal) + ")" + advice);
  const std::string reason = last_error(end.output);
  if (end.exit_code == 0 && reason.empty()) return;
  throw InputError(file + ": gmsh cannot mesh this file" + (reason.empty() ? "" : ": " + reason) + advice);
}

/// The mesh that gmsh generates, in millimetres: OpenCASCADE, which reads the file, converts every unit to millimetres.
/// (Geometry.OCCTargetUnit would convert to metres, but fails for IGES in Gmsh 4.8.)
Elements mesh_of(const std::filesystem::path& path) {
  const std::string file = path.string();
  const TemporaryFolder folder;
  const std::string name = is_iges(path) ? "model.igs" : "model.step";  // gmsh selects the format by extension and could parse parts of other names as options
  std::error_code problem;
  std::filesystem::create_symlink(std::filesystem::absolute(path), folder / name, problem);
  if (problem) throw RunError(folder.path().string() + ": cannot write to this temporary folder: " + problem.message() + ".");
  std::vector<std::string> words{"gmsh", name, "-2", "-v", "2", "-nt", "1", "-bin", "-format", "msh41", "-o", "mesh.msh"};
  const auto set = [&](const char* option, const char* value) { words.insert(words.end(), {"-setnumber", option, value}); };
  set("Mesh.MeshSizeFromCurvature", panels_around_a_circle);
  if (is_iges(path)) {
    set("Geometry.OCCSewFaces", "1");  // IGES stores separate faces; STEP mostly stores solids, which must not be sewn together
    set("Geometry.Tolerance", sewing_tolerance);
  }
  const auto end = run_program(words, folder, {"GMSH_HOME=" + folder.path().string()});  // not with the user's own settings
  if (!end) {
    throw InputError(file +
                     ": STEP and IGES files are meshed by the program gmsh, which is not installed; install it (sudo apt-get install gmsh), "
                     "or export STL from the CAD program.");
  }
  check_end(*end, file);
  return parse_gmsh(contents_of(folder / "mesh.msh"), file);
}

}  // namespace

Elements read_cad(const std::filesystem::path& path) {
  check_kind(path);
  Elements elements = mesh_of(path);
  if (elements.size() == 0) throw InputError(path.string() + ": gmsh finds no surfaces in this file; export solids or faces, not only curves or points.");
  for (Vec3d& vertex : elements.vertices) vertex *= metres_per_millimetre;
  return elements;
}

}  // namespace fccda
