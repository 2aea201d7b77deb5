// Writes what fuzzing starts from: small surfaces in every form that the tests write. fuzz_seeds FOLDER makes FOLDER/<extension>/….
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "fixtures/gmsh_files.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/polygon_files.hpp"
#include "fixtures/surface_files.hpp"

namespace {

using namespace fixtures;

class Seeds {
 public:
  explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void put(const std::string& extension, const std::string& bytes) {
    std::filesystem::create_directories(folder_ / extension);
    std::ofstream(folder_ / extension / ("seed_" + std::to_string(++count_[extension])), std::ios::binary) << bytes;
  }

 private:
  std::filesystem::path folder_;
  std::map<std::string, int> count_;
};

std::string gzip(const std::string& contents) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, contents.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(contents.data()));
  stream.avail_in = static_cast<uInt>(contents.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  Seeds seeds(arguments[1]);
  const Panels cube = unit_cube();
  seeds.put("stl", stl_text(cube));
  seeds.put("stl", stl_binary(cube));
  seeds.put("stl.gz", gzip(stl_text(cube)));
  seeds.put("stl.gz", gzip(stl_binary(tetrahedron())) + gzip("more"));
  seeds.put("obj", obj_text(cube));
  seeds.put("obj", "# parts\no hull\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0\ng bow stem\nusemtl steel\nf 1/1/1 2/2 3//3 \\\n -2 5\nf -5 -4 -3\n");
  for (const Mesh& mesh : {mesh_of(cube), angle_prism()}) {
    seeds.put("obj", obj_text(mesh));
    seeds.put("off", off_text(mesh));
    seeds.put("ply", ply_text(mesh));
    seeds.put("ply", ply_binary(mesh, std::endian::little));
    seeds.put("ply", ply_binary(mesh, std::endian::big));
    for (const bool is_grid : {false, true}) {
      for (const LegacyForm& form : legacy_forms(is_grid)) seeds.put("vtk", vtk_legacy(mesh, form));
      for (const XmlForm& form : xml_forms(is_grid)) seeds.put("vtp", vtk_xml(mesh, form));
    }
  }
  for (const GmshForm& form : every_gmsh_form()) seeds.put("msh", gmsh_file(gmsh_mesh(cube), form));
  using fccda::ElementKind;
  for (const ElementKind kind : {ElementKind::tetrahedron, ElementKind::wedge, ElementKind::hexahedron}) {
    seeds.put("inp", abaqus_text(block_of(kind, 1)));
    for (const LsdynaForm form : {LsdynaForm::fixed, LsdynaForm::commas, LsdynaForm::i10, LsdynaForm::large})
      seeds.put("k", lsdyna_text(block_of(kind, 1), form));
  }
  seeds.put("inp", abaqus_text(elements_of(cube, "hull")));
  seeds.put("inp",
            "*HEADING\n** made\n*PART, NAME=P\n" + abaqus_mesh(elements_of(tetrahedron(), "E")) +
                "*ELSET, ELSET=bow, GENERATE\n1, 3, 2\n*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=P-1, PART=P\n1., 2., 3.\n0., 0., 0., 0., 0., 1., 90.\n"
                "*END INSTANCE\n*INSTANCE, NAME=P-2, PART=P\n*END INSTANCE\n*END ASSEMBLY\n");
  seeds.put("k", lsdyna_text(elements_of(cube, "hull"), LsdynaForm::fixed));
  return 0;
}
