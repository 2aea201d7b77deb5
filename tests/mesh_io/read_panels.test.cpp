#include "mesh_io/read_panels.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/surface_files.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace fccda;

namespace {

std::string refusal(const std::filesystem::path& path) {
  try {
    read_panels(path);
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    REQUIRE(sentence.starts_with(path.string() + ":"));
    return sentence.substr(path.string().size());
  }
  return "read";
}

}  // namespace

TEST_CASE("read: the extension selects the format, in capitals too, and STL is recognised as text or binary") {
  const fixtures::TemporaryFolder folder;
  const Panels cube = fixtures::unit_cube();
  fixtures::put(folder / "a.stl", fixtures::stl_text(cube));
  fixtures::put(folder / "b.STL", fixtures::stl_binary(cube));
  fixtures::put(folder / "c.Obj", fixtures::obj_text(cube));
  fixtures::put(folder / "d.inp", fixtures::abaqus_text(fixtures::elements_of(cube, "")));
  for (const char* name : {"e.k", "f.KEY", "g.dyn"}) {
    fixtures::put(folder / name, fixtures::lsdyna_text(fixtures::elements_of(cube, ""), fixtures::LsdynaForm::fixed));
    CHECK(read_panels(folder / name).panels.size() == 6);
  }
  CHECK(read_panels(folder / "d.inp").panels.size() == 6);
  CHECK(read_panels(folder / "a.stl").panels.size() == 12);
  CHECK(read_panels(folder / "b.STL").panels.size() == 12);
  CHECK(read_panels(folder / "c.Obj").panels.size() == 6);
}

TEST_CASE("read: an unknown format is refused with the closest match") {
  const std::string formats = "formats are .stl, .obj, .ply, .off, .vtk, .vtp, .vtu, .msh, .inp, .k, .key, .dyn, .step, .stp, .iges and .igs.";
  CHECK(refusal("hull.stk") == ": `.stk` is not a supported surface format; did you mean `.stl`? The " + formats);
  CHECK(refusal("hull.obi") == ": `.obi` is not a supported surface format; did you mean `.obj`? The " + formats);
  CHECK(refusal("hull.3dm") == ": `.3dm` is not a supported surface format; the " + formats);
  CHECK(refusal("hull") == ": a file without extension is not a supported surface format; the " + formats);
}

TEST_CASE("read: missing files, empty files, folders and files without faces are refused in one sentence") {
  const fixtures::TemporaryFolder folder;
  CHECK(refusal(folder / "none.stl") == ": there is no such file; check the path and the folder it is relative to.");
  std::filesystem::create_directory(folder / "folder.stl");
  CHECK(refusal(folder / "folder.stl") == ": this is a folder or a device, not a file; give the path of the surface file.");
  fixtures::put(folder / "empty.stl", "");
  CHECK(refusal(folder / "empty.stl") == ": the file is empty; export it again.");
  fixtures::put(folder / "hollow.stl", "solid nothing\nendsolid nothing\n");
  CHECK(refusal(folder / "hollow.stl") == ": the file contains no triangles or faces; check the export.");
  fixtures::put(folder / "points.obj", "v 0 0 0\nv 1 0 0\n");
  CHECK(refusal(folder / "points.obj") == ": the file contains no triangles or faces; check the export.");
}
