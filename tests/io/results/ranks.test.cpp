#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "fixtures/temporary_folder.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/ranks/in_process.hpp"

namespace perimpact {

namespace {

/// A cylinder breaks the edge of a plate, which is held at one side and loaded at another, while a block flies past; with a probe, a line and a gauge.
Setup broken_plate() {
  Setup setup;
  setup.time = {.end = 16e-6, .step = 2e-7};
  BodySetup plate = fixtures::body_setup({.size = {0.060, 0.040, 0.008}, .spacing = 0.002, .poissons_ratio = 0.3, .critical_stretch = 1e-3});
  plate.name = "plate";
  SolidSetup foot;
  foot.name = "foot";
  foot.shape = BoxSolid{{0.1, 0.009, 0.1}};
  foot.position = {0, -0.018, 0};
  plate.particle_sets = {foot};
  plate.boundary_conditions = {{"grip", FixedSetup{.particle_set = "foot"}}};
  BodySetup block = fixtures::body_setup({.size = {0.016, 0.016, 0.016}, .spacing = 0.002});
  block.name = "block";
  block.position = {0.1, 0, 0};
  block.velocity = {0, 3, 1};
  setup.bodies = {plate, block};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.02, .height = 0.03, .edge_length = 0.002};
  cylinder.mass = 0.02;
  cylinder.position = {0.003, 0.0301, 0};
  cylinder.velocity = {5, -200, 0};
  cylinder.free_dofs = {"x", "y", "rz"};
  cylinder.gauges = {{.name = "shaft", .axis = Vec3d{0, 0, 1}}};
  setup.impactors = {cylinder};
  setup.contact.impactors.friction = 0.2;
  setup.output.frames = 4;
  setup.output.history_interval = 1e-6;
  setup.output.probes = {{"centre", "plate", {0, 0, 0}}};
  setup.output.lines = {{.name = "along", .body = "plate", .from = {-0.02, 0.001, 0.001}, .to = {0.02, 0.001, 0.001}}};
  return setup;
}

struct Run {
  std::map<std::string, std::string> files;  // contents
  std::uint64_t hash = 0;
  std::vector<double> row;  // the last of the history
};

std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    files[std::filesystem::relative(entry.path(), folder).string()] = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  return files;
}

/// Runs the setup, with a checkpoint at half of the steps; or from a checkpoint, without results.
Run run(const Setup& setup, int ranks, const std::filesystem::path& folder, const std::filesystem::path& from = {}) {
  Run run;
  run_in_process(ranks, [&](Ranks& its) {
    Simulation simulation(setup, {}, its);
    const std::uint64_t at_start = fingerprint_at_start(simulation);
    std::optional<ResultsWriter> writer;
    if (from.empty())
      writer.emplace(simulation, folder);
    else
      Checkpoint(from).restore(simulation, at_start);
    while (!simulation.clock().is_finished()) {
      simulation.step();
      if (!writer) continue;
      writer->after_step(simulation);
      if (simulation.clock().step == simulation.clock().steps / 2) write_checkpoint(folder / "half.h5", simulation, at_start, writer->written());
    }
    if (writer) writer->finish(simulation, Outcome::finished, "", 0);
    const std::uint64_t hash = simulation.state_hash();
    if (its.is_root()) run.hash = hash, run.row.assign(simulation.monitors().row().begin(), simulation.monitors().row().end());
  });
  run.files = files_in(folder);
  return run;
}

}  // namespace

TEST_CASE("ranks: the results are those of one rank, byte for byte") {
  const Setup setup = broken_plate();
  const ::fixtures::TemporaryFolder folder;
  const Run one = run(setup, 1, folder / "1");
  CHECK(one.files.size() > 15);
  for (const int ranks : {2, 3, 6}) {
    CAPTURE(ranks);
    const Run other = run(setup, ranks, folder / std::to_string(ranks));
    CHECK(other.hash == one.hash);
    for (const auto& [name, contents] : one.files) {
      CAPTURE(name);
      REQUIRE(other.files.contains(name));
      if (name != "run.json" && name != "half.h5") CHECK(other.files.at(name) == contents);  // times of the clock
    }
  }
}

TEST_CASE("ranks: a checkpoint of any number of ranks resumes on any other, bitwise exactly") {
  const Setup setup = broken_plate();
  const ::fixtures::TemporaryFolder folder;
  const Run one = run(setup, 1, folder / "1");
  run(setup, 4, folder / "4");
  for (const int from : {1, 4})
    for (const int ranks : {1, 2, 5}) {
      CAPTURE(from);
      CAPTURE(ranks);
      const Run resumed = run(setup, ranks, folder / "4", folder / std::to_string(from) / "half.h5");
      CHECK(resumed.hash == one.hash);
      CHECK(resumed.row == one.row);
    }
}

}  // namespace perimpact
