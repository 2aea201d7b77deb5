#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "base/parallel.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/threads.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/checkpoint/checkpoints.hpp"
#include "io/output/results_folder.hpp"
#include "io/output/vtp.hpp"
#include "io/results/particle_frame.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/elastic_modes.hpp"
#include "perimpact/ranks/in_process.hpp"

using namespace perimpact;

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

/// A strip whose window follows a guide, and an elastic ball that breaks it. The file of modes is written to the folder.
Setup moving_strip(const std::filesystem::path& folder) {
  constexpr double spacing = 1.0 / 512;
  Setup setup;
  setup.time = {.end = 6e-6, .step = 2e-7};
  BodySetup strip = fixtures::body_setup({.size = {64 * spacing, 8 * spacing, 4 * spacing}, .spacing = spacing, .critical_stretch = 4e-4});
  strip.name = "strip";
  strip.moving_window = MovingWindowSetup{.follow = "guide", .start_after = 0};
  setup.bodies = {strip};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 6 * spacing, .edge_length = spacing};
  ball.mass = 0.05;
  ball.position = {0, 0, 5 * spacing};
  ball.velocity = {0, 0, -150};
  ball.free_dofs = {"z"};
  ImpactorSetup guide = ball;
  guide.name = "guide";
  guide.position.z = 1;
  guide.velocity = {-8400, 0, 0};
  fixtures::make_elastic(ball, folder / "modes.csv");
  setup.impactors = {ball, guide};
  setup.output.frames = 6;
  setup.output.history_interval = 1e-6;
  return setup;
}

/// A tenth or so of the particles, from frame to frame others.
FrameParticlesSetup mixed_selection() {
  FrameBoxSetup upper, aside;
  upper.name = "upper", upper.lower = {-1, 0.004, -1}, upper.upper = {1, 1, 1};
  aside.name = "aside", aside.lower = {0.0959, -1, -1}, aside.upper = {1, 1, 1};  // in the block, of which some ranks own nothing there
  FrameParticlesSetup selection;
  selection.damage_above = 0.2, selection.detached = true, selection.stride = 4, selection.boxes = {upper, aside};
  return selection;
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

void expect_same_files(const Run& one, const Run& other) {
  for (const auto& [name, contents] : one.files) {
    CAPTURE(name);
    REQUIRE(other.files.contains(name));
    if (name != "run.json" && name != "half.h5") CHECK(other.files.at(name) == contents);  // times of the clock
  }
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
    expect_same_files(one, other);
  }
}

TEST_CASE("ranks: the particles of thinned frames, their numbers and fields are those of one rank for every selection, with any number of threads") {
  FrameParticlesSetup surface, stride, damaged, detached;
  surface.surface = true;
  stride.stride = 3;
  damaged.damage_above = 0.1;
  detached.detached = true;
  const std::vector<FrameParticlesSetup> selections{surface, stride, damaged, detached, mixed_selection()};
  const Setup setup = broken_plate();
  const ::fixtures::TemporaryFolder folder;
  const auto frames_of = [&](int ranks) {
    const std::filesystem::path frames = folder / std::to_string(ranks);
    std::filesystem::create_directory(frames);
    run_in_process(ranks, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      while (!simulation.clock().is_finished()) simulation.step();
      for (std::size_t k = 0; k < selections.size(); ++k)
        for (const Body& body : simulation.bodies()) {
          const Fragments fragments(body.particles, body.family);
          const FrameParticles particles(selections[k], body);
          const ParticleFrame frame(body, &fragments, setup.output.frame_fields, particles.now(body, &fragments), particles.varies());
          frame.write([&](const output::PolyData& written) {
            if (!its.is_root()) return;
            CHECK((output::count_of(written.points) > 0 || (body.name == "block" && selections[k].varies())));
            output::write_vtp(frames / (std::to_string(k) + body.name), written, output::Compression::zlib);
          });
        }
    });
    return files_in(frames);
  };
  const std::map<std::string, std::string> one = frames_of(1);
  CHECK(one.size() == 2 * selections.size());
  for (const int ranks : {2, 3, 4, 7}) {
    CAPTURE(ranks);
    const fixtures::Threads with_several(1 + ranks % 2);
    const std::map<std::string, std::string> others = frames_of(ranks);
    for (const auto& [name, contents] : one) {
      CAPTURE(name);
      CHECK(others.at(name) == contents);
    }
  }
}

TEST_CASE("ranks: a run writes the thinned frames of one rank, byte for byte, in both formats") {
  Setup setup = broken_plate();
  setup.output.frame_particles = mixed_selection();
  const ::fixtures::TemporaryFolder folder;
  for (const FrameFormat format : {FrameFormat::vtp, FrameFormat::vtkhdf}) {
    setup.output.frame_format.index = static_cast<int>(format);
    const std::string form(setup.output.frame_format.word());
    const Run one = run(setup, 1, folder / (form + "1")), four = run(setup, 4, folder / (form + "4"));
    for (const auto& [name, contents] : one.files) {
      CAPTURE(name);
      REQUIRE(four.files.contains(name));
      if (name.starts_with("frames/")) CHECK(four.files.at(name) == contents);
    }
  }
}

TEST_CASE("ranks: a box of thinned frames without particles is refused by all ranks, and one whose particles are all on one rank is not") {
  Setup setup = broken_plate();
  FrameBoxSetup box;
  box.name = "corner", box.lower = {0.026, 0.016, 0.002}, box.upper = {0.03, 0.02, 0.004};
  setup.output.frame_particles.emplace().boxes = {box};
  run_in_process(4, [&](Ranks& its) {
    const Simulation simulation(setup, {}, its);
    const std::vector<FrameParticles> particles = frame_particles_of(simulation);
    CHECK(its.sum(static_cast<std::int64_t>(particles[0].in_every_frame())) == 4);
  });
  setup.output.frame_particles->boxes[0].lower.x = 0.0311;
  setup.output.frame_particles->boxes[0].upper.x = 0.04;
  std::atomic<int> refused = 0;
  run_in_process(4, [&](Ranks& its) {
    const Simulation simulation(setup, {}, its);
    try {
      frame_particles_of(simulation);
    } catch (const SetupError& error) {
      ++refused;
      CHECK(error.key() == "output.frame_particles.boxes.corner");
    }
  });
  CHECK(refused == 4);
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

TEST_CASE("ranks: results and checkpoints of a body with a moving window under an elastic impactor are those of one rank") {
  const ::fixtures::TemporaryFolder folder;
  const Setup setup = moving_strip(folder.path());
  const Run one = run(setup, 1, folder / "1"), three = run(setup, 3, folder / "3");
  CHECK(three.hash == one.hash);
  expect_same_files(one, three);
  for (const int ranks : {1, 2, 4}) {
    CAPTURE(ranks);
    const Run resumed = run(setup, ranks, folder / "3", folder / "3" / "half.h5");
    CHECK(resumed.hash == one.hash);
    CHECK(resumed.row == one.row);
  }
}

TEST_CASE("ranks: where an array of the latest checkpoint is damaged, all ranks resume from the one before") {
  Setup setup = broken_plate();
  setup.output.checkpoints_kept = 2;
  const ::fixtures::TemporaryFolder folder;
  run_in_process(3, [&](Ranks& its) {
    Simulation simulation(setup, {}, its);
    Checkpoints checkpoints(folder.path(), simulation);
    ResultsWriter writer(simulation, folder.path());
    for (int step = 1; step <= 4; ++step) {
      simulation.step(), writer.after_step(simulation);
      if (step >= 3) checkpoints.write(simulation, writer);
    }
  });
  const std::filesystem::path latest = output::ResultsFolder::checkpoint_in(folder.path(), 0);
  std::fstream file(latest, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(latest) / 2));  // among the numbers of its largest arrays, those of bonds
  const std::string other(64, '\x5a');
  file << other << std::flush;
  for (const int ranks : {1, 3}) {
    CAPTURE(ranks);
    run_in_process(ranks, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      Checkpoints checkpoints(folder.path(), simulation);
      checkpoints.resume(simulation);
      CHECK(simulation.clock().step == 3);
      if (its.is_root()) CHECK(checkpoints.note().find("is damaged or of another run: the checksum of ") != std::string::npos);
    });
  }
}
