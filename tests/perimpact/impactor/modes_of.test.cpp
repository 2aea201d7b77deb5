#include "perimpact/impactor/modes_of.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <numbers>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;
using fccda::Panels;
using fccda::Surface;

namespace {

/// Two modes of 10 and 40 Hz with a damping ratio of 0.01 on the vertices of a block.
std::string modes_text(const Panels& panels) {
  std::ostringstream text;
  text.precision(17);
  text << "frequency [Hz], 10, 40\ndamping_ratio, 0.01\nx [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z, mode_2_x, mode_2_y, mode_2_z\n";
  for (const Vec3d& X : panels.vertices) text << X.x << ',' << X.y << ',' << X.z << ",0,0," << X.x * X.x << ",0," << X.x * X.x << ",0\n";
  return text.str();
}

struct Block {
  Panels panels = fccda::make_box({.size = {2, 1, 1}, .edge_length = 1});
  Surface surface{panels};
  fixtures::TemporaryFolder folder;
  ImpactorSetup setup{.name = "ram"};

  Block() {
    fixtures::put(folder / "modes.csv", modes_text(panels));
    setup.elastic = ElasticImpactorSetup{.modes = (folder / "modes.csv").string()};
  }

  fccda::Modes modes() const { return modes_of(setup, surface); }
  std::string complaint() const {
    try {
      modes();
    } catch (const SetupError& error) {
      return error.key() + ": " + error.what();
    }
    return "";
  }
};

}  // namespace

TEST_CASE("modes of: an impactor has the modes of the file on the vertices of its panels") {
  const Block block;
  const fccda::Modes modes = block.modes();
  REQUIRE(modes.size() == 2);
  REQUIRE(modes[1].shape.size() == block.panels.vertices.size());
  for (std::size_t v = 0; v < block.panels.vertices.size(); ++v) {
    const double x = block.panels.vertices[v].x;
    CHECK(modes[1].shape[v] == Vec3d{0, x * x, 0});
  }
  CHECK(modes[1].angular_frequency == fixtures::relative(80 * std::numbers::pi, 1e-15));  // rounding of a product
}

TEST_CASE("modes of: the damping of the deck replaces that of the file, and higher modes are left out") {
  Block block;
  CHECK(block.modes()[1].damping_ratio == 0.01);
  block.setup.elastic->damping = 0;
  CHECK(block.modes()[1].damping_ratio == 0);
  block.setup.elastic->highest_frequency = 39;
  REQUIRE(block.modes().size() == 1);
  CHECK(block.modes()[0].shape[0].z != 0);
  block.setup.elastic->highest_frequency = 9;
  CHECK(block.complaint() == "impactors.ram.elastic.highest_frequency: highest_frequency is 9 Hz, but the lowest mode of " + block.setup.elastic->modes +
                                 " has 10 Hz; raise it, or remove elastic.");
}

TEST_CASE("modes of: what is wrong with the file is said at its key") {
  Block block;
  block.surface = Surface(fccda::make_box({.size = {2, 1, 1.5}, .edge_length = 1}));
  CHECK(block.complaint().starts_with("impactors.ram.elastic.modes: " + block.setup.elastic->modes +
                                      ": vertex 0 of the surface (counted from 0), at (-1, -0.5, "));
}

TEST_CASE("modes of: a mode that only moves the impactor as its free degrees of freedom do is refused, one that moves it otherwise is not") {
  Block block;
  const Vec3d centre = block.surface.report().centroid;
  std::ostringstream text;
  text.precision(17);
  text << "frequency [Hz], 10, 1e-4\nx [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z, mode_2_x, mode_2_y, mode_2_z\n";
  for (const Vec3d& X : block.panels.vertices) {
    const Vec3d motion = Vec3d{0, 0, 0.3} + fccda::cross(Vec3d{0, 0.2, 0}, X - centre);
    text << X.x << ',' << X.y << ',' << X.z << ",0,0," << X.x * X.x << ',' << motion.x << ',' << motion.y << ',' << motion.z << '\n';
  }
  fixtures::put(block.folder / "modes.csv", text.str());
  for (const std::vector<std::string>& free : {std::vector<std::string>{}, {"x", "y", "z"}, {"z", "rx"}, {"ry"}}) {
    block.setup.free_dofs = free;
    CHECK(block.complaint() == "");
  }
  block.setup.free_dofs = {"x", "z", "ry"};
  CHECK(block.complaint() ==
        "impactors.ram.elastic.modes: " + block.setup.elastic->modes +
            ": mode_2, of 0.0001 Hz, is a rigid motion, which ram has by its free degrees of freedom (x, z, ry) already; remove the mode.");
}
