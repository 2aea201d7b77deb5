#include "mesh_io/gmsh/cad.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

#include "base/error.hpp"
#include "fixtures/gmsh_files.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/temporary_folder.hpp"
#include "mesh_io/read_panels.hpp"

using namespace fccda;

// A script stands in for gmsh; the real program is tested in tests/cli/formats.test.py.

namespace {

class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name), before_(std::getenv(name) == nullptr ? "" : std::getenv(name)) {
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { before_.empty() ? unsetenv(name_) : setenv(name_, before_.c_str(), 1); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::string before_;
};

/// A folder with a program `gmsh` in it, and another one for temporary files, which must be empty at the end.
class Scene {
 public:
  explicit Scene(const std::string& script) {
    fixtures::put(folder_ / "bin/gmsh", "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder_ / "bin/gmsh", std::filesystem::perms::owner_all);
    std::filesystem::create_directory(folder_ / "tmp");
    fixtures::put(folder_ / "bin/cube.msh", gmsh_file(fixtures::gmsh_mesh(fixtures::unit_cube()), {41, true}));
    fixtures::put(part(), "ISO-10303-21;\n");
  }
  std::filesystem::path part() const { return folder_ / "part.step"; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

  std::string refusal(const std::string& name = "part.step") const {
    std::string sentence;
    try {
      read(name);
    } catch (const InputError& error) {
      sentence = error.what();
    }
    CHECK(std::filesystem::is_empty(folder_ / "tmp"));
    const std::string file = (folder_ / name).string();
    REQUIRE(sentence.starts_with(file + ": "));
    return sentence.substr(file.size() + 2);
  }

  Panels read(const std::string& name = "part.step") const {
    const Variable of_the_user("GMSH_HOME", "/where/the/user/keeps/settings");
    const Variable path("PATH", (folder_ / "bin").string() + ":/usr/bin:/bin");
    const Variable temporary("TMPDIR", (folder_ / "tmp").string());
    return read_panels(folder_ / name);
  }

 private:
  fixtures::TemporaryFolder folder_;
};

const std::string copy_cube = "cp \"$(dirname \"$0\")\"/cube.msh mesh.msh\n";
const std::string advice = "; repair the file in gmsh or another CAD program and export it again, or export STL.";

}  // namespace

TEST_CASE("cad: the mesh of the program is read in metres, and no temporary files remain") {
  const Scene scene(copy_cube);
  Panels expected = fixtures::moved(fixtures::unit_cube(), [](Vec3d v) { return v *= 0.001; });
  const Panels read = scene.read();
  CHECK(read.vertices == expected.vertices);
  CHECK(read.panels == expected.panels);
  CHECK(read.part_names == std::vector<std::string>{"surface 1"});
  CHECK(std::filesystem::is_empty(scene / "tmp"));
}

TEST_CASE("cad: the program gets the file under a harmless name, no input, and neither a shell nor the user's settings") {
  // `read` fails at once without input
  const Scene scene(
      "read line && exit 3\n[ \"$GMSH_HOME\" = \"$PWD\" ] || exit 4\ncase $1 in\nmodel.step) grep -q ISO model.step || exit 5;;\nmodel.igs) ;;\n*) exit "
      "6;;\nesac\n" +
      copy_cube);
  for (const char* name : {"two words.stp", "-o.STEP", "quote' \"$(exit).step", "*.Stp", "\xC3\xA9t\xC3\xA9.step"}) {
    CAPTURE(name);
    fixtures::put(scene / name, "ISO-10303-21;\n");
    CHECK(scene.read(name).panels.size() == 6);
  }
  fixtures::put(scene / "part.IGES", std::string(72, ' ') + "S      1\n");
  CHECK(scene.read("part.IGES").panels.size() == 6);
}

TEST_CASE("cad: the message gives the reason of the failure") {
  CHECK(Scene("echo Error   : first; echo 'Error   : Could not read' >&2; echo done; exit 1").refusal() ==
        "gmsh cannot mesh this file: Could not read" + advice);
  CHECK(Scene("exit 7").refusal() == "gmsh cannot mesh this file" + advice);
  CHECK(Scene("echo 'Error   : no face 3'\n" + copy_cube).refusal() == "gmsh cannot mesh this file: no face 3" + advice);  // gmsh continues, with a hole
  CHECK(Scene("printf '\\033[31;1m**** ERR StepFile : Line 72: bad    ****\\033[0m\\n'; echo 'Error   : Could not read'; exit 1").refusal() ==
        "gmsh cannot mesh this file: StepFile : Line 72: bad" + advice);
  CHECK(Scene("kill -SEGV $$").refusal() == "gmsh crashed while reading or meshing this file (Segmentation fault)" + advice);
  CHECK(Scene("kill -INT $$").refusal() == "meshing with gmsh was interrupted.");
}

TEST_CASE("cad: long program output is read to its end") {
  CHECK(Scene("yes 'Info    : meshing' | head -n 50000; echo 'Error   : at last'; exit 1").refusal() == "gmsh cannot mesh this file: at last" + advice);
}

TEST_CASE("cad: a mesh without surfaces, or none at all, is refused") {
  Scene scene(copy_cube);
  fixtures::GmshMesh points;
  points.vertices = {{0, 0, 0}};
  points.elements = {{15, {0}}};
  fixtures::put(scene / "bin/cube.msh", gmsh_file(points));
  CHECK(scene.refusal() == "gmsh finds no surfaces in this file; export solids or faces, not only curves or points.");
  CHECK_THROWS_AS(Scene("exit 0").read(), InputError);
}

TEST_CASE("cad: without the program the message says how to install it, and other files are refused before it runs") {
  const Scene scene("exit 1");
  std::filesystem::remove(scene / "bin/gmsh");
  {
    const Variable path("PATH", (scene / "bin").string());
    const Variable temporary("TMPDIR", (scene / "tmp").string());
    CHECK_THROWS_WITH_AS(
        read_cad(scene.part()),
        (scene.part().string() + ": STEP and IGES files are meshed by the program gmsh, which is not installed; install it (sudo apt-get install gmsh), "
                                 "or export STL from the CAD program.")
            .c_str(),
        InputError);
    CHECK(std::filesystem::is_empty(scene / "tmp"));
  }
  fixtures::put(scene / "hull.stp", "solid hull\n");
  fixtures::put(scene / "hull.igs", "solid hull\n");
  fixtures::put(scene / "hull.step.gz", "any bytes");
  CHECK(scene.refusal("hull.stp") == "this is not a STEP file: it does not begin with `ISO-10303-21`; export it again.");
  CHECK(scene.refusal("hull.igs") == "this is not an IGES file: its first line has no S in column 73; export it again, as STEP if possible.");
  CHECK(scene.refusal("hull.step.gz") == "compressed CAD files are not supported; decompress the file with gunzip and give its name without .gz.");
  CHECK(scene.refusal("none.iges") == "there is no such file; check the path and the folder it is relative to.");
}
